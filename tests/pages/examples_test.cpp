// The pages: each command in them prints what the page shows, and each tree of papers/ is in such a command.
//
// CNRG_WRITE_PAGES=1 writes what the commands print into the pages: write a command, run, read what has changed.
#include "tests/pages/examples.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

bool is_shown(const Lines& shown, const Lines& printed) { return difference(shown, printed).empty(); }

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

Lines lines_between(const Page& page, std::size_t begin, std::size_t end) {
  return {page.lines.begin() + static_cast<std::ptrdiff_t>(begin),
          page.lines.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// Folders of the lessons, whose pages have a folder each for their commands and files.
const fs::path kLessons = "papers/lessons";

/// The folder in which the commands of a page run: of a lesson its own, else the root.
fs::path folder_of(const Page& page) {
  const fs::path folder = fs::relative(page.path.parent_path(), root());
  return folder.parent_path() == kLessons ? folder : fs::path(".");
}

/// Where the commands of a page run: `cnrg` is the program,
/// `python3` has the module and its examples, papers/ is a copy, and the files of the first page are there.
void furnish(const Workshop& w, const Page& page) {
  fs::create_directory(w.path(".bin"));
  fs::create_symlink(CNRG_PROGRAM, w.path(".bin") / "cnrg");
  w.write(".bin/python3", "#!/bin/sh\nPYTHONPATH='" CNRG_MODULES "' exec /usr/bin/python3 -B \"$@\"\n");
  fs::permissions(w.path(".bin/python3"), fs::perms::owner_all);
  fs::copy(root() / "papers", w.path("papers"), fs::copy_options::recursive);
  fs::create_directories(w.path("csg/python"));
  fs::create_directory_symlink(root() / "csg/python/examples", w.path("csg/python/examples"));
  fs::create_directories(w.path("out") / page.path.parent_path().filename());
  const Page first = read_page(root() / "README.md");
  for (const CodeBlock& block : first.blocks)
    if (!block.file.empty()) w.write(block.file, joined(lines_between(first, block.begin, block.end)));
}

/// What the command prints on standard output and then on standard error, and its status.
Outcome run(const Workshop& w, const fs::path& folder, const std::string& command) {
  return w.shell("{ PATH=\"$PWD/.bin:$PATH\"\ncd '" + folder.string() + "'\n" + command +
                 "\n} </dev/null >.out 2>.err");
}

/// The pictures in a folder.
std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (const fs::path end = entry.path().extension(); end == ".png" || end == ".svg") out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The pictures beside a page of papers/ are those that its commands have made, and no others.
void check_pictures(const Workshop& w, const Page& page) {
  const fs::path folder = fs::relative(page.path.parent_path(), root());
  if (*folder.begin() != "papers") return;
  const std::vector<fs::path> made = pictures_in(w.path(folder.string()));
  if (std::getenv("CNRG_WRITE_PAGES") != nullptr) {
    for (const fs::path& file : made) {
      fs::copy_file(file, root() / folder / file.filename(), fs::copy_options::overwrite_existing);
    }
  }
  std::vector<std::string> names, kept;
  for (const fs::path& file : made) names.push_back(file.filename().string());
  for (const fs::path& file : pictures_in(root() / folder)) kept.push_back(file.filename().string());
  CHECK(kept == names);
  for (const fs::path& file : made) {
    INFO(name_of(page.path) << ": " << file.filename() << " is not what its command makes");
    CHECK((bytes_of(file) == bytes_of(root() / folder / file.filename())));
  }
}

/// Runs the examples of a page.
void check_examples(const Page& page) {
  const Workshop w;
  furnish(w, page);
  const fs::path folder = folder_of(page);
  const fs::path own = w.path(fs::relative(page.path.parent_path(), root()).string());
  if (fs::exists(own)) {  // papers/ is there as a copy: its pictures are to be made
    for (const fs::path& picture : pictures_in(own)) fs::remove(picture);
  }
  Lines text = page.lines;
  std::ptrdiff_t grown = 0;  // lines by which `text` is longer than the page so far
  for (const CodeBlock& block : page.blocks) {
    const Lines lines = lines_between(page, block.begin, block.end);
    if (!block.file.empty()) {
      INFO(name_of(page.path) << ":" << block.begin + 1 << ": " << block.file);
      const std::string file = (folder / block.file).string();
      if (fs::exists(w.path(file))) CHECK(lines_of(w.read(file)) == lines);
      else w.write(file, joined(lines));
    }
    for (const Claim& claim : claims_of(page, block)) {
      const Outcome o = run(w, folder, claim.command);
      const Lines shown = lines_between(page, claim.begin, claim.end), printed = lines_of(o.out + o.err);
      if (std::getenv("CNRG_WRITE_PAGES") != nullptr) {
        const Lines right = corrected(shown, printed);
        const auto begin = text.begin() + static_cast<std::ptrdiff_t>(claim.begin) + grown;
        const auto rest = text.erase(begin, begin + static_cast<std::ptrdiff_t>(shown.size()));
        text.insert(rest, right.begin(), right.end());
        grown += static_cast<std::ptrdiff_t>(right.size()) - static_cast<std::ptrdiff_t>(shown.size());
      } else {
        INFO(name_of(page.path) << ":" << claim.begin << ": $ " << claim.command << "\n" << o.out << o.err);
        CHECK(difference(shown, printed) == "");
        const bool fails = joined(shown).find("error: ") != std::string::npos;
        // The end of `cnrg compare`: what it says in a line of its own.
        const bool different = std::find(shown.begin(), shown.end(), "different") != shown.end();
        if (different) CHECK(o.status == 4);
        else CHECK((o.status == 0) == !fails);
      }
    }
  }
  check_pictures(w, page);
  if (text != page.lines) std::ofstream(page.path) << joined(text);
}

TEST_CASE("lines are compared word by word", "[pages]") {
  const Lines printed{"node  op   regions  seconds  volume", "a  box  1  0.000  8",
                      "b  cone  2  0.125  8.1e-12 (1/123456789012)", "c  box  1  0.001  1/2"};
  const std::string any = "...";
  CHECK(is_shown(printed, printed));
  CHECK(is_shown({any, "a box 1 9.999 8", "b cone 2 0.000 8.1e-12", "c box 1 0.000 1/2"}, printed));
  CHECK(is_shown({any, "b cone 2 0.000 8.1e-12", any}, printed));
  CHECK(is_shown({"a 1 0.000 ±0.25 0.5"}, {"a 1 9.999  ±0.25  0.5 (1/1000000000000)"}));
  CHECK_FALSE(is_shown({"a 1 0.000 ±0.25 0.5"}, {"a 1 0.000  ±0.26  0.5 (1/1000000000000)"}));
  CHECK(is_shown({printed[0], any, printed[3]}, printed));
  CHECK(is_shown({any}, {}));
  CHECK(is_shown({}, {}));
  CHECK_FALSE(is_shown({}, printed));
  CHECK_FALSE(is_shown({printed[0]}, printed));
  CHECK_FALSE(is_shown({printed[0], any}, {}));
  CHECK_FALSE(is_shown({any, "a box 1 0.000 9", any}, printed));
  CHECK_FALSE(is_shown({any, " a box 1 0.000 8", any}, printed));
  CHECK_FALSE(is_shown({any, "a box 2 0.000 8", any}, printed));
  CHECK_FALSE(is_shown({any, "b cone 2 0.000 8.2e-12", any}, printed));
  CHECK_FALSE(is_shown({any, "c box 1 0.000 1/3"}, printed));
  CHECK_FALSE(is_shown({any, "c box 1 0.000 1/2", any, "a box 1 0.000 8"}, printed));
  CHECK_FALSE(is_shown({any, "a box 1 0.000 8"}, printed));
}

TEST_CASE("stages of an evaluation have times, too", "[pages]") {
  const Lines printed{"node  op          faces  seconds  volume", "      leaves                0.012",
                      "      refinement      151    1.234", "a     box              6    0.000  0.125"};
  CHECK(
      is_shown({printed[0], "      leaves                0.000", "      refinement      151    0.000", printed[3]},
               printed));
  CHECK_FALSE(is_shown({printed[0], printed[1], "      refinement      150    1.234", printed[3]}, printed));
  CHECK_FALSE(is_shown({"a 0.126"}, {"a 0.125"}));
  CHECK(corrected({}, printed) ==
        Lines{printed[0], "      leaves                0.000", "      refinement      151    0.000", printed[3]});
}

TEST_CASE("a page can be brought up to date", "[pages]") {
  const Lines printed{"seconds  volume", "a   12.345  8", "b    0.100  0.333333333333 (1/3)", "note"};
  CHECK(corrected({}, printed) ==
        Lines{"seconds  volume", "a    0.000  8", "b    0.000  0.333333333333 (1/3)", "note"});
  CHECK(corrected({"seconds volume", "b 0.000 0.333333333333"}, printed) ==
        Lines{"seconds volume", "a    0.000  8", "b 0.000 0.333333333333", "note"});
  CHECK(corrected({"seconds volume", "..."}, printed) == Lines{"seconds volume", "..."});
}

TEST_CASE("what the pages show is what the program prints", "[pages]") {
  for (const fs::path& path : pages()) {
    DYNAMIC_SECTION(name_of(path)) { check_examples(read_page(path)); }
  }
}

/// Words of the commands of a page of which something is shown.
std::set<std::string> words_shown(const Page& page) {
  std::set<std::string> words;
  for (const CodeBlock& block : page.blocks) {
    for (const Claim& claim : claims_of(page, block)) {
      std::istringstream stream(claim.command);
      for (std::string word; claim.begin < claim.end && stream >> word;) words.insert(word);
    }
  }
  return words;
}

TEST_CASE("each tree of a paper and of a lesson is shown on its page", "[pages]") {
  std::size_t papers = 0, lessons = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / "papers")) {
    if (entry.path().filename() != "README.md" || entry.path() == root() / "papers" / "README.md") continue;
    const Page page = read_page(entry.path());
    const fs::path folder = folder_of(page);
    ++(folder == "." ? papers : lessons);
    const std::set<std::string> words = words_shown(page);
    for (const fs::directory_entry& tree : fs::directory_iterator(entry.path().parent_path())) {
      if (tree.path().extension() != ".yaml") continue;
      // Exercises and their answers are tested with the lessons.
      if (tree.path().stem() == "exercise" || tree.path().stem() == "answer") continue;
      const std::string name = fs::relative(tree.path(), root() / folder).generic_string();
      INFO(name_of(tree.path()) << ": its page has no block with a command on it and its output");
      CHECK(words.contains(name));
    }
  }
  CHECK(papers >= 14);
  CHECK(lessons == 14);
}

}  // namespace
}  // namespace cnrg
