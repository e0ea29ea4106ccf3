// Links between pages and citations of pages lead somewhere.
//
// A page is cited by its path from the root of the repository and the anchor of a heading, in comments as in
// pages: csg/SEMANTICS.md#groups. A link in a page is relative to the page, as browsers have it. The name of a
// page alone, without folder and anchor, is a word.
#include <filesystem>
#include <map>
#include <regex>
#include <string>

#include "tests/catch.h"
#include "tests/pages/page.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;

/// What is wrong with a file and an anchor in it ("" for none); empty if nothing is.
std::string fault(const fs::path& file, const std::string& anchor) {
  if (!fs::exists(file)) return "there is no " + name_of(file.lexically_normal());
  if (anchor.empty()) return {};
  if (file.extension() != ".md") return "an anchor in what is no page";
  static std::map<fs::path, Page> read;
  const fs::path path = fs::canonical(file);
  if (!read.contains(path)) read.emplace(path, read_page(path));
  return read.at(path).has_anchor(anchor) ? "" : name_of(path) + " has no heading for #" + anchor;
}

/// What is wrong with a link in a page. Addresses of the world are left alone.
std::string fault_of_link(const fs::path& page, const std::string& target) {
  if (target.find("://") != std::string::npos || target.starts_with("mailto:")) return {};
  const std::size_t mark = target.find('#');
  const std::string file = target.substr(0, mark);
  return fault(file.empty() ? page : page.parent_path() / file,
               mark == std::string::npos ? "" : target.substr(mark + 1));
}

/// Pages that a text names, with anchors: words that end so. A link of a page is none, nor is a path that a script
/// puts together.
std::vector<std::string> citations_in(const std::string& text) {
  static const std::regex named("(^|[\\s(`])([A-Za-z0-9_./-]*[A-Za-z0-9_-]\\.md(#[a-z0-9_-]*)?)");
  std::vector<std::string> citations;
  for (std::sregex_iterator i(text.begin(), text.end(), named), end; i != end; ++i) {
    const auto at = static_cast<std::size_t>(i->position());
    const bool link = i->str(1) == "(" && at > 0 && text[at - 1] == ']';
    const bool word = i->str(2).find_first_of("/#") == std::string::npos;
    if (!link && !word) citations.push_back(i->str(2));
  }
  return citations;
}

/// Words that were names of pages and do not say where the page is.
std::vector<std::string> bare_names_in(const std::string& text) {
  static const std::regex bare("\\b(SEMANTICS|FORMATS|INTERFACE|ARCHITECTURE|REFINEMENT)\\b(?!\\.md)");
  std::vector<std::string> names;
  for (std::sregex_iterator i(text.begin(), text.end(), bare), end; i != end; ++i) names.push_back(i->str());
  return names;
}

TEST_CASE("a link that leads nowhere is found", "[pages]") {
  const fs::path page = root() / "papers" / "README.md";
  CHECK(fault_of_link(page, "references.bib").empty());
  CHECK(fault_of_link(page, "#papers").empty());
  CHECK(fault_of_link(page, "../README.md#licence").empty());
  CHECK(fault_of_link(page, "https://example.org/nothing").empty());
  CHECK(fault_of_link(page, "no_such_file.png") == "there is no papers/no_such_file.png");
  CHECK(fault_of_link(page, "#no-such-heading") == "papers/README.md has no heading for #no-such-heading");
  CHECK(fault_of_link(page, "../README.md#nothing") == "README.md has no heading for #nothing");
  CHECK(fault_of_link(page, "references.bib#pereira") == "an anchor in what is no page");
}

TEST_CASE("citations are found in a text", "[pages]") {
  const std::string page = "csg/SEMANTICS.md";
  CHECK(citations_in("(" + page + "#the-tables). [x](../a.md#b)") ==
        std::vector<std::string>{page + "#the-tables"});
  CHECK(citations_in("as " + page + " has it, and x.md") == std::vector<std::string>{page});
  CHECK(bare_names_in("see SEMANTICS 4, not " + page) == std::vector<std::string>{"SEMANTICS"});
}

TEST_CASE("links in pages lead somewhere", "[pages]") {
  std::size_t links = 0;
  for (const fs::path& path : pages()) {
    const Page page = read_page(path);
    for (const PageLink& link : page.links) {
      INFO(name_of(path) << ":" << link.line + 1 << ": " << link.target);
      CHECK(fault_of_link(path, link.target) == "");
      ++links;
    }
  }
  CHECK(links >= 40);
}

TEST_CASE("citations of pages lead somewhere", "[pages]") {
  std::size_t citations = 0;
  for (const fs::path& path : sources()) {
    if (path.filename() == "links_test.cpp") continue;  // has citations that lead nowhere
    const std::string text = text_of(path);
    for (const std::string& citation : citations_in(text)) {
      const std::size_t mark = citation.find('#');
      INFO(name_of(path) << " cites " << citation);
      const std::string anchor = mark == std::string::npos ? "" : citation.substr(mark + 1);
      CHECK(fault(root() / citation.substr(0, mark), anchor) == "");
      if (!anchor.empty()) ++citations;
    }
    // Build files have such words of their own.
    if (path.extension() == ".txt" || path.extension() == ".in" || path.extension() == ".cmake") continue;
    for (const std::string& name : bare_names_in(text)) {
      INFO(name_of(path) << " cites " << name << " without its path");
      CHECK(name == "");
    }
  }
  CHECK(citations >= 30);
}

}  // namespace
}  // namespace cnrg
