// Messages of trees as lines.
#include "csg/tree/position.h"

#include <algorithm>
#include <utility>

#include "csg/text/escape.h"

namespace cnrg {

std::string to_string(const std::string& file, Position at) {
  return file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

std::string Fault::text() const { return shown(to_string(file, at) + ": error: " + message); }

TreeError::TreeError(std::string file, Position at, std::string message)
    : TreeError(std::vector{Fault{std::move(file), at, std::move(message)}}) {}

void Faults::add(const Placed& error, bool of_file) {
  if (faults_.empty()) file_first_ = of_file;
  for (const Fault& fault : error.faults()) {
    if (std::ranges::find(faults_, fault) == faults_.end()) faults_.push_back(fault);
  }
}

void Faults::raise() const {
  if (faults_.empty()) return;
  if (file_first_) throw TreeFileError(faults_);
  throw TreeError(faults_);
}

std::string Diagnostic::text() const {
  return shown(to_string(file, at) + (level == Level::warning ? ": warning: " : ": notice: ") + message);
}

}  // namespace cnrg
