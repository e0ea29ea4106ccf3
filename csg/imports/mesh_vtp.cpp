// VTK's XML of surfaces (.vtp): pieces of points, verts, lines, strips and polys, each an array of numbers; and of
// unstructured grids (.vtu): of these the cells without volume.
//
// A .vtu of our own says its cells twice: the faces, and each region by the triangles around it, outward. The
// latter are the solids, and of the faces those that bound no region go with them.
//
// Arrays are text, base64 in the place of the text, or a part of one block at the end of the file, which may be
// raw bytes: then the file is no XML from there on. So the parser (expat) is stopped at the tag that opens this
// block, and everything before it is a small tree of elements. Bytes have a header of their own: their number, or,
// where they are compressed by zlib, the number and the sizes of blocks. In base64 the header may be encoded by
// itself, with padding in the middle of the letters.

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "csg/imports/little_endian.h"
#include "csg/imports/mesh_file.h"
#include "csg/imports/text_cursor.h"
#include "csg/imports/vtk_cells.h"
#include "csg/imports/xml_events.h"
#include "csg/leaves/leaf.h"

namespace cnrg {
namespace {

// The bytes of an array in VTK's XML.
//
// A header tells how many bytes come, and a damaged one any number. So no memory is taken for bytes that cannot be
// there: raw ones must be in the file, and zlib makes at most 1032 bytes of one.

struct VtkCoding {
  std::size_t header = 4;   ///< bytes of a number of a header
  bool big_endian = false;  ///< such numbers
  bool compressed = false;  ///< by zlib
};

/// Why bytes are none: `is cut off: ...`, to follow the name of the array.
class VtkBytesFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

constexpr const char* kTruncated = "is cut off: the file is truncated, or damaged; write it again";

/// Bytes one after the other, as they are or out of base64.
class Source {
 public:
  Source(std::string_view data, bool base64) : data_(data), base64_(base64) {}

  /// The next n; a fault if there are fewer.
  std::string take(std::size_t n) {
    if (n > left()) throw VtkBytesFault(kTruncated);
    std::string bytes;
    if (!base64_) {
      bytes = data_.substr(at_, n);
      at_ += n;
      return bytes;
    }
    bytes.reserve(n);
    while (bytes.size() < n) {
      if (waiting_.empty()) read_group();
      const std::size_t some = std::min(n - bytes.size(), waiting_.size());
      bytes.append(waiting_, 0, some);
      waiting_.erase(0, some);
    }
    return bytes;
  }
  /// No fewer bytes than there are.
  std::size_t left() const {
    return base64_ ? waiting_.size() + (data_.size() - at_) / 4 * 3 + 3 : data_.size() - at_;
  }

 private:
  std::string_view data_;
  bool base64_;
  std::size_t at_ = 0;
  std::string waiting_;  ///< of the last group of letters

  static int digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
  }

  /// Four letters, up to two of which are padding.
  void read_group() {
    std::uint32_t group = 0;
    std::size_t letters = 0, padding = 0;
    for (; letters + padding < 4; ++at_) {
      if (at_ == data_.size()) throw VtkBytesFault(kTruncated);
      const char c = data_[at_];
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
      if (c == '=' && letters >= 2) {
        ++padding;
        group <<= 6;
        continue;
      }
      const int value = digit(c);
      if (value < 0 || padding > 0)
        throw VtkBytesFault("has letters that are not of base64: write the file again");
      group = group << 6 | static_cast<std::uint32_t>(value);
      ++letters;
    }
    for (std::size_t k = 0; k + 1 < letters; ++k) waiting_ += static_cast<char>(group >> (16 - 8 * k) & 0xff);
  }
};

std::uint64_t header_number(Source& source, const VtkCoding& coding) {
  return number_of_bytes(source.take(coding.header), 0, coding.header, coding.big_endian);
}

void check_size(std::uint64_t blocks, std::uint64_t size, std::uint64_t last, std::size_t most) {
  if (last <= most && (blocks < 2 || size <= (most - last) / (blocks - 1))) return;
  throw VtkBytesFault("has far more bytes than the numbers of points and cells say: correct them");
}

/// The bytes of the array whose header begins `data`; more may follow. Throws VtkBytesFault, also where
/// more than `most` bytes are packed, before memory is taken for them.
std::string decoded(std::string_view data, bool base64, const VtkCoding& coding, std::size_t most) {
  Source source(data, base64);
  if (!coding.compressed) return source.take(header_number(source, coding));
  const std::uint64_t blocks = header_number(source, coding);
  if (blocks == 0) return {};
  const std::uint64_t size = header_number(source, coding), last = header_number(source, coding);
  if (blocks > source.left() / coding.header) throw VtkBytesFault(kTruncated);
  check_size(blocks, size, last != 0 ? last : size, most);
  std::vector<std::uint64_t> packed;
  for (std::uint64_t i = 0; i < blocks; ++i) packed.push_back(header_number(source, coding));
  std::string bytes;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t expected = i + 1 == blocks && last != 0 ? last : size;
    const std::string block = source.take(packed[i]);
    if (expected / 1100 > block.size())
      throw VtkBytesFault("has a block that zlib cannot have made: write it again");
    const std::size_t before = bytes.size();
    bytes.resize(before + expected);
    uLongf made = expected;
    const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data() + before), &made,
                                  reinterpret_cast<const Bytef*>(block.data()), block.size());
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status != Z_OK || made != expected)
      throw VtkBytesFault("has a damaged block of zlib: write the file again");
  }
  return bytes;
}

struct XmlElement {
  std::string name;
  XmlAttributes attributes;
  std::vector<std::unique_ptr<XmlElement>> children;
  std::string text;  ///< of its own, not of its children
  int line = 0, text_line = 0;

  std::string attribute(const char* key, const char* otherwise = "") const {
    const auto found = attributes.find(key);
    return found == attributes.end() ? otherwise : found->second;
  }
  const XmlElement* child(const char* wanted) const {
    for (const auto& c : children) {
      if (c->name == wanted) return c.get();
    }
    return nullptr;
  }
};

[[noreturn]] void fail_at(const std::string& path, int line, const std::string& text) {
  throw LeafFileError(path, line, 0, text);
}

/// The elements of a file up to its appended data.
class XmlTree : XmlEvents {
 public:
  XmlTree(const std::string& path, const std::string& text) : path_(path) {
    parse(text);
    if (!root_) fail_at(path_, 1, "the file has no element: it is no XML of VTK");
  }

  const XmlElement& root() const { return *root_; }
  /// Where the data behind the tag `AppendedData` begin; no number if there is none.
  std::optional<std::size_t> appended() const { return appended_; }

 private:
  static constexpr std::size_t kDeepest = 30;  // VTK's own files have ten

  const std::string& path_;
  std::unique_ptr<XmlElement> root_;
  std::vector<XmlElement*> open_;
  std::optional<std::size_t> appended_;

  int line_number() const { return static_cast<int>(line()); }
  void fail_as_no_xml(const std::string& fault) const override {
    fail_at(path_, line_number(), fault + "; write the file again");
  }
  void refuse_doctype() const override {
    fail_at(path_, line_number(), "files of VTK have no DOCTYPE, which may name other files: leave it out");
  }
  void end() override { open_.pop_back(); }
  void characters(std::string_view text) override {
    XmlElement& element = *open_.back();
    if (element.text.empty()) element.text_line = line_number();
    element.text += text;
  }
  void begin(const char* name, XmlAttributes attributes) override {
    if (open_.size() == kDeepest) fail_at(path_, line_number(), "elements are nested too deep for a file of VTK");
    auto element = std::make_unique<XmlElement>();
    element->name = name;
    element->line = line_number();
    element->attributes = std::move(attributes);
    XmlElement* const made = element.get();
    if (open_.empty()) root_ = std::move(element);
    else open_.back()->children.push_back(std::move(element));
    open_.push_back(made);
    if (made->name != "AppendedData") return;
    appended_ = end_of_event();
    stop();
  }
};

class VtpReader {
 public:
  VtpReader(const std::string& path, const std::string& text, bool decimal)
      : path_(path), text_(text), decimal_(decimal), tree_(path, text) {}

  MeshData read() {
    const XmlElement& root = tree_.root();
    read_head(root);
    const std::string type = root.attribute("type");
    const XmlElement* data = root.child(type.c_str());
    if (data == nullptr) fail(root, "the file has no element " + type + ": write the surface again");
    for (const auto& piece : data->children) {
      if (piece->name == "Piece") (type == "PolyData" ? read_piece(*piece) : read_grid(*piece));
    }
    return collector_.finish();
  }

 private:
  static constexpr std::size_t kSlack = 1'000'000;
  static constexpr std::int64_t kMostPacked = 1100;  // numbers; bytes that zlib makes of one

  const std::string& path_;
  const std::string& text_;
  bool decimal_;
  XmlTree tree_;
  VtkCoding coding_;
  std::string_view appended_;
  bool appended_raw_ = false;
  VtkCollector collector_;

  [[noreturn]] void fail(const XmlElement& element, const std::string& text) const {
    fail_at(path_, element.line, text);
  }

  void read_head(const XmlElement& root) {
    if (root.name != "VTKFile")
      fail(root, "the element " + in_quotes(root.name) + " is no VTKFile: it is no file of VTK");
    if (const std::string type = root.attribute("type"); type != "PolyData" && type != "UnstructuredGrid") {
      fail(root, "a VTKFile of type " + in_quotes(type) + " is no surface: write its surface as PolyData");
    }
    const std::string order = root.attribute("byte_order", "LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian") {
      fail(root, "the byte_order " + in_quotes(order) + " is neither LittleEndian nor BigEndian: correct it");
    }
    coding_.big_endian = order == "BigEndian";
    const std::string header = root.attribute("header_type", "UInt32");
    if (header != "UInt32" && header != "UInt64") {
      fail(root, "the header_type " + in_quotes(header) + " is neither UInt32 nor UInt64: correct it");
    }
    coding_.header = header == "UInt64" ? 8 : 4;
    const std::string compressor = root.attribute("compressor");
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
      fail(root, "the compressor " + in_quotes(compressor) +
                     " is not read: write the file with vtkZLibDataCompressor, or "
                     "without compression");
    }
    coding_.compressed = !compressor.empty();
    if (!tree_.appended()) return;
    const XmlElement* const found = root.child("AppendedData");
    if (found == nullptr) fail(root, "AppendedData stands inside of another element: it comes last in VTKFile");
    const XmlElement& block = *found;
    const std::string encoding = block.attribute("encoding");
    if (encoding != "raw" && encoding != "base64") {
      fail(block,
           "the encoding " + in_quotes(encoding) + " of AppendedData is neither raw nor base64: correct it");
    }
    appended_raw_ = encoding == "raw";
    const std::size_t mark = text_.find_first_not_of(" \t\r\n", *tree_.appended());
    if (mark == std::string::npos || text_[mark] != '_') {
      fail(block, "AppendedData does not begin with an underscore: write the file again");
    }
    appended_ = std::string_view(text_).substr(mark + 1);
    if (!appended_raw_) appended_ = appended_.substr(0, appended_.find('<'));
  }

  std::size_t count(const XmlElement& element, const char* key) const {
    const std::string word = element.attribute(key, "0");
    std::size_t n = 0;
    const auto end = std::from_chars(word.data(), word.data() + word.size(), n);
    if (end.ec != std::errc() || end.ptr != word.data() + word.size() || n > 0xffffffff) {
      fail(element, std::string(key) + " is " + in_quotes(word) + ", which is no number of them: correct it");
    }
    return n;
  }

  void read_piece(const XmlElement& piece) {
    const std::size_t first = collector_.mesh.point_count(), n = count(piece, "NumberOfPoints");
    if (n > 0) read_points(piece, n);
    constexpr std::pair<const char*, const char*> kLists[] = {{"NumberOfVerts", "Verts"},
                                                              {"NumberOfLines", "Lines"},
                                                              {"NumberOfPolys", "Polys"},
                                                              {"NumberOfStrips", "Strips"}};
    constexpr VtkKind kKinds[] = {VtkKind::vertices, VtkKind::lines, VtkKind::polygons, VtkKind::strips};
    std::size_t cells = 0;
    for (const auto& list : kLists) cells += count(piece, list.first);
    collector_.take_labels(labels(piece, cells));
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t of_kind = count(piece, kLists[k].first);
      if (of_kind == 0) continue;
      const XmlElement* list = piece.child(kLists[k].second);
      if (list == nullptr)
        fail(piece, std::string("the piece has no element ") + kLists[k].second + ": write it again");
      collector_.add(kKinds[k], read_cells(*list, of_kind), first,
                     [&](const std::string& text) { fail(*list, text); });
    }
  }

  void read_grid(const XmlElement& piece) {
    const std::size_t first = collector_.mesh.point_count(), n = count(piece, "NumberOfPoints");
    if (n > 0) read_points(piece, n);
    const std::size_t size = count(piece, "NumberOfCells");
    const XmlElement* list = piece.child("Cells");
    if (list == nullptr) fail(piece, "the piece has no element Cells: write it again");
    const VtkCells cells = read_cells(*list, size);
    const std::vector<std::int64_t> types = integers(*list, "types", size);
    if (types.size() != size) {
      fail(*list, "there are " + std::to_string(types.size()) + " types of " + std::to_string(size) +
                      " cells: correct their number");
    }
    const auto fail_here = [&](const std::string& text) { fail(*list, text); };
    const std::vector<char> taken = taken_cells(piece, size);
    std::optional<VtkNumbers> of_cells = labels(piece, size);
    for (std::size_t i = 0; i < size; ++i) {
      std::vector<std::int64_t> points(cells.connectivity.begin() + cells.offsets[i],
                                       cells.connectivity.begin() + cells.offsets[i + 1]);
      const VtkKind kind = kind_of_cell(types[i], i, points, fail_here);
      if (taken[i] == 0) continue;
      collector_.take_labels(of_cells ? std::optional(of_cells->one(i)) : std::nullopt);
      collector_.add(kind, points, first, i, fail_here);
    }
  }

  /// Of a grid of our own, what does not bound a region twice; else all cells.
  std::vector<char> taken_cells(const XmlElement& piece, std::size_t size) const {
    std::vector<char> taken(size, 1);
    const XmlElement* data = piece.child("CellData");
    if (data == nullptr) return taken;
    const auto array = [&](const char* name) -> std::vector<std::int64_t> {
      for (const auto& child : data->children)
        if (child->attribute("Name") == name) return numbers(*child, size).integers;
      return {};
    };
    const std::vector<std::int64_t> dimensions = array("dimension"), bounded = array("regions_bounded");
    if (dimensions.size() != size || bounded.size() != size) return taken;
    for (std::size_t i = 0; i < size; ++i) taken[i] = dimensions[i] != 2 || bounded[i] == 0;
    return taken;
  }

  void read_points(const XmlElement& piece, std::size_t n) {
    const XmlElement* points = piece.child("Points");
    const XmlElement* array = points == nullptr ? nullptr : points->child("DataArray");
    if (array == nullptr) fail(piece, "the piece has no DataArray of Points: write it again");
    if (array->attribute("NumberOfComponents") != "3")
      fail(*array, "points have three coordinates: correct the array");
    MeshData& mesh = collector_.mesh;
    const std::size_t before = mesh.point_count();
    if (array->attribute("format", "ascii") == "ascii") {
      TextCursor cursor(path_, array->text, 0, array->text_line);
      while (cursor.more()) cursor.coordinates(mesh, decimal_);
    } else {
      const VtkNumbers found = numbers(*array, 3 * n);
      for (std::size_t i = 0; i < found.size(); ++i) {
        mesh.xyz.push_back(found.whole ? static_cast<double>(found.integers[i]) : found.reals[i]);
        if (std::isfinite(mesh.xyz.back())) continue;
        fail(*array, "point " + std::to_string(i / 3) + " has a coordinate that is no finite number: correct it");
      }
    }
    if (mesh.xyz.size() != 3 * (before + n)) {
      fail(*array, "the piece has " + std::to_string(n) + " points and " +
                       std::to_string(mesh.xyz.size() - 3 * before) + " coordinates: correct their number");
    }
  }

  static const XmlElement* array_of(const XmlElement& list, const char* name) {
    for (const auto& child : list.children) {
      if (child->attribute("Name") == name) return child.get();
    }
    return nullptr;
  }

  std::vector<std::int64_t> integers(const XmlElement& list, const char* name, std::size_t most) const {
    const XmlElement* const array = array_of(list, name);
    if (array == nullptr) fail(list, std::string("the array ") + name + " is missing here: write the file again");
    VtkNumbers found = numbers(*array, most);
    if (!found.whole) fail(*array, "cells are lists of whole numbers: correct the type of the array");
    return std::move(found.integers);
  }

  VtkCells read_cells(const XmlElement& list, std::size_t n) {
    VtkCells cells;
    std::vector<std::int64_t> ends;
    if (array_of(list, "offsets") != nullptr) ends = integers(list, "offsets", n);
    const std::int64_t last =
        ends.empty() ? 0 : std::clamp(ends.back(), std::int64_t{0}, std::ssize(text_) * kMostPacked);
    cells.connectivity = integers(list, "connectivity", static_cast<std::size_t>(last));
    if (ends.empty()) ends = integers(list, "offsets", n);
    cells.offsets.insert(cells.offsets.end(), ends.begin(), ends.end());
    if (cells.size() != n) {
      fail(list, "there are " + std::to_string(cells.size()) + " offsets of " + std::to_string(n) +
                     " cells: correct their number");
    }
    if (!std::is_sorted(cells.offsets.begin(), cells.offsets.end()) ||
        cells.offsets.back() != std::ssize(cells.connectivity)) {
      fail(list, "the offsets of cells must rise to " + std::to_string(cells.connectivity.size()) +
                     ", the length of their connectivity: correct them");
    }
    return cells;
  }

  /// The first array of one number for each cell that is called a label.
  std::optional<VtkNumbers> labels(const XmlElement& piece, std::size_t cells) const {
    const XmlElement* data = piece.child("CellData");
    if (data == nullptr) return {};
    for (const auto& array : data->children) {
      if (array->name != "DataArray" || !MeshLabels::is_label(array->attribute("Name")) ||
          array->attribute("NumberOfComponents", "1") != "1") {
        continue;
      }
      VtkNumbers found = numbers(*array, cells);
      if (found.size() == cells) return found;
      fail(*array, "there are " + std::to_string(found.size()) + " labels of " + std::to_string(cells) +
                       " cells: correct their number");
    }
    return {};
  }

  /// Of a damaged array there may be some more than `most`; who reads them tells.
  VtkNumbers numbers(const XmlElement& array, std::size_t most) const {
    constexpr std::pair<std::string_view, VtkType> kTypes[] = {
        {"Int8", VtkType::int8},      {"UInt8", VtkType::uint8},   {"Int16", VtkType::int16},
        {"UInt16", VtkType::uint16},  {"Int32", VtkType::int32},   {"UInt32", VtkType::uint32},
        {"Int64", VtkType::int64},    {"UInt64", VtkType::uint64}, {"Float32", VtkType::float32},
        {"Float64", VtkType::float64}};
    const std::string name = array.attribute("type"), format = array.attribute("format", "ascii");
    const auto type =
        std::find_if(std::begin(kTypes), std::end(kTypes), [&](const auto& t) { return t.first == name; });
    if (type == std::end(kTypes))
      fail(array, in_quotes(name) + " is no type of numbers, such as Int32 or Float64: correct it");
    if (format == "ascii") return numbers_of_text(array, is_whole(type->second));
    if (format != "binary" && format != "appended") {
      fail(array,
           "the format " + in_quotes(format) + " of an array is none of ascii, binary and appended: correct it");
    }
    const std::string bytes = bytes_of(array, format == "appended", (most + kSlack) * size_of(type->second));
    if (bytes.size() % size_of(type->second) != 0) {
      fail(array, "the array has " + std::to_string(bytes.size()) + " bytes, which are no whole numbers of type " +
                      name + ": write the file again");
    }
    return numbers_of(bytes, type->second, coding_.big_endian);
  }

  VtkNumbers numbers_of_text(const XmlElement& array, bool whole) const {
    VtkNumbers found;
    found.whole = whole;
    TextCursor cursor(path_, array.text, 0, array.text_line);
    while (cursor.more()) {
      if (whole) found.integers.push_back(cursor.integer("a whole number of the array"));
      else found.reals.push_back(cursor.number("a number of the array"));
    }
    return found;
  }

  std::string bytes_of(const XmlElement& array, bool appended, std::size_t most) const {
    try {
      if (!appended) return decoded(array.text, true, coding_, most);
      const std::size_t offset = count(array, "offset");
      if (appended_.size() <= offset) {
        fail(array, "the array is at the offset " + std::to_string(offset) + " of the appended data, which have " +
                        std::to_string(appended_.size()) +
                        " bytes: the file is truncated, or the offset is wrong");
      }
      return decoded(appended_.substr(offset), !appended_raw_, coding_, most);
    } catch (const VtkBytesFault& fault) {
      fail(array, std::string("the array ") + in_quotes(array.attribute("Name")) + " " + fault.what());
    }
  }
};

}  // namespace

std::string vtp_library() {
  const XML_Expat_Version version = XML_ExpatVersionInfo();
  return "Expat " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
         std::to_string(version.micro);
}

MeshData read_vtp(const std::string& path, const std::string& text, bool decimal) {
  return VtpReader(path, text, decimal).read();
}

}  // namespace cnrg
