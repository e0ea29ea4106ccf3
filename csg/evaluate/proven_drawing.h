// The drawing of the leaves of a run, and a proof that their surfaces meet as the facets do (csg/certify/proof.h).
//
// Where facets are too coarse for the proof they get further lines there, over and over. So the facets of a leaf
// depend on what it meets; it costs only where surfaces are nearer to a contact than facets are to surfaces.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "csg/certify/certificate.h"
#include "csg/certify/proof.h"
#include "csg/evaluate/drawings.h"
#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/leaf_lines.h"

namespace cnrg {

class ProvenDrawing {
 public:
  /// As `options` say. All that is given must outlive this. Throws as `Drawings`.
  ProvenDrawing(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves,
                const EvaluateOptions& options);

  Drawings& drawings() { return *drawings_; }
  const std::shared_ptr<const LeafLines>& lines() const { return lines_; }
  std::vector<Diagnostic> take_diagnostics() { return std::move(diagnostics_); }
  /// Null if nothing was asked. `evaluation` has the names.
  std::shared_ptr<const Certificate> certificate(const Evaluation& evaluation) const;

 private:
  void draw();
  void prove_it();
  /// False if there is nothing to add.
  bool add_lines();

  const Tree& tree_;
  const Unfolding& unfolding_;
  const PreparedLeaves& leaves_;
  const EvaluateOptions& options_;
  std::shared_ptr<const LeafLines> lines_;
  std::unique_ptr<Drawings> drawings_;
  std::vector<Diagnostic> diagnostics_;
  Moulds moulds_;
  std::size_t steps_ = 0;  // of all proofs so far
  std::unique_ptr<Pieces> pieces_;
  std::optional<Proof> proof_;
};

}  // namespace cnrg
