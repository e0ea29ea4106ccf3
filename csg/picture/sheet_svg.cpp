// SVG by hand, and not by cairo, which can write it, too: cairo's text is outlines of letters, which nobody can
// find, copy or read aloud, and it repeats all properties with every path. Here texts are texts, in the font of
// the reader's machine if it has not ours (they are centered, so that a little more or less of width does no
// harm); places are whole tenths of a unit, relative to the last one; and paths of one look that follow each other
// are one. A page of a paper is some kilobytes and differs from the next one only where the model does.
#include <cmath>
#include <cstdint>

#include "csg/picture/sheet.h"
#include "csg/text/xml.h"

namespace cnrg {
namespace {

constexpr double kUnits = 10;  // of the file, for one of the page

std::int64_t units(double length) { return std::llround(length * kUnits); }

std::string color_text(const Rgb& color) {
  const std::string text = hex(color);
  const bool doubled = text[1] == text[2] && text[3] == text[4] && text[5] == text[6];
  return doubled ? std::string{'#', text[1], text[3], text[5]} : text;
}

/// A number from 0 to 1 in hundredths.
std::string share(double x) {
  const std::string digits = std::to_string(std::llround(x * 100));
  return (digits.size() < 2 ? ".0" : ".") + digits;
}

/// Data of a path, all of it relative. Each subpath begins where the last one did, if that was closed, and else
/// where it ended; the first one at the origin.
class Path {
 public:
  void add(const std::vector<Point2>& points, bool closed) {
    const std::size_t before = text_.size();
    bool first = true;
    std::int64_t begin[2] = {at_[0], at_[1]};
    int count = 0;
    for (const Point2& p : points) {
      const std::int64_t x = units(p[0]), y = units(p[1]);
      if (!first && x == at_[0] && y == at_[1]) continue;  // closer than the file can say
      append(first ? 'm' : 0, x - at_[0], y - at_[1]);
      at_[0] = x;
      at_[1] = y;
      if (first) {
        begin[0] = x;
        begin[1] = y;
      }
      first = false;
      ++count;
    }
    if (count == 0) return;
    if (count == 1 && closed) {  // an area that is smaller than the file can say
      text_.resize(before);
      at_[0] = at_[1] = 0;
      if (before != 0) restore();
      return;
    }
    if (count == 1) text_ += "h0";  // a line of no length is a dot, if its ends are round
    if (closed) {
      text_ += 'z';
      at_[0] = begin[0];
      at_[1] = begin[1];
    }
    kept_[0] = at_[0];
    kept_[1] = at_[1];
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::int64_t at_[2] = {0, 0}, kept_[2] = {0, 0};

  void restore() {
    at_[0] = kept_[0];
    at_[1] = kept_[1];
  }
  void append(char command, std::int64_t dx, std::int64_t dy) {
    if (command != 0) text_ += command;
    else if (dx >= 0) text_ += ' ';
    text_ += std::to_string(dx);
    if (dy >= 0) text_ += ' ';
    text_ += std::to_string(dy);
  }
};

class Writer {
 public:
  explicit Writer(const PaperSheet& sheet) : sheet_(sheet) {}

  std::string text() {
    const std::string width = std::to_string(std::llround(sheet_.width));
    const std::string height = std::to_string(std::llround(sheet_.height));
    std::string body;
    areas(body);
    lines(body);
    disks(body);
    texts(body);
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                       "\" viewBox=\"0 0 " + std::to_string(units(sheet_.width)) + " " +
                       std::to_string(units(sheet_.height)) + "\" role=\"img\"";
    if (!sheet_.title.empty()) text += " aria-label=\"" + in_xml(sheet_.title) + "\"";
    text += ">\n";
    if (!patterns_.empty()) text += "<defs>\n" + patterns_ + "</defs>\n";
    return text + "<path d=\"M0 0h" + std::to_string(units(sheet_.width)) + "v" +
           std::to_string(units(sheet_.height)) + "H0z\" fill=\"" + color_text(kPaper) + "\"/>\n" + body +
           "</svg>\n";
  }

 private:
  const PaperSheet& sheet_;
  std::string patterns_;
  std::vector<PaperSheet::Area> looks_;  // that have a pattern

  /// The paint of a pattern, which is defined when it is first asked for.
  std::string pattern(const PaperSheet::Area& area) {
    std::size_t i = 0;
    while (i < looks_.size() && !same_look(looks_[i], area)) ++i;
    const std::string name = "p" + std::to_string(i);
    if (i == looks_.size()) {
      looks_.push_back({{}, area.color, area.pattern, area.lines});
      const bool hatch = area.pattern == PaperSheet::Pattern::hatch;
      const std::int64_t step = units(hatch ? kHatchStep : kWeaveStep);
      const std::string s = std::to_string(step);
      // A line through the tile and those of its neighbours that reach into its corners.
      const std::string diagonals = hatch ? "M0 " + s + "L" + s + " 0M-9 9L9-9M" + std::to_string(step - 9) + " " +
                                                std::to_string(step + 9) + "l18-18"
                                          : "M0 0L" + s + " " + s + "M" + std::to_string(step - 9) +
                                                "-9l18 18M-9 " + std::to_string(step - 9) + "l18 18";
      patterns_ += "<pattern id=\"" + name + "\" width=\"" + s + "\" height=\"" + s +
                   "\" patternUnits=\"userSpaceOnUse\"><path d=\"M0 0h" + s + "v" + s + "H0z\" fill=\"" +
                   color_text(area.color) + "\"/><path d=\"" + diagonals + "\" stroke=\"" +
                   color_text(area.lines) + "\" stroke-width=\"" +
                   std::to_string(units(hatch ? kHatchWidth : kWeaveWidth)) + "\"/></pattern>\n";
    }
    return "url(#" + name + ")";
  }

  void areas(std::string& out) {
    if (sheet_.areas.empty()) return;
    out += "<g fill-rule=\"evenodd\" stroke-width=\"" + std::to_string(units(kSeam)) +
           "\" stroke-linejoin=\"round\">\n";
    for (std::size_t i = 0; i < sheet_.areas.size();) {
      const PaperSheet::Area& first = sheet_.areas[i];
      Path path;
      for (; i < sheet_.areas.size() && same_look(first, sheet_.areas[i]); ++i) {
        for (const auto& loop : sheet_.areas[i].loops) path.add(loop, true);
      }
      if (path.text().empty()) continue;
      const std::string plain = color_text(first.color);
      const std::string fill = first.pattern == PaperSheet::Pattern::plain ? plain : pattern(first);
      out += "<path fill=\"" + fill + "\" stroke=\"" + plain + "\" d=\"" + path.text() + "\"/>\n";
    }
    out += "</g>\n";
  }

  void lines(std::string& out) {
    if (sheet_.lines.empty()) return;
    out += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (std::size_t i = 0; i < sheet_.lines.size();) {
      const PaperSheet::Look& look = sheet_.lines[i].look;
      Path path;
      for (; i < sheet_.lines.size() && sheet_.lines[i].look == look; ++i) {
        path.add(sheet_.lines[i].points, sheet_.lines[i].closed);
      }
      if (path.text().empty()) continue;
      out += "<path stroke=\"" + color_text(look.color) + "\" stroke-width=\"" +
             std::to_string(units(look.width)) + "\"";
      if (look.opacity < 1) out += " stroke-opacity=\"" + share(look.opacity) + "\"";
      if (look.dash > 0) {
        out += " stroke-linecap=\"butt\" stroke-dasharray=\"" + std::to_string(units(look.dash)) + " " +
               std::to_string(units(look.gap)) + "\"";
      }
      out += " d=\"" + path.text() + "\"/>\n";
    }
    out += "</g>\n";
  }

  void disks(std::string& out) const {
    for (const PaperSheet::Disk& disk : sheet_.disks) {
      out += "<circle cx=\"" + std::to_string(units(disk.at[0])) + "\" cy=\"" + std::to_string(units(disk.at[1])) +
             "\" r=\"" + std::to_string(units(disk.radius)) + "\" fill=\"" +
             (disk.inside ? color_text(*disk.inside) : std::string("none")) + "\"";
      if (disk.opacity < 1) out += " opacity=\"" + share(disk.opacity) + "\"";
      if (disk.ring > 0) {
        out +=
            " stroke=\"" + color_text(disk.color) + "\" stroke-width=\"" + std::to_string(units(disk.ring)) + "\"";
      }
      out += "/>\n";
    }
  }

  void texts(std::string& out) const {
    if (sheet_.texts.empty()) return;
    // The halo is a line around the letters, which are painted over it.
    out += "<g font-family=\"DejaVu Sans,Verdana,sans-serif\" text-anchor=\"middle\" fill=\"" + color_text(kInk) +
           "\" stroke-width=\"" + std::to_string(units(kHalo)) +
           "\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n";
    for (const PaperSheet::Text& text : sheet_.texts) {
      out += "<text x=\"" + std::to_string(units(text.middle[0])) + "\" y=\"" +
             std::to_string(units(text.middle[1] + kHalfLetter * text.size)) + "\" font-size=\"" +
             std::to_string(units(text.size)) + "\"" +
             (text.halo ? " stroke=\"" + color_text(kPaper) + "\" stroke-opacity=\".8\"" : "") + ">" +
             in_xml(text.text) + "</text>\n";
    }
    out += "</g>\n";
  }
};

}  // namespace

std::string svg_text(const PaperSheet& sheet) { return Writer(sheet).text(); }

}  // namespace cnrg
