#include "csg/picture/paint.h"

#include <memory>

#include "csg/picture/layout.h"
#include "csg/picture/paper.h"
#include "csg/text/escape.h"
#include "csg/text/file.h"
#include "csg/text/plugin.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

/// Texts as they will be seen, so that their widths are known.
std::vector<Panel> with_shown_texts(std::vector<Panel> panels, const Font& font, bool brings_font) {
  const auto show = [&](std::string& text) {
    text = shown(text);
    if (brings_font) text = font.without_unknown(text);
  };
  for (Panel& panel : panels) {
    show(panel.caption);
    for (Figure::Label& label : panel.figure.labels) show(label.text);
    for (Figure::Key& key : panel.figure.keys) show(key.text);
  }
  return panels;
}

}  // namespace

bool is_picture(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".png" || extension == ".svg" || extension == ".pdf";
}

std::string picture_bytes(const std::string& path, const std::vector<Panel>& panels,
                          const std::optional<PictureSize>& size) {
  require(is_picture(path), "picture_bytes: unknown extension");
  require(!panels.empty(), "picture_bytes: no panel");
  const std::string extension = extension_of(path);
  const std::unique_ptr<Font> font(CNRG_PLUGIN_FUNCTION(kPaperPlugin, cnrg_paper_font)());
  const PaperSheet sheet = lay_out(with_shown_texts(panels, *font, extension != ".svg"), size, *font);
  if (extension == ".svg") return svg_text(sheet);
  std::string bytes;
  if (extension == ".pdf") CNRG_PLUGIN_FUNCTION(kPaperPlugin, cnrg_paper_pdf)(sheet, bytes);
  else CNRG_PLUGIN_FUNCTION(kPaperPlugin, cnrg_paper_png)(sheet, bytes);
  return bytes;
}

}  // namespace cnrg
