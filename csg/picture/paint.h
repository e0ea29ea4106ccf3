// Figures as a picture: panels in rows, captions, texts where there is room, a key of colors; .png, .svg or .pdf.
//
// All panels of a picture have one scale, so that what is larger looks larger; the picture is as high as what is
// in it. Cairo draws all three formats. Areas of a figure abut exactly, and drawn one after the other with soft
// edges they would let the ground shine through between them: in pixels they are drawn with hard edges, four times
// as fine, and then made smaller; in .svg and .pdf each has a hair of its own color around it. Colors that shine
// through are mixed before, against the white ground, so that this cannot darken them.
//
// The same figures give the same bytes (of .pdf the date is left out), with the same cairo and the font DejaVu
// Sans.
#pragma once

#include <string>
#include <vector>

#include "csg/picture/figure.h"

namespace cnrg {

struct Panel {
  Figure figure;
  std::string caption;  ///< may be empty
};

struct PictureSize {
  double width = 480, height = 400;  ///< no panel is larger, in pixels of .svg; a .png has two for each
};

/// True for .png .svg .pdf.
bool is_picture(const std::string& path);

/// The bytes of a picture in the format of the extension of `path`. Throws FileError if it is larger than cairo
/// can draw.
std::string picture_bytes(const std::string& path, const std::vector<Panel>& panels, const PictureSize& size = {});

}  // namespace cnrg
