// Trees made so small that evaluating them takes a moment, and their evaluation with every check.
#pragma once

#include <string>
#include <string_view>

#include "csg/tree/tree.h"

namespace cnrg::fuzz {

/// A folder in memory, where there is one, that this process has for itself and that goes with it.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  void write(const std::string& name, std::string_view content) const;

 private:
  std::string folder_;
};
const Folder& folder();

/// Curved leaves get few facets; nothing else changes.
void make_coarse(Tree& tree);

/// Evaluates a tree with the invariants of its complex and the identities of its nodes, writes its result to a
/// `.json` and reads that back, if its leaves together have few faces. Throws as `evaluate` does.
void evaluate_small(const Tree& tree);

/// A fault: no error that people are meant to read.
[[noreturn]] void fault(const std::string& what);

/// Runs `work`; the errors that people are meant to read are caught. Their text must be there.
template <class Work>
void accept_errors(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    if (error.what()[0] == '\0') fault("an error without words");
  } catch (const FileError& error) {
    if (error.what()[0] == '\0') fault("an error without words");
  }
}

}  // namespace cnrg::fuzz
