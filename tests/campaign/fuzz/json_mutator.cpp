// Mutation of JSON by its structure, for results and for trees, which may be JSON. Changed bytes are mostly no
// JSON any more; here numbers become others, parts are left out, doubled, exchanged, or put in the place of other
// parts, so that most of what comes out is a file that contradicts itself in one place. Every other time bytes are
// changed all the same.
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using Json = nlohmann::json;

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  void mutate(Json& document) {
    for (std::size_t i = below(3); i < 3; ++i) {
      std::vector<Json*> nodes;
      collect(document, nodes);
      change(*nodes[below(nodes.size())], *nodes[below(nodes.size())]);
    }
  }

 private:
  std::minstd_rand random_;

  std::size_t below(std::size_t n) { return random_() % n; }

  static void collect(Json& node, std::vector<Json*>& nodes) {
    nodes.push_back(&node);
    if (node.is_structured()) {
      for (Json& part : node) collect(part, nodes);
    }
  }

  void change(Json& node, const Json& other) {
    if (below(4) == 0) {
      node = Json(other);
    } else if (node.is_array() && !node.empty()) {
      change_list(node);
    } else if (node.is_object() && !node.empty()) {
      node.erase(std::next(node.begin(), static_cast<std::ptrdiff_t>(below(node.size()))));
    } else if (node.is_boolean()) {
      node = !node.get<bool>();
    } else if (node.is_number_integer()) {
      node = node.get<std::int64_t>() + static_cast<std::int64_t>(below(5)) - 2;
    } else {
      const Json scalars[] = {0, 1, -1, 2, "1/3", "-7/2", 0.5, nullptr, true, "", "1e-300", 4294967295U, "\n"};
      node = scalars[below(std::size(scalars))];
    }
  }

  void change_list(Json& list) {
    const auto i = static_cast<std::ptrdiff_t>(below(list.size())),
               k = static_cast<std::ptrdiff_t>(below(list.size()));
    switch (below(3)) {
      case 0: list.erase(list.begin() + i); break;
      case 1: list.insert(list.begin() + i, Json(list[static_cast<std::size_t>(k)])); break;
      default: std::swap(list[static_cast<std::size_t>(i)], list[static_cast<std::size_t>(k)]);
    }
  }
};

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, max_size);
  Json document = Json::parse(data, data + size, nullptr, false);
  if (document.is_discarded()) return LLVMFuzzerMutate(data, size, max_size);
  Mutator(seed).mutate(document);
  const std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}
