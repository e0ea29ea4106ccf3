// Every shape with counts of segments, or with a tessellation, is curved but for `disk`, a polygon; no other shape
// has either.
#include <algorithm>
#include <cstdint>

#include "csg/curves/boundary_curves.h"
#include "csg/tree/tree.h"

namespace cnrg {
namespace {

class Finer {
 public:
  Finer(const std::string& file, const Node& node, int times) : file_(file), node_(node), times_(times) {}

  template <class S>
  void operator()(S& shape) const {
    if constexpr (requires { shape.rings; }) {
      if constexpr (std::is_same_v<S, SphereShape>) {
        if (shape.rings == 0) shape.rings = std::max(2, shape.segments / 2);
      }
      multiply(shape.rings, "rings", Fineness::kMostSegments);
    }
    if constexpr (requires { shape.segments; } && !std::is_same_v<S, DiskShape>)
      multiply(shape.segments, "segments", Fineness::kMostSegments);
    if constexpr (requires { shape.tessellation; }) {
      Tessellation& t = shape.tessellation;
      if (t.chord) {
        *t.chord /= Rational(times_) * times_;
      } else {
        if (!t.segments) t.segments = Fineness::kUsualSegments;
        multiply(*t.segments, "segments", Fineness::kMostSegments);
      }
    }
  }

 private:
  const std::string& file_;
  const Node& node_;
  const int times_;

  void multiply(int& count, const char* what, std::int64_t most) const {
    const std::int64_t product = static_cast<std::int64_t>(count) * times_;
    if (product > most) {
      throw TreeError(file_, node_.operator_at,
                      "made " + std::to_string(times_) + " times finer, `" + node_.operator_name +
                          "` would have " + std::to_string(product) + " " + what + ", more than " +
                          std::to_string(most) + "; make it less fine, or give it fewer " + what);
    }
    count = static_cast<int>(product);
  }
};

}  // namespace

void make_finer(Tree& tree, int times) {
  if (times < 1) throw InputError("finer: give 1 or more, not " + std::to_string(times));
  if (times == 1) return;
  for (Node& node : tree.nodes) {
    if (node.shape) std::visit(Finer(tree.file, node, times), *node.shape);
  }
}

}  // namespace cnrg
