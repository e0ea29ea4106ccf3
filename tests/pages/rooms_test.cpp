// The house is as its pages say: rooms include what is below them, and every path that a page names is there.
#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/catch.h"
#include "tests/pages/tables.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;

/// The rooms of a part of the house, as `part/room`, in the order of the table under the heading Rooms.
std::vector<std::string> listed_rooms(const std::string& part) {
  std::vector<std::string> rooms;
  for (const PageTable& table : tables_of(read_page(root() / part / "README.md"))) {
    if (table.anchor != "rooms" || table.head[0] != "room") continue;
    for (const std::vector<std::string>& row : table.rows) {
      for (const std::string& room : quoted_words(row[0])) rooms.push_back(part + "/" + room);
    }
  }
  return rooms;
}

/// The folder of a file of the repository, as it is written there. A folder in a room is of that room.
std::string room_of(const std::string& file) {
  fs::path folder = fs::path(file).parent_path();
  while (std::distance(folder.begin(), folder.end()) > 2) folder = folder.parent_path();
  return folder.string();
}

/// Files of the house that one includes.
std::vector<std::string> includes_of(const fs::path& file) {
  static const std::regex include("^\\s*#include \"((kernel|csg|bench|tests)/[^\"]*)\"");
  std::vector<std::string> included;
  for (const std::string& line : lines_of(text_of(file))) {
    std::smatch match;
    if (std::regex_search(line, match, include)) included.push_back(match.str(1));
  }
  return included;
}

/// What is wrong with an include, by the places of rooms; empty if nothing is.
std::string fault_of_include(const std::map<std::string, std::size_t>& place, const std::string& from,
                             const std::string& to) {
  if (from == to) return {};
  if (!place.contains(to)) return to + " is no room of a page";
  return place.at(to) < place.at(from) ? "" : from + " is below " + to;
}

TEST_CASE("an include of a room above is found", "[pages][rooms]") {
  const std::map<std::string, std::size_t> place{{"kernel/base", 0}, {"kernel/exact", 1}, {"csg/text", 2}};
  CHECK(fault_of_include(place, "kernel/exact", "kernel/exact").empty());
  CHECK(fault_of_include(place, "csg/text", "kernel/base").empty());
  CHECK(fault_of_include(place, "kernel/base", "kernel/exact") == "kernel/base is below kernel/exact");
  CHECK(fault_of_include(place, "kernel/base", "csg/app") == "csg/app is no room of a page");
}

TEST_CASE("rooms include rooms below them only", "[pages][rooms]") {
  std::map<std::string, std::size_t> place;
  for (const std::string part : {"kernel", "csg", "bench"}) {
    for (const std::string& room : listed_rooms(part)) {
      INFO(room);
      CHECK(fs::is_directory(root() / room));
      CHECK(place.try_emplace(room, place.size()).second);
    }
  }
  REQUIRE(place.size() >= 25);
  std::size_t seen = 0;
  for (const fs::path& file : sources()) {
    const std::string name = name_of(file), part = name.substr(0, name.find('/'));
    if (part != "kernel" && part != "csg" && part != "bench") continue;
    if (file.extension() != ".cpp" && file.extension() != ".h") continue;
    const std::string from = room_of(name);
    // Programs, the header of everything and examples stand above all rooms.
    if (from == part || from == "csg/examples") continue;
    INFO(name);
    CHECK(place.contains(from));
    for (const std::string& included : includes_of(file)) {
      ++seen;
      CHECK(fault_of_include(place, from, room_of(included)) == "");
    }
  }
  CHECK(seen > 800);
}

TEST_CASE("the pages list the rooms that there are", "[pages][rooms]") {
  for (const std::string part : {"kernel", "csg", "bench", "tests"}) {
    std::set<std::string> folders;
    for (const fs::directory_entry& entry : fs::directory_iterator(root() / part)) {
      const std::string room = part + "/" + entry.path().filename().string();
      const bool cache = room.ends_with("__pycache__");
      if (entry.is_directory() && room != "csg/examples" && !cache) folders.insert(room);
    }
    const std::vector<std::string> listed = listed_rooms(part);
    INFO(part << "/README.md, the table under Rooms");
    CHECK(std::set<std::string>(listed.begin(), listed.end()) == folders);
    CHECK(listed.size() == folders.size());
  }
}

TEST_CASE("the program on the page of csg is an example", "[pages][rooms]") {
  const Page page = read_page(root() / "csg" / "README.md");
  const std::string example = text_of(root() / "csg" / "examples" / "split.cpp");
  const auto begin = std::find(page.lines.begin(), page.lines.end(), "```cpp");
  REQUIRE(begin != page.lines.end());
  std::string program;
  for (auto line = begin + 1; line != page.lines.end() && *line != "```"; ++line) program += *line + "\n";
  CHECK(example.find("\n" + program + "\n// Output:\n") != std::string::npos);
}

/// Paths that a page names in backquotes, without what is no path of the repository: a file or folder below the
/// root or beside the page, perhaps with `*` in its last part.
std::vector<std::string> paths_in(const Page& page) {
  static const std::regex path("[A-Za-z0-9_.*-]+(/[A-Za-z0-9_.*-]+)+/?|[A-Za-z0-9_*-]+\\.(cpp|h|md|py|yaml)");
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    bool code = false;
    for (const CodeBlock& block : page.blocks) code = code || (block.begin <= i && i < block.end);
    if (code) continue;
    for (const std::string& word : quoted_words(page.lines[i])) {
      if (std::regex_match(word, path)) paths.push_back(word);
    }
  }
  return paths;
}

/// A file whose name fits, `*` standing for any letters.
bool is_there(const fs::path& path) {
  const std::string pattern = path.filename().string();
  if (pattern.find('*') == std::string::npos) return fs::exists(path);
  if (!fs::is_directory(path.parent_path())) return false;
  std::string text;
  for (const char c : pattern) text += c == '*' ? ".*" : c == '.' ? "\\." : std::string(1, c);
  for (const fs::directory_entry& entry : fs::directory_iterator(path.parent_path())) {
    if (std::regex_match(entry.path().filename().string(), std::regex(text))) return true;
  }
  return false;
}

TEST_CASE("paths that the pages of rooms name are there", "[pages][rooms]") {
  // What programs make or people have.
  static const std::set<std::string> elsewhere{"build", "out", "papers/KEY", "tests/ROOM"};
  for (const std::string part : {"csg", "kernel", "bench", "tests", "papers"}) {
    const Page page = read_page(root() / part / "README.md");
    fs::path folder;  // of the path before, which those after it on a line may leave out
    std::size_t named = 0;
    for (const std::string& word : paths_in(page)) {
      const bool made = std::any_of(elsewhere.begin(), elsewhere.end(),
                                    [&](const std::string& start) { return word.starts_with(start); });
      if (made) continue;
      INFO(name_of(page.path) << " names " << word);
      const fs::path path = word.ends_with("/") ? word.substr(0, word.size() - 1) : word;
      bool found = false;
      for (const fs::path& base : {root(), root() / part, folder}) {
        if (found || base.empty() || !is_there(base / path)) continue;
        found = true;
        folder = (base / path).parent_path();
      }
      CHECK(found);
      ++named;
    }
    CHECK(named >= 5);
  }
}

// A header of these takes the compiler one to eight seconds in each file that it reaches. Who needs what is in it
// calls the files that have it. (CGAL/Interval_nt.h is precompiled.)
TEST_CASE("headers of others that are slow to compile stand behind few files", "[pages][rooms]") {
  static const std::map<std::string, std::set<std::string>> known{
      {"CGAL/(?!Interval_nt)",
       {"csg/app/versions.cpp", "kernel/exact/convex_hull.cpp", "kernel/exact/delaunay.cpp",
        "kernel/exact/distance.cpp", "kernel/exact/lazy.h", "kernel/exact/triangulate.cpp"}},
      {"CGAL/Interval_nt", {"kernel/exact/enclosure.h"}},
      {"boost/(?!version)", {"csg/formats/dag_graph.cpp", "csg/topology/region_graph.cpp", "csg/tree/dag.cpp"}},
      {"nlohmann/",
       {"csg/compare/difference.cpp", "csg/explain/story.cpp", "csg/formats/glb.cpp", "csg/topology/topology.cpp",
        "csg/view/node_data.h"}},
      {"yaml-cpp/", {"csg/python/tree.cpp", "csg/tree/yaml_value.cpp", "csg/tree/yaml_value.h"}},
      {"CLI/", {"csg/app/main.cpp", "csg/app/program_text.cpp"}}};
  std::map<std::string, std::set<std::string>> found;
  for (const fs::path& file : sources()) {
    const std::string name = name_of(file);
    if (!name.starts_with("kernel/") && !name.starts_with("csg/")) continue;
    if (file.extension() != ".cpp" && file.extension() != ".h") continue;
    const std::string text = text_of(file);
    for (const auto& [header, files] : known) {
      if (std::regex_search(text, std::regex("#include <" + header))) found[header].insert(name);
    }
  }
  for (const auto& [header, files] : known) {
    INFO("#include <" << header);
    CHECK(found[header] == files);
  }
}

}  // namespace
}  // namespace cnrg
