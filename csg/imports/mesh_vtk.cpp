// VTK's legacy format (.vtk): a surface as POLYDATA, or as the cells without volume of an UNSTRUCTURED_GRID.
//
// The file is text, in lines that begin with a key; BINARY means that the numbers between these are big-endian
// bytes. So nothing says where a block of numbers ends but its count and type, and everything has to be understood
// to get past it: a reader that looked for the next key would find it in the middle of numbers. Version 5.1 has
// cells as two arrays, offsets and connectivity, where earlier ones have a list of counts and points. Names of
// arrays are encoded as in addresses (`%20`), words and keys are of any case.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "csg/imports/mesh_file.h"
#include "csg/imports/text_cursor.h"
#include "csg/imports/vtk_cells.h"
#include "csg/leaves/leaf.h"

namespace cnrg {
namespace {

/// What is in an array; `bits` are packed, `text` is a string each.
struct ArrayType {
  enum Kind { numbers, bits, text } kind = numbers;
  VtkType number = VtkType::float64;
};

class VtkReader {
 public:
  VtkReader(const std::string& path, const std::string& text, bool decimal)
      : path_(path), text_(text), decimal_(decimal), cursor_(path, text, 0) {}

  MeshData read() {
    read_header();
    while (cursor_.more()) {
      const std::string key = lower(cursor_.token_in_line());
      if (key == "points") read_points();
      else if (key == "field") read_field(false);
      else if (key == "metadata") skip_metadata();
      else if (key == "point_data" || key == "cell_data") read_attributes(key == "cell_data");
      else if (!(grid_ ? read_grid(key) : read_surface(key)))
        fail(in_quotes(key) + " is no part of a legacy VTK file that is known here: correct the file");
    }
    return collect();
  }

 private:
  [[noreturn]] void fail(const std::string& text) const { fail_at(here(), text); }
  struct Place {
    int line = 0;
    std::size_t byte = 0;
  };
  Place here() const { return {cursor_.line(), cursor_.offset()}; }
  [[noreturn]] void fail_at(const Place& at, const std::string& text) const {
    if (binary_) throw LeafFileError(path_, 0, 0, "byte " + std::to_string(at.byte) + ": " + text);
    cursor_.fail_at(at.line, text);
  }

  void read_header() {
    const std::string_view first = std::string_view(text_).substr(0, text_.find('\n'));
    constexpr std::string_view kMark = "# vtk DataFile Version ";
    if (!first.starts_with(kMark)) {
      cursor_.fail(
          "the file does not begin with '# vtk DataFile Version': it is no legacy VTK file; if it is one of "
          "XML, give it the extension .vtp");
    }
    const std::string_view number = first.substr(kMark.size());
    double version = 0;
    const auto end = std::from_chars(number.data(), number.data() + number.size(), version);
    if (end.ec != std::errc() || !(version > 0 && version < 5.2)) {
      cursor_.fail("the version " + in_quotes(number) + " is not known: write the file as 5.1 or 4.2");
    }
    arrays_of_cells_ = version >= 5;
    cursor_.next_line();
    cursor_.next_line();  // the title
    const std::string form = lower(cursor_.token("ASCII or BINARY"));
    if (form != "ascii" && form != "binary")
      cursor_.fail(in_quotes(form) + " is found where ASCII or BINARY is expected: correct the file");
    if (lower(cursor_.token("DATASET")) != "dataset")
      cursor_.fail("the key DATASET is expected here: correct the file");
    const std::string set = lower(cursor_.token("the kind of the data set"));
    if (set != "polydata" && set != "unstructured_grid") {
      cursor_.fail("a data set " + in_quotes(set) + " is no surface: write its surface as POLYDATA");
    }
    grid_ = set == "unstructured_grid";
    binary_ = form == "binary";
  }

  /// A count that the rest of the file has room for.
  std::size_t count(const char* wanted) {
    const long long n = cursor_.integer(wanted);
    if (n < 0 || static_cast<unsigned long long>(n) > 8 * text_.size()) {
      fail(std::string(wanted) + " is " + std::to_string(n) + ", which the file cannot hold: correct it");
    }
    return static_cast<std::size_t>(n);
  }

  ArrayType type() {
    const std::string name = lower(cursor_.token("the type of an array"));
    constexpr std::pair<std::string_view, VtkType> kTypes[] = {{"char", VtkType::int8},
                                                               {"signed_char", VtkType::int8},
                                                               {"unsigned_char", VtkType::uint8},
                                                               {"short", VtkType::int16},
                                                               {"unsigned_short", VtkType::uint16},
                                                               {"int", VtkType::int32},
                                                               {"unsigned_int", VtkType::uint32},
                                                               {"long", VtkType::int64},
                                                               {"unsigned_long", VtkType::uint64},
                                                               {"vtktypeint64", VtkType::int64},
                                                               {"vtktypeuint64", VtkType::uint64},
                                                               {"vtkidtype", VtkType::int32},
                                                               {"float", VtkType::float32},
                                                               {"double", VtkType::float64}};
    for (const auto& [known, number] : kTypes) {
      if (name == known) return {ArrayType::numbers, number};
    }
    if (name == "bit") return {ArrayType::bits, VtkType::uint8};
    if (name == "string" || name == "utf8_string") return {ArrayType::text, VtkType::uint8};
    fail(in_quotes(name) + " is no type of arrays that is read, such as float or int: leave that array out");
  }

  /// The bytes of so many items of a binary block, which begins in the next line.
  std::string_view block(std::size_t items, std::size_t size) {
    cursor_.next_line();
    return next_bytes(items, size);
  }
  std::string_view next_bytes(std::size_t items, std::size_t size) {
    const std::size_t left = text_.size() - cursor_.offset();
    if (left / size < items) fail("the file ends within its data: it is truncated, or a count is wrong");
    return cursor_.bytes(items * size);
  }

  /// So many numbers, whose line says so.
  VtkNumbers numbers(std::size_t n, VtkType type) {
    if (binary_) return numbers_of(block(n, size_of(type)), type, true);
    VtkNumbers found;
    found.whole = is_whole(type);
    for (std::size_t i = 0; i < n; ++i) {
      if (found.whole) found.integers.push_back(cursor_.integer("a whole number of the array"));
      else found.reals.push_back(cursor_.number("a number of the array"));
    }
    return found;
  }

  void skip(std::size_t n, ArrayType type) {
    if (type.kind == ArrayType::text) return skip_strings(n);
    if (type.kind == ArrayType::bits) n = binary_ ? (n + 7) / 8 : n;
    if (binary_) block(n, size_of(type.number));
    else
      for (std::size_t i = 0; i < n; ++i) cursor_.token("a value");
  }

  /// A line each; in a binary file bytes, behind their number in one, two, four or eight bytes, of which the first
  /// two bits say how many.
  void skip_strings(std::size_t n) {
    cursor_.next_line();
    for (std::size_t i = 0; i < n; ++i) {
      if (!binary_) {
        cursor_.next_line();
        continue;
      }
      const auto first = static_cast<unsigned char>(next_bytes(1, 1)[0]);
      std::uint64_t length = first & 63;
      const int more = (1 << (3 - (first >> 6))) - 1;
      for (int k = 0; k < more; ++k) length = length << 8 | static_cast<unsigned char>(next_bytes(1, 1)[0]);
      next_bytes(length, 1);
    }
  }

  void read_points() {
    if (has_points_) fail("the file has POINTS twice: leave out one list");
    has_points_ = true;
    const std::size_t n = count("the number of points");
    const ArrayType of = type();
    if (of.kind != ArrayType::numbers) fail("points are numbers: give a type such as double");
    MeshData& mesh = collector_.mesh;
    if (!binary_) {
      for (std::size_t i = 0; i < n; ++i) cursor_.coordinates(mesh, decimal_);
      return;
    }
    const Place begin = here();
    const VtkNumbers found = numbers(3 * n, of.number);
    for (std::size_t i = 0; i < 3 * n; ++i) {
      mesh.xyz.push_back(found.whole ? static_cast<double>(found.integers[i]) : found.reals[i]);
      if (std::isfinite(mesh.xyz.back())) continue;
      fail_at(begin, "point " + std::to_string(i / 3) + " has a coordinate that is no finite number: correct it");
    }
  }

  /// Where a list of cells stands, for what is wrong with them.
  struct Cells {
    VtkCells list;
    Place place;
  };

  Cells read_cells() {
    Cells cells{{}, here()};
    const std::size_t n = count("the number of cells"), size = count("the size of a list of cells");
    if (arrays_of_cells_) read_arrays(n, size, cells);
    else read_list(n, size, cells);
    return cells;
  }

  void read_arrays(std::size_t n, std::size_t size, Cells& cells) {
    if (n == 0) return;
    const auto array = [&](const char* key, std::size_t length) {
      if (lower(cursor_.token(key)) != lower(key))
        fail(std::string("the key ") + key + " is expected here: correct the file");
      const ArrayType of = type();
      if (of.kind != ArrayType::numbers || !is_whole(of.number))
        fail("cells are lists of whole numbers: correct the type of the array");
      return numbers(length, of.number).integers;
    };
    cells.list.offsets = array("OFFSETS", n);
    cells.list.connectivity = array("CONNECTIVITY", size);
    const auto& offsets = cells.list.offsets;
    if (offsets.front() != 0 || offsets.back() != static_cast<std::int64_t>(size) ||
        !std::is_sorted(offsets.begin(), offsets.end())) {
      fail_at(cells.place, "the offsets of cells must rise from 0 to " + std::to_string(size) +
                               ", the length of their connectivity: correct them");
    }
  }

  /// Of each cell the number of its points and these.
  void read_list(std::size_t n, std::size_t size, Cells& cells) {
    const std::vector<std::int64_t> all = numbers(size, VtkType::int32).integers;
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (at == all.size() || all[at] < 0 || static_cast<std::uint64_t>(all[at]) > all.size() - at - 1) {
        fail_at(cells.place, "cell " + std::to_string(i) +
                                 " of a list is longer than the rest of it: correct "
                                 "its number of points, or the size of the list");
      }
      const std::size_t end = at + 1 + std::size_t(all[at]);
      cells.list.connectivity.insert(cells.list.connectivity.end(), all.begin() + std::ptrdiff_t(at + 1),
                                     all.begin() + std::ptrdiff_t(end));
      cells.list.offsets.push_back(std::int64_t(cells.list.connectivity.size()));
      at = end;
    }
    if (at != all.size()) {
      fail_at(cells.place, "a list of " + std::to_string(n) + " cells has " + std::to_string(at) +
                               " numbers, and its size is given as " + std::to_string(size) +
                               ": correct the size");
    }
  }

  bool read_surface(const std::string& key) {
    constexpr std::string_view kKeys[] = {"vertices", "lines", "polygons", "triangle_strips"};
    const auto kind = std::find(std::begin(kKeys), std::end(kKeys), key) - std::begin(kKeys);
    if (kind == std::ssize(kKeys)) return false;
    auto& cells = cells_[std::size_t(kind)];
    if (cells.list.size() > 0) fail("the file has " + in_quotes(key) + " twice: leave out one list");
    cells = read_cells();
    return true;
  }

  bool read_grid(const std::string& key) {
    if (key == "cells") {
      cells_[0] = read_cells();
    } else if (key == "cell_types") {
      types_place_ = here();
      types_ = numbers(count("the number of cells"), VtkType::int32).integers;
    } else {
      return false;
    }
    return true;
  }

  std::size_t cell_count() const {
    std::size_t n = 0;
    for (const Cells& cells : cells_) n += cells.list.size();
    return n;
  }

  void read_attributes(bool of_cells) {
    const std::size_t n = count("the number of values");
    if (of_cells && n != cell_count()) {
      fail("CELL_DATA is of " + std::to_string(n) + " cells, and the file has " + std::to_string(cell_count()) +
           ": correct the number");
    }
    constexpr std::pair<std::string_view, std::size_t> kVectors[] = {
        {"vectors", 3},    {"normals", 3},      {"tensors", 9},   {"tensors6", 6},
        {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
    while (cursor_.more()) {
      const std::string key = lower(cursor_.token_in_line());
      const auto vector =
          std::find_if(std::begin(kVectors), std::end(kVectors), [&](auto& v) { return v.first == key; });
      if (key == "point_data" || key == "cell_data") return read_attributes(key == "cell_data");
      if (key == "field") {
        read_field(of_cells);
      } else if (key == "metadata") {
        skip_metadata();
      } else if (key == "scalars") {
        read_scalars(n, of_cells);
      } else if (key == "lookup_table") {
        cursor_.token("a name");
        const std::size_t colors = count("the number of colours");
        skip(4 * colors, {ArrayType::numbers, VtkType::uint8});
      } else if (key == "color_scalars") {
        cursor_.token("a name");
        components_ = count("the number of values");
        skip(components_ * n, {ArrayType::numbers, VtkType::uint8});
      } else if (key == "texture_coordinates") {
        cursor_.token("a name");
        components_ = count("the number of coordinates");
        skip(components_ * n, type());
      } else if (vector != std::end(kVectors)) {
        const std::string name(cursor_.token("a name"));
        components_ = vector->second;
        take(name, n, type(), of_cells);
      } else {
        fail(in_quotes(key) + " is no attribute of a legacy VTK file: correct the file");
      }
    }
  }

  /// `SCALARS name type [components]`, and in the next line `LOOKUP_TABLE name`.
  void read_scalars(std::size_t n, bool of_cells) {
    const std::string name(cursor_.token("a name"));
    const ArrayType of = type();
    components_ = cursor_.more_in_line() ? count("the number of components") : 1;
    if (lower(cursor_.token("LOOKUP_TABLE")) != "lookup_table")
      fail("the key LOOKUP_TABLE is expected here: correct the file");
    cursor_.token("the name of a lookup table");
    take(name, n, of, of_cells);
  }

  void read_field(bool of_cells) {
    cursor_.token("the name of a field");
    for (std::size_t n = count("the number of arrays"); n > 0; --n) {
      const std::string name(cursor_.token("the name of an array"));
      if (lower(name) == "metadata") {  // of the array before
        skip_metadata();
        ++n;
        continue;
      }
      if (name == "NULL_ARRAY") continue;
      components_ = count("the number of components");
      const std::size_t tuples = count("the number of values");
      take(name, tuples, type(), of_cells);
    }
  }

  /// An array of `components_` for each of n; kept if it labels the cells.
  void take(const std::string& name, std::size_t n, ArrayType of, bool of_cells) {
    if (components_ != 0 && n > 8 * text_.size() / components_)
      fail("an array is longer than the file: correct it");
    const bool labels = of_cells && !labels_ && components_ == 1 && n == cell_count() &&
                        of.kind == ArrayType::numbers && MeshLabels::is_label(name);
    if (labels) labels_ = numbers(n, of.number);
    else skip(components_ * n, of);
  }

  /// Up to an empty line; names of components, one to a line, may be empty themselves.
  void skip_metadata() {
    for (cursor_.next_line(); cursor_.more_in_line(); cursor_.next_line()) {
      if (lower(cursor_.token_in_line()) != "component_names") continue;
      for (std::size_t k = 0; k < components_; ++k) cursor_.next_line();
    }
  }

  MeshData collect() {
    const auto fail_in = [&](const Cells& cells) {
      return [&](const std::string& text) { fail_at(cells.place, text); };
    };
    collector_.take_labels(std::move(labels_));
    if (!grid_) {
      constexpr VtkKind kKinds[] = {VtkKind::vertices, VtkKind::lines, VtkKind::polygons, VtkKind::strips};
      for (std::size_t k = 0; k < 4; ++k) collector_.add(kKinds[k], cells_[k].list, 0, fail_in(cells_[k]));
      return collector_.finish();
    }
    const VtkCells& cells = cells_[0].list;
    const auto fail_types = [&](const std::string& text) { fail_at(types_place_, text); };
    if (types_.size() != cells.size()) {
      fail_types("there are " + std::to_string(cells.size()) + " cells and " + std::to_string(types_.size()) +
                 " CELL_TYPES: correct the file");
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto begin = std::size_t(cells.offsets[i]);
      std::vector<std::int64_t> points(cells.connectivity.begin() + std::ptrdiff_t(begin),
                                       cells.connectivity.begin() + std::ptrdiff_t(cells.offsets[i + 1]));
      collector_.add(kind_of_cell(types_[i], i, points, fail_types), points, 0, i, fail_in(cells_[0]));
    }
    return collector_.finish();
  }

  const std::string& path_;
  const std::string& text_;
  bool decimal_;
  TextCursor cursor_;
  bool binary_ = false, grid_ = false, arrays_of_cells_ = false, has_points_ = false;
  std::array<Cells, 4> cells_;  ///< by kind; of a grid the first has all
  std::vector<std::int64_t> types_;
  Place types_place_;
  std::size_t components_ = 1;  ///< of the array that came last
  std::optional<VtkNumbers> labels_;
  VtkCollector collector_;
};

}  // namespace

MeshData read_vtk(const std::string& path, const std::string& text, bool decimal) {
  return VtkReader(path, text, decimal).read();
}

}  // namespace cnrg
