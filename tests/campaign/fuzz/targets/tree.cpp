// A tree file as a text. Files that it names are replaced by one that is not there: readers of files have targets
// of their own, and what a fuzzer makes up might be the name of a device.
#include "tests/campaign/fuzz/targets.h"
#include "tests/campaign/fuzz/targets/small.h"

namespace cnrg::fuzz {

void run_tree(std::string_view bytes) {
  accept_errors([&] {
    Tree tree = parse_tree(std::string(bytes), folder().path("tree.yaml"));
    for (Node& node : tree.nodes) {
      if (!node.shape) continue;
      std::visit(
          [](auto& shape) {
            if constexpr (requires { shape.file; }) {
              if (!shape.file.empty()) shape.file = folder().path("absent");
            }
          },
          *node.shape);
    }
    make_coarse(tree);
    evaluate_small(tree);
  });
}

}  // namespace cnrg::fuzz
