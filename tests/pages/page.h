// A page of the repository (a Markdown file) as what tests ask of it: headings, links, blocks of code.
//
// Headings have the anchors that GitHub gives them: small letters, spaces as hyphens, other marks left out. What
// stands between the fences of a block is neither heading nor link.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cnrg {

/// Lines of a page between two fences: [begin, end), counted from 0.
struct CodeBlock {
  std::size_t begin = 0, end = 0;
  std::string file;  // the name of the file that the block is; empty when it is none
};

struct PageLink {
  std::string target;
  std::size_t line = 0;  // from 0
};

struct Page {
  std::filesystem::path path;
  std::vector<std::string> lines;
  std::vector<std::string> anchors;  // of the headings, in their order
  std::vector<PageLink> links;
  std::vector<CodeBlock> blocks;

  bool has_anchor(const std::string& anchor) const;
};

Page read_page(const std::filesystem::path& path);

std::vector<std::string> lines_of(const std::string& text);

/// All of a file; "" if it cannot be read.
std::string text_of(const std::filesystem::path& path);

/// The files of the repository that are text and written by people: code, scripts, build files, pages, trees.
/// Sorted.
std::vector<std::filesystem::path> sources();

/// Those of them that are pages.
std::vector<std::filesystem::path> pages();

/// The root of the repository.
const std::filesystem::path& root();

/// A path as it is written in the repository.
std::string name_of(const std::filesystem::path& path);

}  // namespace cnrg
