#include "csg/picture/paint.h"

#include <cairo/cairo-pdf.h>
#include <cairo/cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "csg/text/file.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

constexpr double kMargin = 16, kBetween = 28, kFont = 12, kKeyGap = 18;
constexpr std::size_t kColumns = 4;  // panels in a row

struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  bool inside(const Box& other) const {
    return x >= other.x && y >= other.y && x + width <= other.x + other.width &&
           y + height <= other.y + other.height;
  }
  bool meets(const Box& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height && other.y < y + height;
  }
};

/// Where everything is on the sheet, in pixels of .svg.
struct Layout {
  double scale = 1, width = 0, height = 0;
  std::vector<Box> panels;       // what is drawn
  std::vector<Point2> captions;  // middle of the baseline
  std::vector<Figure::Key> keys;
  std::vector<Point2> key_places;  // lower left
};

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

Surface owned(cairo_surface_t* surface) {
  Surface out(surface, cairo_surface_destroy);
  if (cairo_surface_status(surface) == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
    throw InputError(std::string("cnrg: error: the picture cannot be drawn (") +
                     cairo_status_to_string(cairo_surface_status(surface)) + "); make --size smaller");
  }
  return out;
}
Context context_on(const Surface& surface) { return {cairo_create(surface.get()), cairo_destroy}; }

cairo_status_t append(void* text, const unsigned char* data, unsigned size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

void set_font(cairo_t* c, double size = kFont) {
  cairo_select_font_face(c, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(c, size);
  // No hints: texts are as long in pixels as in the other formats.
  const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
      cairo_font_options_create(), cairo_font_options_destroy);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(c, options.get());
}

double text_width(cairo_t* c, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(c, text.c_str(), &extents);
  return extents.x_advance;
}

/// The keys of all panels, each once; none if there is but one, if labels name them all, or if there are more than
/// colors.
std::vector<Figure::Key> keys_of(const std::vector<Panel>& panels) {
  std::vector<Figure::Key> out;
  std::set<std::string> known, labelled;
  for (const Panel& panel : panels) {
    for (const auto& label : panel.figure.labels) labelled.insert(label.text);
    for (const auto& key : panel.figure.keys) {
      if (known.insert(key.text).second) out.push_back(key);
    }
  }
  const bool named =
      std::all_of(out.begin(), out.end(), [&](const auto& key) { return labelled.contains(key.text); });
  if (out.size() < 2 || out.size() > kPaletteSize || named) out.clear();
  return out;
}

Layout lay_out(const std::vector<Panel>& panels, const PictureSize& size) {
  Layout out;
  out.scale = INFINITY;
  for (const Panel& panel : panels) {
    const Figure& d = panel.figure;
    const double width = d.high[0] - d.low[0], height = d.high[1] - d.low[1];
    if (width > 0) out.scale = std::min(out.scale, size.width / width);
    if (height > 0) out.scale = std::min(out.scale, size.height / height);
  }
  if (!std::isfinite(out.scale)) out.scale = 1;
  const Surface measure = owned(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr));
  const Context c = context_on(measure);
  set_font(c.get());
  const std::size_t n = panels.size();
  const std::size_t rows = (n + kColumns - 1) / kColumns, columns = rows == 0 ? 0 : (n + rows - 1) / rows;
  // A row is as high as its highest panel, a column as wide as its widest panel or caption.
  std::vector<double> widths(columns, 0), heights(rows, 0);
  bool captions = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Figure& d = panels[i].figure;
    captions = captions || !panels[i].caption.empty();
    widths[i % columns] = std::max(
        {widths[i % columns], (d.high[0] - d.low[0]) * out.scale, text_width(c.get(), panels[i].caption)});
    heights[i / columns] = std::max(heights[i / columns], (d.high[1] - d.low[1]) * out.scale);
  }
  double y = kMargin;
  for (std::size_t row = 0; row < rows; ++row) {
    double x = kMargin;
    for (std::size_t i = row * columns; i < std::min(n, (row + 1) * columns); ++i) {
      const Figure& d = panels[i].figure;
      const double width = (d.high[0] - d.low[0]) * out.scale, height = (d.high[1] - d.low[1]) * out.scale;
      const double column = widths[i % columns];
      out.panels.push_back({x + (column - width) / 2, y + (heights[row] - height) / 2, width, height});
      out.captions.push_back({x + column / 2, y + heights[row] + 1.9 * kFont});
      x += column + kBetween;
    }
    out.width = std::max(out.width, x - kBetween + kMargin);
    y += heights[row] + (captions ? 2.4 * kFont : 0) + (row + 1 < rows ? kBetween / 2 : 0);
  }
  out.keys = keys_of(panels);
  double x = kMargin;
  if (!out.keys.empty()) y += 1.9 * kFont;
  for (const auto& key : out.keys) {
    const double width = 1.5 * kFont + text_width(c.get(), key.text);
    if (x > kMargin && x + width > std::max(out.width, size.width) - kMargin) {
      x = kMargin;
      y += 1.6 * kFont;
    }
    out.key_places.push_back({x, y});
    out.width = std::max(out.width, x + width + kMargin);
    x += width + kKeyGap;
  }
  out.height = y + kMargin;
  return out;
}

Rgb on_white(const Rgb& color, double opacity) { return mix({1, 1, 1}, color, opacity); }

/// One panel on a sheet.
class Painter {
 public:
  Painter(cairo_t* c, const Panel& panel, const Box& box, const Layout& layout)
      : c_(c), figure_(panel.figure), box_(box), scale_(layout.scale), sheet_{0, 0, layout.width, layout.height} {}

  /// With `pixels`, which is for hard edges; else each with a hair of its own color.
  void areas(bool pixels) {
    cairo_set_fill_rule(c_, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_set_line_join(c_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_antialias(c_, pixels ? CAIRO_ANTIALIAS_NONE : CAIRO_ANTIALIAS_DEFAULT);
    cairo_set_line_width(c_, 0.5);
    if (!pixels) {
      for (const auto& area : figure_.areas) {
        outline(area);
        set(on_white(area.color, area.opacity));
        cairo_stroke(c_);
      }
    }
    for (const auto& area : figure_.areas) {
      outline(area);
      set(on_white(area.color, area.opacity));
      cairo_fill(c_);
    }
    cairo_set_antialias(c_, CAIRO_ANTIALIAS_DEFAULT);
    for (const auto& area : figure_.areas) {
      if (area.missing || area.sheet) hatch(area);
    }
  }

  void strokes() {
    cairo_set_line_join(c_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(c_, CAIRO_LINE_CAP_ROUND);
    // What is hidden first, and what is thin.
    for (const bool hidden : {true, false}) {
      for (const Figure::Line line : {Figure::Line::ghost, Figure::Line::edge, Figure::Line::outline,
                                      Figure::Line::border, Figure::Line::wire}) {
        for (const auto& stroke : figure_.strokes) {
          if (stroke.hidden == hidden && stroke.line == line) draw(stroke);
        }
      }
    }
    cairo_set_dash(c_, nullptr, 0, 0);
  }

  void dots() {
    for (const bool hidden : {true, false}) {
      for (const auto& dot : figure_.dots) {
        if (dot.hidden == hidden) draw(dot);
      }
    }
  }

  void labels() {
    set_font(c_);
    std::vector<Box> taken;
    for (const auto& dot : figure_.dots) {
      const Point2 p = place(dot.at);
      if (!dot.hidden) taken.push_back({p[0] - 3, p[1] - 3, 6, 6});
    }
    for (const auto& label : figure_.labels) {
      const double width = text_width(c_, label.text);
      for (const Box& box : candidates(label, width)) {
        const auto met = [&](const Box& other) { return box.meets(other); };
        if (!box.inside(sheet_) || std::any_of(taken.begin(), taken.end(), met)) continue;
        taken.push_back(box);
        write(label.text, box.x, box.y + box.height - 0.22 * kFont);
        break;
      }
    }
  }

  void write(const std::string& text, double x, double y) {
    cairo_move_to(c_, x, y);
    cairo_text_path(c_, text.c_str());
    cairo_set_source_rgba(c_, 1, 1, 1, 0.7);
    cairo_set_line_width(c_, 2.6);
    cairo_set_line_join(c_, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(c_);
    cairo_move_to(c_, x, y);
    set(kInk);
    cairo_show_text(c_, text.c_str());
  }

 private:
  cairo_t* c_;
  const Figure& figure_;
  Box box_;
  double scale_;
  Box sheet_;

  void set(const Rgb& color, double opacity = 1) {
    cairo_set_source_rgba(c_, color[0], color[1], color[2], opacity);
  }
  Point2 place(const Point2& p) const {
    return {box_.x + (p[0] - figure_.low[0]) * scale_, box_.y + (figure_.high[1] - p[1]) * scale_};
  }
  void chain(const std::vector<Point2>& points, bool closed) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point2 p = place(points[i]);
      (i == 0 ? cairo_move_to : cairo_line_to)(c_, p[0], p[1]);
    }
    if (closed) cairo_close_path(c_);
  }
  void outline(const Figure::Area& area) {
    for (const auto& loop : area.loops) chain(loop, true);
  }

  /// Lines across an area: dark ones where a face is missing, faint ones on a sheet.
  void hatch(const Figure::Area& area) {
    cairo_save(c_);
    outline(area);
    cairo_clip(c_);
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    cairo_clip_extents(c_, &x0, &y0, &x1, &y1);
    const double step = area.missing ? 6 : 4, slope = area.missing ? 1 : -1;
    const double first = std::floor((x0 - std::max(slope * y0, slope * y1)) / step);
    for (double k = first; k * step + std::min(slope * y0, slope * y1) <= x1; ++k) {
      cairo_move_to(c_, k * step + slope * y0, y0);
      cairo_line_to(c_, k * step + slope * y1, y1);
    }
    set(area.missing ? kInk : Rgb{1, 1, 1}, area.missing ? 0.45 : 0.28);
    cairo_set_line_width(c_, area.missing ? 0.9 : 0.7);
    cairo_stroke(c_);
    cairo_restore(c_);
  }

  void draw(const Figure::Stroke& stroke) {
    double width = 0.9;
    switch (stroke.line) {
      case Figure::Line::edge: width = 0.9; break;
      case Figure::Line::outline: width = 1.4; break;
      case Figure::Line::border: width = 1.8; break;
      case Figure::Line::wire: width = 2.8; break;
      case Figure::Line::ghost: width = 0.7; break;
    }
    if (stroke.hidden) width *= 0.65;
    const std::array<double, 2> dashes =
        stroke.line == Figure::Line::ghost ? std::array{1.5, 2.5} : std::array{5.0, 4.0};
    cairo_set_dash(c_, dashes.data(), stroke.missing || stroke.line == Figure::Line::ghost ? 2 : 0, 0);
    cairo_set_line_width(c_, width);
    const bool wire = stroke.line == Figure::Line::wire;
    set(stroke.color, stroke.hidden ? (wire ? 0.75 : 0.42) : stroke.line == Figure::Line::ghost ? 0.6 : 1);
    chain(stroke.points, stroke.closed);
    cairo_stroke(c_);
  }

  void draw(const Figure::Dot& dot) {
    const Point2 p = place(dot.at);
    const double opacity = dot.hidden ? 0.5 : 1;
    const auto disk = [&](double radius) {
      cairo_new_sub_path(c_);
      cairo_arc(c_, p[0], p[1], radius, 0, 2 * M_PI);
    };
    cairo_set_line_width(c_, 1);
    disk(dot.missing ? 2.8 : 2.2);
    set(dot.missing ? Rgb{1, 1, 1} : dot.color, opacity);
    if (dot.missing) {
      cairo_fill_preserve(c_);
      set(dot.color, opacity);
      cairo_stroke(c_);
    } else {
      cairo_fill(c_);
    }
    if (dot.mark == Figure::Mark::isolated) {
      disk(4.6);
      set(dot.color, opacity);
      cairo_set_line_width(c_, 1.1);
      cairo_stroke(c_);
    }
  }

  /// Where a text may stand: in the middle of an area that is high enough for it, or beside a point.
  std::vector<Box> candidates(const Figure::Label& label, double width) const {
    const double height = 1.1 * kFont;
    std::vector<Box> out;
    for (const auto& from : label.places) {
      const Point2 p = place(from.at);
      if (from.room > 0) {
        if (from.room * scale_ >= 0.5 * height)
          out.push_back({p[0] - width / 2, p[1] - height / 2, width, height});
        continue;
      }
      constexpr double kGap = 4;
      for (const auto& [x, y] : {std::pair(1, -1), {-1, -1}, {1, 1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}}) {
        out.push_back({p[0] + x * (kGap + width / 2) - width / 2, p[1] + y * (kGap + height / 2) - height / 2,
                       width, height});
      }
    }
    return out;
  }
};

/// Areas in pixels, each `fine` times as fine, on the sheet.
void paint_areas_in_pixels(cairo_t* c, const std::vector<Panel>& panels, const Layout& layout, double per_unit) {
  constexpr int kFine = 4;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    // The panel's pixels, and one more on each side.
    const Box& box = layout.panels[i];
    const double x0 = std::floor(box.x * per_unit) - 1, y0 = std::floor(box.y * per_unit) - 1;
    const int width = static_cast<int>(std::ceil((box.x + box.width) * per_unit) + 1 - x0);
    const int height = static_cast<int>(std::ceil((box.y + box.height) * per_unit) + 1 - y0);
    const Surface fine = owned(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width * kFine, height * kFine));
    const Context onto = context_on(fine);
    cairo_scale(onto.get(), kFine, kFine);
    cairo_translate(onto.get(), -x0, -y0);
    cairo_scale(onto.get(), per_unit, per_unit);
    Painter(onto.get(), panels[i], box, layout).areas(true);
    cairo_save(c);
    cairo_identity_matrix(c);
    cairo_translate(c, x0, y0);
    cairo_scale(c, 1.0 / kFine, 1.0 / kFine);
    cairo_set_source_surface(c, fine.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(c), CAIRO_FILTER_GOOD);
    cairo_paint(c);
    cairo_restore(c);
  }
}

void paint(cairo_t* c, const std::vector<Panel>& panels, const Layout& layout, double pixels_per_unit) {
  cairo_set_source_rgb(c, 1, 1, 1);
  cairo_paint(c);
  if (pixels_per_unit > 0) paint_areas_in_pixels(c, panels, layout, pixels_per_unit);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    Painter painter(c, panels[i], layout.panels[i], layout);
    if (pixels_per_unit <= 0) painter.areas(false);
    painter.strokes();
    painter.dots();
    painter.labels();
    set_font(c);
    const double width = text_width(c, panels[i].caption);
    if (width > 0) painter.write(panels[i].caption, layout.captions[i][0] - width / 2, layout.captions[i][1]);
  }
  set_font(c);
  for (std::size_t i = 0; i < layout.keys.size(); ++i) {
    const auto& [color, text] = layout.keys[i];
    const auto& [x, y] = layout.key_places[i];
    cairo_rectangle(c, x, y - 0.82 * kFont, 0.95 * kFont, 0.95 * kFont);
    cairo_set_source_rgb(c, color[0], color[1], color[2]);
    cairo_fill_preserve(c);
    cairo_set_source_rgb(c, kInk[0], kInk[1], kInk[2]);
    cairo_set_line_width(c, 0.6);
    cairo_stroke(c);
    cairo_move_to(c, x + 1.5 * kFont, y);
    cairo_show_text(c, text.c_str());
  }
}

}  // namespace

bool is_picture(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".png" || extension == ".svg" || extension == ".pdf";
}

std::string picture_bytes(const std::string& path, const std::vector<Panel>& panels, const PictureSize& size) {
  const std::string extension = extension_of(path);
  require(is_picture(path), "picture_bytes: unknown extension");
  const Layout layout = lay_out(panels, size);
  const double width = std::ceil(layout.width), height = std::ceil(layout.height);
  std::string out;
  if (extension == ".png") {
    constexpr int kPixels = 2;
    const Surface surface = owned(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width) * kPixels,
                                                             static_cast<int>(height) * kPixels));
    const Context c = context_on(surface);
    cairo_scale(c.get(), kPixels, kPixels);
    paint(c.get(), panels, layout, kPixels);
    cairo_surface_flush(surface.get());
    require(cairo_surface_write_to_png_stream(surface.get(), append, &out) == CAIRO_STATUS_SUCCESS, "cairo: .png");
    return out;
  }
  const bool svg = extension == ".svg";
  Surface surface = owned(svg ? cairo_svg_surface_create_for_stream(append, &out, width, height)
                              : cairo_pdf_surface_create_for_stream(append, &out, width * 0.75, height * 0.75));
  if (svg) cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  else cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2012-01-01T00:00:00Z");
  {
    const Context c = context_on(surface);
    if (!svg) cairo_scale(c.get(), 0.75, 0.75);
    paint(c.get(), panels, layout, 0);
  }
  cairo_surface_finish(surface.get());
  if (cairo_surface_status(surface.get()) == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  require(cairo_surface_status(surface.get()) == CAIRO_STATUS_SUCCESS, "cairo: the picture is not whole");
  return out;
}

}  // namespace cnrg
