// From figures, which have the units of the model, to one sheet of paper.
#pragma once

#include "csg/picture/paint.h"
#include "csg/picture/sheet.h"

namespace cnrg {

class Font;

PaperSheet lay_out(const std::vector<Panel>& panels, const std::optional<PictureSize>& size, const Font& font);

}  // namespace cnrg
