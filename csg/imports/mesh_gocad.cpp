// GOCAD's text files (.ts .pl .wl): surfaces, lines and wells, any number of objects in a file.
//
// An object is `GOCAD TYPE VERSION`, lines that begin with a word, and `END`. Most words are of no matter here
// (properties, colours, borders), new ones come with each version, so lines with unknown words are skipped. What
// must not be skipped over blindly are blocks in braces, whose lines begin with any word, and objects of other
// types (grids, voxets), whose VRTX may mean something else. Numbers of vertices count within their object.
//
// Depths: `ZPOSITIVE Depth` says that z grows downwards. It is negated then, in the whole object, so that surfaces
// of both kinds fit together; the order of corners stays, as seen from above.
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "csg/imports/text_cursor.h"

namespace cnrg {
namespace {

class GocadReader {
 public:
  GocadReader(const std::string& path, const std::string& text, bool decimal)
      : cursor_(path, text, '#'), decimal_(decimal) {}

  MeshData read() {
    while (cursor_.more()) read_object();
    if (known_objects_ == 0)
      cursor_.fail_at(1, "no object is a TSurf, PLine or Well: give a file of surfaces, lines or wells");
    if (next_group_ < 2) mesh_.groups.clear();
    return std::move(mesh_);
  }

 private:
  enum class Kind { surface, line, well, other };

  void read_object() {
    const std::string_view word = cursor_.token_in_line();
    object_line_ = cursor_.line();
    if (word != "GOCAD")
      cursor_.fail(in_quotes(word) + " where an object begins: `GOCAD TSurf 1`, for instance, is expected");
    const std::string_view type = cursor_.token_in_line();
    kind_ = type == "TSurf"   ? Kind::surface
            : type == "PLine" ? Kind::line
            : type == "Well"  ? Kind::well
                              : Kind::other;
    if (kind_ != Kind::other) ++known_objects_;
    cursor_.next_line();
    first_point_ = mesh_.point_count();
    first_exact_ = mesh_.exact.size();
    vertices_.clear();
    depth_ = in_group_ = false;
    has_reference_ = false;
    part_line_ = 0;
    stations_ = 0;
    for (;;) {
      if (!cursor_.more()) {
        cursor_.fail_at_end("the file ends within the object of line " + std::to_string(object_line_) +
                            ", which has no END");
      }
      const std::string_view key = cursor_.token_in_line();
      if (key == "END") break;
      if (key == "GOCAD") {
        cursor_.fail("an object begins, but that of line " + std::to_string(object_line_) +
                     " has no END: add it, or write the file again");
      }
      read_line(key);
      cursor_.next_line();
    }
    cursor_.next_line();
    end_part();
    if (kind_ == Kind::well && stations_ < 2) {
      cursor_.fail_at(object_line_, "a well with " + std::to_string(stations_) +
                                        (stations_ == 1 ? " point" : " points") +
                                        " of its path: give at least 2 as PATH or VRTX");
    }
    if (depth_) turn_upwards();
  }

  void read_line(std::string_view key) {
    if (key == "ZPOSITIVE") {
      read_direction();
    } else if (skip_block(key) || kind_ == Kind::other) {
      return;
    } else if (kind_ == Kind::well) {
      read_well_line(key);
    } else if (key == "VRTX" || key == "PVRTX") {
      read_vertex(key);
    } else if (key == "ATOM" || key == "PATOM") {
      read_atom(key);
    } else if (key == "TFACE" && kind_ == Kind::surface) {
      in_group_ = false;
    } else if (key == "TRGL" && kind_ == Kind::surface) {
      need(key, 3, "the numbers of three vertices");
      for (int k = 0; k < 3; ++k) mesh_.corners.push_back(known_vertex());
      mesh_.end_face();
      if (!in_group_) ++next_group_;
      in_group_ = true;
      mesh_.groups.push_back(next_group_ - 1);
    } else if (key == "ILINE" && kind_ == Kind::line) {
      end_part();
      part_line_ = cursor_.line();
      part_segments_ = mesh_.wires.size();
    } else if (key == "SEG" && kind_ == Kind::line) {
      need(key, 2, "the numbers of two vertices");
      const std::uint32_t a = known_vertex(), b = known_vertex();
      mesh_.wires.push_back({a, b});
    }
  }

  /// A line that is `WORD ... {` begins a block, up to a line with a brace that closes it.
  bool skip_block(std::string_view key) {
    const int line = cursor_.line();
    bool opens = false, closes = false;
    const auto look = [&](std::string_view token) {
      opens = opens || token.find('{') != std::string_view::npos;
      closes = closes || token.find('}') != std::string_view::npos;
    };
    look(key);
    if (!opens && !key.ends_with("HEADER")) return false;
    for (;;) {
      for (std::string_view t = cursor_.token_in_line(); !t.empty(); t = cursor_.token_in_line()) look(t);
      if (closes || !opens) return true;
      cursor_.next_line();
      if (!cursor_.more())
        cursor_.fail_at(line, "a block that is not closed: add a line with }, or write the file again");
    }
  }

  void read_direction() {
    need("ZPOSITIVE", 1, "Elevation or Depth");
    const std::string_view value = cursor_.token_in_line();
    if (value != "Depth" && value != "Elevation")
      cursor_.fail("ZPOSITIVE is " + in_quotes(value) + ": it must be Elevation or Depth");
    depth_ = value == "Depth";
  }

  void read_well_line(std::string_view key) {
    if (key == "WREF") {
      need(key, 3, "x, y and z");
      for (std::size_t k = 0; k < 3; ++k) reference_[k] = coordinate();
      has_reference_ = true;
    } else if (key == "VRTX") {
      need(key, 3, "x, y and z");
      RationalPoint p;
      for (Rational& x : p) x = coordinate();
      add_station(p);
    } else if (key == "PATH") {
      need(key, 4, "the measured depth, z, and x and y from WREF");
      if (!has_reference_) cursor_.fail("PATH counts x and y from WREF, which did not come before: add it");
      cursor_.number("the measured depth");
      const Rational z = coordinate(), dx = coordinate(), dy = coordinate();
      add_station({reference_[0] + dx, reference_[1] + dy, z});
    } else if (key == "STATION" || key == "TVSS_PATH" || key == "TVD_PATH" || key.starts_with("PATH_CURVE")) {
      cursor_.fail("a path given by " + std::string(key) + " is not read: export the well with PATH or VRTX");
    }
  }

  Rational coordinate() {
    Rational exact;
    if (decimal_) {
      cursor_.decimal("a coordinate", exact);
      return exact;
    }
    return from_double(cursor_.number("a coordinate"));
  }

  /// The next point of a well's path; sums are exact first, and then the doubles next to them unless decimals
  /// count.
  void add_station(const RationalPoint& p) {
    bool doubles = true;
    for (const Rational& x : p) {
      const double nearest = to_double(x);
      if (!std::isfinite(nearest)) cursor_.fail("a coordinate beyond the largest double: use a larger unit");
      mesh_.xyz.push_back(nearest);
      doubles = doubles && is_double(x);
    }
    const auto number = static_cast<std::uint32_t>(mesh_.point_count() - 1);
    if (decimal_ && !doubles) mesh_.exact.emplace_back(number, p);
    if (stations_++ > 0) mesh_.wires.push_back({number - 1, number});
  }

  void read_vertex(std::string_view key) {
    need(key, 4, "its number, x, y and z");
    const long long number = new_number();
    cursor_.coordinates(mesh_, decimal_);
    vertices_.emplace(number, Known{static_cast<std::uint32_t>(mesh_.point_count() - 1), cursor_.line()});
  }

  /// A vertex at the place of another one.
  void read_atom(std::string_view key) {
    need(key, 2, "its number and that of a vertex");
    const long long number = new_number();
    const std::uint32_t point = known_vertex();
    vertices_.emplace(number, Known{point, cursor_.line()});
  }

  long long new_number() {
    const long long number = cursor_.integer("the number of a vertex");
    if (const auto found = vertices_.find(number); found != vertices_.end()) {
      cursor_.fail("the vertex " + std::to_string(number) + " was given in line " +
                   std::to_string(found->second.line) + ": give it another number within this object");
    }
    return number;
  }

  std::uint32_t known_vertex() {
    const long long number = cursor_.integer("the number of a vertex");
    const auto found = vertices_.find(number);
    if (found == vertices_.end()) {
      cursor_.fail("the vertex " + std::to_string(number) + " did not come before in the object of line " +
                   std::to_string(object_line_) + ": correct the number");
    }
    return found->second.point;
  }

  /// Fails unless `count` words follow in this line.
  void need(std::string_view key, int count, const char* wanted) const {
    TextCursor probe = cursor_;
    for (int i = 0; i < count; ++i) {
      if (!probe.token_in_line().empty()) continue;
      cursor_.fail(std::string(key) + " has " + std::to_string(i) + (i == 1 ? " entry" : " entries") + ": give " +
                   wanted);
    }
  }

  void end_part() {
    if (part_line_ != 0 && mesh_.wires.size() == part_segments_)
      cursor_.fail_at(part_line_, "a line without segments: give them as SEG, or leave the ILINE out");
  }

  void turn_upwards() {
    for (std::size_t p = first_point_; p < mesh_.point_count(); ++p)
      mesh_.xyz[3 * p + 2] = 0 - mesh_.xyz[3 * p + 2];
    for (std::size_t i = first_exact_; i < mesh_.exact.size(); ++i)
      mesh_.exact[i].second[2] = -mesh_.exact[i].second[2];
  }

  struct Known {
    std::uint32_t point;
    int line;
  };

  TextCursor cursor_;
  bool decimal_;
  MeshData mesh_;
  std::size_t known_objects_ = 0;
  std::uint32_t next_group_ = 0;
  // Of the object:
  Kind kind_ = Kind::other;
  int object_line_ = 0;
  std::size_t first_point_ = 0, first_exact_ = 0;
  std::unordered_map<long long, Known> vertices_;
  bool depth_ = false, in_group_ = false;
  int part_line_ = 0;  // of the last ILINE
  std::size_t part_segments_ = 0;
  RationalPoint reference_;
  bool has_reference_ = false;
  std::size_t stations_ = 0;
};

}  // namespace

MeshData read_gocad(const std::string& path, const std::string& text, bool decimal) {
  return GocadReader(path, text, decimal).read();
}

}  // namespace cnrg
