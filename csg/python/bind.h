// What the parts of the extension `_cnrg` share. Each `bind_...` adds one part of it to the module.
//
// Python holds a tree, an evaluation and a result by shared pointers, so that whichever object is kept keeps alive
// what it shows.
#pragma once

#include <cnrg.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string>

namespace cnrg::python {

namespace py = pybind11;

/// A tree, and the text that it was read from.
struct TreeObject {
  std::shared_ptr<const Tree> tree;
  std::string text;
};

/// A tree that was evaluated. Nothing in it changes.
struct EvaluatedTree {
  std::shared_ptr<const Tree> tree;
  Evaluation evaluation;
};

/// A result, and where it came from: for questions that take the whole tree, such as why a cell is there.
struct OneResult {
  Result result;
  std::shared_ptr<const EvaluatedTree> from;  ///< null: it was read from a file, or made from another result
  NodeId node;                                ///< of the tree
};

/// A result that is a leaf of trees, without a file.
struct ResultLeaf {
  Result result;
  std::shared_ptr<const PreparedLeaf> leaf;
};

/// The classes of cnrg/errors.py for exceptions of the library.
void bind_errors(py::module_& module);
void bind_numbers(py::module_& module);
void bind_tree(py::module_& module);
void bind_evaluation(py::module_& module);
void bind_result(py::module_& module);

}  // namespace cnrg::python
