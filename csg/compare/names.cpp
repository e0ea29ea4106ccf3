// Operators join names by ` & ` in the order of their operands, so words are compared as sets.
#include "csg/compare/names.h"

#include <algorithm>
#include <map>

#include "csg/operators/components.h"

namespace cnrg {
namespace {

enum class Origin { node, file, given };

/// Names of components that operators add.
bool is_of_operator(const std::string& word) {
  return word == kEntitiesName || word == "closure" || word == "boundary" || word == "regularize";
}

}  // namespace

std::string Names::plain(const std::string& name) const {
  std::string out = name;
  for (std::size_t at = 0; (at = out.find(mark_, at)) != std::string::npos;) out.erase(at, mark_.size());
  return out;
}

bool Names::differ(const std::string& in_a, const std::string& in_b) const {
  const auto words_of = [&](const std::string& name, std::size_t side) {
    std::map<std::string, Origin> words;
    for (std::size_t begin = 0; !name.empty() && begin <= name.size();) {
      const std::size_t end = std::min(name.find(" & ", begin), name.size());
      const std::string word = name.substr(begin, end - begin);
      const bool of_node = word.starts_with(mark_);
      Origin origin = Origin::given;
      if (of_node) origin = Origin::node;
      else if (given_[side].words.contains(word)) origin = Origin::given;
      else if (is_of_operator(word)) origin = Origin::node;
      else if (given_[side].reads_result) origin = Origin::file;
      Origin& known = words.emplace(plain(word), origin).first->second;
      known = std::max(known, origin);
      begin = end + 3;
    }
    return words;
  };
  const auto a = words_of(in_a, 0), b = words_of(in_b, 1);
  const auto strongest = [](const auto& of, const auto& other) {
    int most = -1;
    for (const auto& [word, origin] : of) {
      if (!other.contains(word)) most = std::max(most, static_cast<int>(origin));
    }
    return most;
  };
  const int most_a = strongest(a, b), most_b = strongest(b, a);
  return std::max(most_a, most_b) == static_cast<int>(Origin::given) ||
         (most_a == static_cast<int>(Origin::file) && most_b == most_a);
}

}  // namespace cnrg
