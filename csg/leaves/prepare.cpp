// Which function prepares which shape.
#include "csg/leaves/parameters.h"
#include "csg/leaves/prepare_shapes.h"

namespace cnrg {
namespace {

std::unique_ptr<PreparedLeaf> made(const ResultShape& shape) { return prepare_result(shape); }

/// A shape with parameters is kept: when someone asks for them, the leaf is made once more, with a record of them.
template <class S>
std::unique_ptr<PreparedLeaf> made(const S& shape) {
  if constexpr (requires { prepare_leaf(shape); }) {
    return prepare_leaf(shape);
  } else {
    std::unique_ptr<PreparedLeaf> leaf = prepare_leaf(shape, nullptr);
    const auto kept = std::make_shared<const S>(shape);
    leaf->set_parameters([kept] {
      auto parameters = std::make_shared<LeafParameters>();
      prepare_leaf(*kept, parameters.get());
      return parameters;
    });
    leaf->set_surfaces([kept] { return true_surfaces(*kept); });
    return leaf;
  }
}

}  // namespace

std::shared_ptr<const PreparedLeaf> prepare(const Shape& shape) {
  const auto* const result = std::get_if<ResultShape>(&shape);
  if (result != nullptr && result->in_memory != nullptr) return result->in_memory;
  return std::visit([](const auto& of) { return made(of); }, shape);
}

}  // namespace cnrg
