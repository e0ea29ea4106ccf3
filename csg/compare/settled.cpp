// The result goes through a file without a name, since results are read back from files.
#include "csg/compare/settled.h"

#include "csg/evaluate/evaluate.h"
#include "csg/formats/formats.h"
#include "csg/leaves/leaf.h"
#include "csg/result/result_data.h"
#include "csg/tree/tree_of_file.h"

namespace cnrg {

Settled::Settled(const Tree& tree, NodeId node, int threads) : file_("cnrg compare") {
  EvaluateOptions options;
  options.threads = threads;
  options.rows = Rows::none;
  options.result = node;
  const Result result = evaluate(tree, options).result();
  const std::string text = json_text(result.data().view()).text;
  file_.write(text.data(), text.size());
  const ResultShape shape{"/proc/self/fd/" + std::to_string(file_.descriptor())};
  try {
    prepare(shape);
  } catch (const InputError&) {
    throw TreeError(tree.file, tree.weld_at,
                    "a result of a tree with `weld` is compared as it is in a `.json`, and `" +
                        tree.nodes[node].name +
                        "` has faces or lines without bounds, which cannot be read back; "
                        "cut it with a box");
  }
  tree_ = tree_of_leaf(tree.file, tree.nodes[node].name, "cnrg", shape);
}

}  // namespace cnrg
