// Pictures and pages of a result.
#include <pybind11/stl.h>

#include "csg/tree/dag.h"
#include "results.h"
#include "views.h"
#include "watched.h"

namespace cnrg::python {
namespace {

py::bytes picture_of(const OneResult& r, const std::string& extension, const PictureOptions& options, int threads,
                     const py::object& progress) {
  const bool ghosts = check_picture_options(options);
  return py::bytes(apart(progress, [r, extension, options, threads, ghosts](const Watch& watch) {
    if (!ghosts || r.from == nullptr) return picture(extension, r.result, options, threads);
    EvaluateOptions all;
    all.threads = threads;
    all.rows = Rows::none;
    all.keep_all = true;
    all.result = r.node;
    all.watch = watch;
    const Evaluation evaluation = evaluate(*r.from->tree, all);
    return picture(extension, *r.from->tree, evaluation, r.node, options, threads);
  }));
}

py::str page_of(const OneResult& r, const std::string& page_template, const std::string& title, int threads,
                const py::object& progress) {
  if (r.from == nullptr) {
    throw InputError(
        "a page shows the tree that a result comes from, and this one was snapped or read from a file");
  }
  return text_of(apart(progress, [r, page_template, title, threads](const Watch& watch) {
    const Tree& tree = *r.from->tree;
    EvaluateOptions options;
    options.threads = threads;
    options.keep_all = true;
    const std::vector<char> below = tree.dag->reachable({tree.result, r.node});
    for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
      if (below[id.index()]) options.nodes.push_back(id);
    }
    options.watch = watch;
    const Evaluation evaluation = evaluate(tree, options);
    watch.begin("page");
    return page_text(page_template, title, page_data(tree, evaluation));
  }));
}

}  // namespace

void bind_result_pictures(py::module_& module) {
  module.def("picture", &picture_of, py::arg("result"), py::arg("extension"), py::arg("options"),
             py::arg("threads"), py::arg("progress"));
  module.def("page", &page_of, py::arg("result"), py::arg("template"), py::arg("title"), py::arg("threads"),
             py::arg("progress"));
}

}  // namespace cnrg::python
