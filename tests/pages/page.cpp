// One pass over the lines of a page; only fences change what a line means.
#include "tests/pages/page.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>

namespace cnrg {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFence = "```";

/// The anchor of a heading; a link in it counts as its text.
std::string anchor_of(const std::string& heading) {
  static const std::regex link("\\[([^\\]]*)\\]\\([^)]*\\)");
  std::string anchor;
  for (const char c : std::regex_replace(heading, link, "$1")) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || c == '-' || c == '_' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) anchor += c;
    else if (c >= 'A' && c <= 'Z') anchor += static_cast<char>(c - 'A' + 'a');
    else if (c == ' ') anchor += '-';
  }
  return anchor;
}

/// The file that a line names as what follows: it ends with a name in backquotes and a colon.
std::string announced(const std::string& line) {
  static const std::regex name("`([A-Za-z0-9_.-]+\\.[a-z0-9]+)`:$");
  std::smatch match;
  return std::regex_search(line, match, name) ? match.str(1) : "";
}

bool is_text(const fs::path& path) {
  static const std::vector<std::string> text{".cpp", ".h", ".md", ".txt", ".yaml", ".py", ".bib", ".in", ".cmake"};
  const std::string extension = path.extension().string();
  if (!extension.empty()) return std::find(text.begin(), text.end(), extension) != text.end();
  // Scripts and build rules have no extension.
  std::ifstream stream(path);
  std::string line;
  return std::getline(stream, line) && (line.starts_with("#!") || path.filename() == "Snakefile");
}

}  // namespace

bool Page::has_anchor(const std::string& anchor) const {
  return std::find(anchors.begin(), anchors.end(), anchor) != anchors.end();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string text_of(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Page read_page(const fs::path& path) {
  static const std::regex link("\\]\\(([^)\\s]+)\\)"), code("`[^`]*`");
  Page page{path, lines_of(text_of(path)), {}, {}, {}};
  std::map<std::string, int> times;
  bool in_block = false;
  std::string above;  // the last line that is not blank
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const std::string& line = page.lines[i];
    if (line.starts_with(kFence)) {
      if (in_block) page.blocks.back().end = i;
      else page.blocks.push_back({i + 1, page.lines.size(), announced(above)});
      in_block = !in_block;
      above.clear();
      continue;
    }
    if (in_block) continue;
    if (!line.empty()) above = line;
    const std::size_t text = line.find_first_not_of('#');
    if (text != std::string::npos && text > 0 && line[text] == ' ') {
      std::string anchor = anchor_of(line.substr(text + 1));
      const int before = times[anchor]++;
      page.anchors.push_back(before == 0 ? anchor : anchor + "-" + std::to_string(before));
    }
    const std::string prose = std::regex_replace(line, code, "");
    for (std::sregex_iterator m(prose.begin(), prose.end(), link), end; m != end; ++m) {
      page.links.push_back({m->str(1), i});
    }
  }
  return page;
}

const fs::path& root() {
  static const fs::path path = CNRG_SOURCES;
  return path;
}

std::string name_of(const fs::path& path) { return fs::relative(path, root()).generic_string(); }

std::vector<fs::path> sources() {
  std::vector<fs::path> found;
  const auto take = [&](const fs::directory_entry& entry) {
    if (entry.is_regular_file() && is_text(entry.path())) found.push_back(entry.path());
  };
  for (const fs::directory_entry& entry : fs::directory_iterator(root())) take(entry);
  for (const char* room : {".ci", ".github", "kernel", "csg", "bench", "tests", "papers"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / room)) take(entry);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> found = sources();
  std::erase_if(found, [](const fs::path& path) { return path.extension() != ".md"; });
  return found;
}

}  // namespace cnrg
