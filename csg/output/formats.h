// The formats, one file each. A format turns a result into the text of its file.
#pragma once

#include <string>

#include "csg/output/flat.h"

namespace cnrg {

struct FileText {
  std::string text;
  RoundingReport rounding;
};

FileText json_text(const ResultView& view);
FileText vtu_text(const ResultView& view);
FileText obj_text(const ResultView& view);
FileText off_text(const ResultView& view);
FileText stl_text(const ResultView& view);
FileText ply_text(const ResultView& view);

}  // namespace cnrg
