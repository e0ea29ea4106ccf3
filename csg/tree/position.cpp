// Messages of trees as lines.
#include "csg/tree/position.h"

#include <utility>

#include "csg/text/escape.h"

namespace cnrg {

std::string to_string(const std::string& file, Position at) {
  return file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

TreeError::TreeError(std::string file, Position at, std::string message)
    : InputError(shown(to_string(file, at) + ": error: " + message)),
      file_(std::move(file)),
      at_(at),
      message_(std::move(message)) {}

std::string Diagnostic::text() const {
  return shown(to_string(file, at) + (level == Level::warning ? ": warning: " : ": notice: ") + message);
}

}  // namespace cnrg
