#include "csg/formats/group_names.h"

#include <cctype>
#include <set>

#include "csg/text/escape.h"

namespace cnrg {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string cut(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return text;
  std::size_t end = 0;
  for (std::size_t next = 0; next + 3 <= longest;
       next += first_character(std::string_view(text).substr(end)).length)
    end = next;
  return text.substr(0, end) + "...";
}

std::string plain_label(std::string_view name) {
  std::string label;
  for (std::size_t i = 0; i < name.size();) {
    const Character c = first_character(name.substr(i));
    const char first = name[i];
    const bool plain = c.length == 1 && c.code < 0x80 &&
                       (is_letter(first) || std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '-');
    label += plain ? first : '_';
    i += c.length;
  }
  if (label.empty() || !is_letter(label[0])) label.insert(0, "G_");
  return label;
}

std::array<std::vector<std::string>, 4> distinct_names(const Mesh& mesh, std::string (*clean)(std::string_view),
                                                       std::size_t longest) {
  std::array<std::vector<std::string>, 4> names;
  std::set<std::string> given;
  const auto fresh = [&](std::string name) {
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return given.insert(name).second;
  };
  for (std::size_t d = 4; d-- > 0;) {
    for (const std::string& group : mesh.groups[d]) {
      const std::string first = clean(group);
      const auto short_of = [&](const std::string& ending) {
        std::string name = first;
        if (name.size() + ending.size() > longest) name = clean(cut(first, longest - ending.size()));
        return name + ending;
      };
      std::string name = short_of("");
      for (int n = 2; !fresh(name); ++n) name = short_of("_" + std::to_string(n));
      names[d].push_back(name);
    }
  }
  return names;
}

}  // namespace cnrg
