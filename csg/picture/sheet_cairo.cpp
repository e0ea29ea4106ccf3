// PDF and PNG, by cairo. Two things in them would differ from run to run or from machine to machine: the date of a
// PDF, which is left empty, and the font, which is the program's own.
#include <cairo/cairo-ft.h>
#include <cairo/cairo-pdf.h>
#include <cairo/cairo.h>

#include <cmath>
#include <memory>
#include <new>

#include "csg/picture/paper.h"
#include "csg/text/escape.h"
#include "csg/text/plugin.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

constexpr double kPixels = 2;            // of a .png, for a unit of the page
constexpr double kPoints = 72.0 / 96.0;  // of a .pdf
constexpr double kMostPixels = 32767;    // that cairo can

void require_status(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  // Where libpng gets no memory, cairo speaks of an error in it; here it reads and writes memory only.
  if (status == CAIRO_STATUS_NO_MEMORY || status == CAIRO_STATUS_PNG_ERROR) throw std::bad_alloc();
  throw InvariantError(std::string("cairo: ") + cairo_status_to_string(status));
}

cairo_status_t append_bytes(void* to, const unsigned char* bytes, unsigned n) {
  try {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), n);
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}

/// The font as cairo wants it. Cairo keeps faces for a while after their last use, so they are its own: it ends
/// FreeType, too.
class CairoFont {
 public:
  CairoFont() {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) throw std::bad_alloc();
    const std::string_view bytes = font_file();
    FT_Face face = nullptr;
    if (FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                           static_cast<FT_Long>(bytes.size()), 0, &face) != 0) {
      FT_Done_FreeType(library);
      throw std::bad_alloc();
    }
    face_ = cairo_ft_font_face_create_for_ft_face(face, FT_LOAD_NO_HINTING);
    static const cairo_user_data_key_t key{};
    const cairo_status_t kept = cairo_font_face_set_user_data(
        face_, &key, library, [](void* data) { FT_Done_FreeType(static_cast<FT_Library>(data)); });
    if (kept != CAIRO_STATUS_SUCCESS) {
      cairo_font_face_destroy(face_);
      FT_Done_FreeType(library);
      require_status(kept);
    }
  }
  ~CairoFont() { cairo_font_face_destroy(face_); }
  CairoFont(const CairoFont&) = delete;
  CairoFont& operator=(const CairoFont&) = delete;
  cairo_font_face_t* face() const { return face_; }

 private:
  cairo_font_face_t* face_ = nullptr;
};

void choose(cairo_t* cr, const Rgb& color, double opacity = 1) {
  cairo_set_source_rgba(cr, color[0], color[1], color[2], opacity);
}

void path_of(cairo_t* cr, const std::vector<Point2>& points, bool closed) {
  cairo_new_sub_path(cr);
  for (const Point2& p : points) cairo_line_to(cr, p[0], p[1]);
  if (points.size() == 1) cairo_line_to(cr, points[0][0], points[0][1]);
  if (closed) cairo_close_path(cr);
}

void paint(cairo_t* cr, const PaperSheet::Area& area) {
  cairo_new_path(cr);
  for (const auto& loop : area.loops) path_of(cr, loop, true);
  choose(cr, area.color);
  cairo_set_line_width(cr, kSeam);
  cairo_set_dash(cr, nullptr, 0, 0);
  cairo_fill_preserve(cr);
  cairo_stroke_preserve(cr);
  if (area.pattern == PaperSheet::Pattern::plain) return cairo_new_path(cr);
  cairo_save(cr);
  cairo_clip(cr);
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  cairo_clip_extents(cr, &x0, &y0, &x1, &y1);
  const bool hatch = area.pattern == PaperSheet::Pattern::hatch;
  const double step = hatch ? kHatchStep : kWeaveStep, slope = hatch ? -1 : 1;
  // Lines y = slope x + k step: of one grid for the whole page.
  const double first = y0 - std::max(slope * x0, slope * x1), last = y1 - std::min(slope * x0, slope * x1);
  for (double k = std::floor(first / step); k <= std::ceil(last / step); ++k) {
    cairo_move_to(cr, x0, slope * x0 + k * step);
    cairo_line_to(cr, x1, slope * x1 + k * step);
  }
  choose(cr, area.lines);
  cairo_set_line_width(cr, hatch ? kHatchWidth : kWeaveWidth);
  cairo_stroke(cr);
  cairo_restore(cr);
}

void paint(cairo_t* cr, const PaperSheet::Line& line) {
  cairo_new_path(cr);
  path_of(cr, line.points, line.closed);
  choose(cr, line.look.color, line.look.opacity);
  cairo_set_line_width(cr, line.look.width);
  const double dashes[] = {line.look.dash, line.look.gap};
  const bool dashed = line.look.dash > 0;
  cairo_set_dash(cr, dashes, dashed ? 2 : 0, 0);
  cairo_set_line_cap(cr, dashed ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
  cairo_stroke(cr);
}

void paint(cairo_t* cr, const PaperSheet::Disk& disk) {
  cairo_new_path(cr);
  cairo_arc(cr, disk.at[0], disk.at[1], disk.radius, 0, 2 * M_PI);
  cairo_close_path(cr);
  if (disk.inside) {
    choose(cr, *disk.inside, disk.opacity);
    cairo_fill_preserve(cr);
  }
  if (disk.ring > 0) {
    choose(cr, disk.color, disk.opacity);
    cairo_set_line_width(cr, disk.ring);
    cairo_set_dash(cr, nullptr, 0, 0);
    cairo_stroke(cr);
  }
  cairo_new_path(cr);
}

/// Letters as text where `text` says so (a PDF, in which one wants to find them), else as outlines.
void paint(cairo_t* cr, const PaperSheet::Text& text, const Font& font, bool as_text) {
  const std::string letters = shown(text.text);
  cairo_set_font_size(cr, text.size);
  std::vector<cairo_glyph_t> glyphs;
  std::vector<cairo_text_cluster_t> clusters;
  double x = text.middle[0] - font.width(letters, text.size) / 2;
  const double y = text.middle[1] + kHalfLetter * text.size;
  for (std::size_t i = 0; i < letters.size();) {
    const Character c = first_character(std::string_view(letters).substr(i));
    const std::string letter = letters.substr(i, c.length);
    glyphs.push_back({font.glyph(c.code), x, y});
    clusters.push_back({static_cast<int>(c.length), 1});
    x += font.width(letter, text.size);
    i += c.length;
  }
  const int n = static_cast<int>(glyphs.size());
  if (text.halo) {
    cairo_new_path(cr);
    cairo_glyph_path(cr, glyphs.data(), n);
    choose(cr, kPaper, 0.8);
    cairo_set_line_width(cr, kHalo);
    cairo_set_dash(cr, nullptr, 0, 0);
    cairo_stroke(cr);
  }
  choose(cr, kInk);
  cairo_new_path(cr);
  if (as_text) {
    cairo_show_text_glyphs(cr, letters.data(), static_cast<int>(letters.size()), glyphs.data(), n, clusters.data(),
                           n, static_cast<cairo_text_cluster_flags_t>(0));
  } else {
    cairo_glyph_path(cr, glyphs.data(), n);
    cairo_fill(cr);
  }
  cairo_new_path(cr);
}

void paint(cairo_surface_t* surface, const PaperSheet& sheet, double scale, bool as_text) {
  require_status(cairo_surface_status(surface));
  const std::unique_ptr<cairo_t, void (*)(cairo_t*)> held(cairo_create(surface), cairo_destroy);
  cairo_t* const cr = held.get();
  require_status(cairo_status(cr));
  cairo_scale(cr, scale, scale);
  choose(cr, kPaper);
  cairo_paint(cr);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
  cairo_set_fill_rule(cr, CAIRO_FILL_RULE_EVEN_ODD);
  for (const PaperSheet::Area& area : sheet.areas) paint(cr, area);
  for (const PaperSheet::Line& line : sheet.lines) paint(cr, line);
  for (const PaperSheet::Disk& disk : sheet.disks) paint(cr, disk);
  cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
  const std::unique_ptr<Font> font(cnrg_paper_font());
  const CairoFont face;
  cairo_set_font_face(cr, face.face());
  for (const PaperSheet::Text& text : sheet.texts) paint(cr, text, *font, as_text);
  require_status(cairo_status(cr));
}

using Surface = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

std::string pdf_bytes_once(const PaperSheet& sheet) {
  std::string bytes;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(append_bytes, &bytes, sheet.width * kPoints, sheet.height * kPoints),
      cairo_surface_destroy);
  require_status(cairo_surface_status(surface.get()));
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  if (!sheet.title.empty()) {
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, shown(sheet.title).c_str());
  }
  paint(surface.get(), sheet, kPoints, true);
  cairo_surface_finish(surface.get());
  require_status(cairo_surface_status(surface.get()));
  return bytes;
}

std::string png_bytes(const PaperSheet& sheet) {
  const double width = sheet.width * kPixels, height = sheet.height * kPixels;
  if (width > kMostPixels || height > kMostPixels) {
    throw InputError(
        "cnrg: error: the picture would have more than 32,767 pixels in one direction; give a smaller --size or "
        "fewer panels, or write .svg");
  }
  std::string bytes;
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)),
      cairo_surface_destroy);
  paint(surface.get(), sheet, kPixels, false);
  require_status(cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes));
  return bytes;
}

}  // namespace
}  // namespace cnrg

CNRG_PLUGIN_EXPORT void cnrg_paper_pdf(const cnrg::PaperSheet& sheet, std::string& bytes) {
  // Where cairo 1.16 gets no memory while it ends a .pdf, it may leave out what needed it and say nothing.
  bytes = cnrg::pdf_bytes_once(sheet);
  if (bytes != cnrg::pdf_bytes_once(sheet)) throw std::bad_alloc();
}

CNRG_PLUGIN_EXPORT void cnrg_paper_png(const cnrg::PaperSheet& sheet, std::string& bytes) {
  bytes = cnrg::png_bytes(sheet);
}

CNRG_PLUGIN_EXPORT const char* cnrg_paper_version() {
  static const std::string text = std::string("cairo ") + cairo_version_string();
  return text.c_str();
}
