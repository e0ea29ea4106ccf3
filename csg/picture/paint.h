// Figures as a picture: panels in rows with captions, texts where there is room, a key of colors; .png, .svg or
// .pdf.
//
// The same figures give the same bytes on every machine with the same cairo: the font is in the program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "csg/picture/figure.h"

namespace cnrg {

struct Panel {
  Figure figure;
  std::string caption;  ///< may be empty
};

/// The largest box of a panel without its caption, in pixels of .svg, 96 to an inch; a .png has two for each.
struct PictureSize {
  double width = 480, height = 360;
};

/// True for .png .svg .pdf.
bool is_picture(const std::string& path);

/// The bytes of a picture in the format of the extension of `path`. Without a size as many panels as there are in
/// a row fill the width of a page. Throws InputError if it is larger than cairo can draw.
std::string picture_bytes(const std::string& path, const std::vector<Panel>& panels,
                          const std::optional<PictureSize>& size = {});

}  // namespace cnrg
