#include "csg/formats/group_names.h"

#include <cctype>
#include <map>

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

std::array<std::vector<std::string>, 4> distinct_names(const Mesh& mesh, const GroupNameForm& form) {
  static constexpr const char* kCells[] = {"points", "edges", "faces", "solids"};
  std::array<std::vector<std::string>, 4> names;
  std::map<std::string, std::size_t> given;  // with the dimension
  const auto key_of = [&](std::string name) {
    for (char& c : name) {
      if (!form.case_matters) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return name;
  };
  for (std::size_t d = 4; d-- > 0;) {
    for (const std::string& group : mesh.groups[d]) {
      const std::string first = form.clean(group);
      const auto with = [&](const std::string& word) {
        const std::string ending = word.empty() ? "" : form.before + word + form.after;
        if (first.size() + ending.size() <= form.longest) return first + ending;
        return form.clean(cut(first, form.longest - ending.size())) + ending;
      };
      std::string name = with("");
      const auto taken = given.find(key_of(name));
      std::string word = taken == given.end() || taken->second == d ? "" : kCells[d];
      if (!word.empty()) name = with(word);
      for (int n = 2; !given.try_emplace(key_of(name), d).second; ++n)
        name = with(word + (word.empty() ? "" : " ") + std::to_string(n));
      names[d].push_back(name);
    }
  }
  return names;
}

}  // namespace cnrg
