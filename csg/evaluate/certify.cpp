// Uncertain places in words.
#include "csg/evaluate/certify.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "csg/evaluate/diagnostics.h"
#include "csg/evaluate/leaf_numbers.h"
#include "csg/evaluate/transversality.h"
#include "csg/tree/unfold.h"

namespace cnrg {
namespace {

std::string coordinates(const std::array<double, 3>& p) {
  std::string text;
  for (const double x : p) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", std::abs(x) < 1e-9 ? 0.0 : x);
    text += (text.empty() ? "" : ", ") + std::string(buffer);
  }
  return "[" + text + "]";
}

/// Of the nodes kept on one complex.
Certificate certify_kept(const Tree& tree, const Evaluation& evaluation, std::size_t listed, bool at_vertices) {
  const auto asked = [&](EdgeId e) {
    return std::any_of(evaluation.kept.begin(), evaluation.kept.end(), [&](const KeptValue& kept) {
      return kept.simplified->edge_place[e.index()].dimension == 1;
    });
  };
  const Transversality found =
      transversality(*evaluation.complex, *evaluation.parameters, listed, asked, at_vertices);
  Certificate result{found.edges, found.places.size(), {}};
  for (std::size_t i = 0; i < std::min(listed, found.places.size()); ++i) {
    const UncertainPlace& place = found.places[i];
    const auto name = [&](std::size_t side) {
      const std::string patch = evaluation.parameters->patch_name(place.leaves[side], place.patches[side]);
      return "`" + evaluation.leaf_names[place.leaves[side].index()] + "`" +
             (patch.empty() ? "" : " (" + patch + ")");
    };
    std::string text = name(0) + " and " + name(1) + " meet near " + coordinates(place.at) + ": ";
    text += place.finer > 0
                ? "these facets do not tell how; --finer " + std::to_string(place.finer) + " would"
                : "they touch, or cross at an angle that facets 1024 times finer would not tell from 0";
    const Node& node = tree.nodes[evaluation.leaves->node_of(place.leaves[0])];
    result.notices.push_back({tree.file, node.operator_at, Diagnostic::Level::notice, text});
  }
  return result;
}

}  // namespace

Certificate certify(const Tree& tree, const Evaluation& evaluation, std::size_t listed, bool at_vertices) {
  Certificate result = certify_kept(tree, evaluation, listed, at_vertices);
  for (const Evaluation& other : evaluation.others) {
    Certificate more = certify_kept(tree, other, listed, at_vertices);
    result.edges += more.edges;
    result.places += more.places;
    append(result.notices, std::move(more.notices));
  }
  if (result.notices.size() > listed) result.notices.erase(result.notices.begin() + listed, result.notices.end());
  return result;
}

}  // namespace cnrg
