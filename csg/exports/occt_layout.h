// Which edges, vertices and loops the faces of a CAD model have: all of it but curves. Knows OpenCASCADE's types.
//
// Edges of a result are cut into pieces where a CAD model needs a vertex and the result has none: where a seam
// ends, and somewhere on each edge that is closed. Each piece is one edge of the model, whoever uses it.
#pragma once

#include <deque>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "csg/exports/occt_chart.h"
#include "csg/exports/unrolled.h"

namespace cnrg::occt {

/// Faces that are to be what their facets are, with the reason.
using Faceted = std::map<CadParts::Index, std::string>;

struct Piece {
  using Index = CadParts::Index;
  std::vector<Index> points;         ///< from end to end, also of a closed one
  std::vector<const Chart*> charts;  ///< that it lies on, each once
  bool seam = false;                 ///< and no edge of the result
  std::optional<Index> edge;         ///< of the result
  std::vector<double> at;            ///< as of CadParts::Edge
  bool closed() const { return points.front() == points.back(); }
};

struct PieceUse {
  CadParts::Index piece = 0;
  bool forward = true;
  std::vector<UnrollCorner> corners;  ///< in the parameters of the face, as it is run through
};

struct LaidFace {
  using Index = CadParts::Index;
  Index source = 0;  ///< number of the face of the result
  const Chart* chart = nullptr;
  bool same = true;                          ///< the front of the face is the side of S_u x S_v
  std::vector<std::vector<PieceUse>> loops;  ///< with the face to the left as seen from its front
  std::vector<PieceUse> inner;               ///< inside of it, each once
  std::vector<Index> isolated;               ///< points inside of it
};

class CadLayout {
 public:
  using Index = CadParts::Index;
  /// `faceted`: faces to take as their facets; faces that cannot be laid out are added to `failed`, and then
  /// nothing else counts.
  CadLayout(const CadParts& parts, const Faceted& faceted, Faceted& failed);

  const std::vector<LaidFace>& faces() const { return faces_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// Charts that meet in a point; empty for points that are no vertices.
  const std::vector<const Chart*>& charts_at(Index point) const { return charts_at_[point]; }
  bool is_vertex(Index point) const { return vertex_[point] != 0; }
  /// The pieces of an edge of the result.
  const std::vector<Index>& pieces_of(Index edge) const { return pieces_of_[edge]; }
  std::optional<CadParameters> near(const Chart* chart, Index point) const;

 private:
  const CadParts& parts_;
  const Faceted& faceted_;
  Faceted& failed_;
  std::deque<Chart> charts_;
  std::map<Index, const Chart*> chart_of_;  // by number of the surface
  std::vector<LaidFace> faces_;
  std::vector<Unrolled> unrolled_;  // parallel to it
  std::vector<char> vertex_;
  std::vector<std::vector<const Chart*>> charts_at_;
  std::map<std::pair<const Chart*, Index>, CadParameters> near_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<Index>> pieces_of_;
  struct Chain {
    std::vector<Index> points;  // a closed one repeats the first
    std::optional<Index> edge;
    bool seam = false;
  };
  std::vector<Chain> chains_;
  std::map<std::array<Index, 2>, std::pair<Index, bool>>
      piece_at_;                          // by side: its piece, and if that runs forward
  std::set<std::array<Index, 2>> sides_;  // of edges, both ways

  const Chart* chart_of_surface(Index surface);
  void lay_face(Index source);
  void lay_facets(Index source);
  void add_face(Index source, const Chart* chart, std::vector<const CadParts::Facet*> facets,
                std::span<const Index> isolated);
  void add_edges();
  void add_seams();
  void cut_chains();
  void add_uses(std::size_t face);
  void find_charts();
};

}  // namespace cnrg::occt
