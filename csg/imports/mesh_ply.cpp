// PLY (Stanford polygon format): a text header that declares elements with scalar and list properties, then the
// values as text or binary. Read are vertices (x, y, z), faces (vertex_index or vertex_indices, and a label if
// there is one, mesh_labels.h) and edges (vertex1, vertex2); everything else is skipped by its declared size.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "csg/imports/text_cursor.h"
#include "csg/imports/vtk_cells.h"
#include "csg/leaves/leaf.h"

namespace cnrg {
namespace {

using Type = VtkType;  // but for whole numbers of 64 bits

struct PlyProperty {
  std::string name;
  Type type = Type::float32;
  std::optional<Type> count;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class Encoding { text, little, big };

class PlyReader {
 public:
  PlyReader(const std::string& path, const std::string& text, bool decimal)
      : path_(path), text_(text), decimal_(decimal), cursor_(path, text, 0) {}

  MeshData read() {
    read_header();
    at_ = cursor_.offset();
    for (const PlyElement& element : elements_) {
      if (element.name == "vertex") read_vertices(element);
      else if (element.name == "face") read_faces(element);
      else if (element.name == "edge") read_edges(element);
      else skip(element);
    }
    if (encoding_ == Encoding::text ? cursor_.more() : at_ < text_.size()) {
      fail("more data follows after the elements of the header: correct the counts");
    }
    if (labels_.size() < 2) mesh_.groups.clear();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    if (encoding_ == Encoding::text) cursor_.fail(text);
    throw LeafFileError(path_, 0, 0, "byte " + std::to_string(at_) + ": " + text);
  }

  Type type(std::string_view name) {
    static const std::map<std::string_view, Type> kTypes = {
        {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
        {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
        {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
        {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
        {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
        {"float64", Type::float64}};
    const auto found = kTypes.find(name);
    if (found == kTypes.end())
      cursor_.fail(in_quotes(name) + " is no type of PLY, such as int, uchar or float: correct the header");
    return found->second;
  }

  void read_header() {
    if (cursor_.token("ply") != "ply") cursor_.fail("the file does not start with 'ply': it is no PLY file");
    cursor_.next_line();
    bool format = false;
    for (;;) {
      const std::string_view word = cursor_.token("'end_header'");
      if (word == "end_header") break;
      if (word == "format") {
        const std::string_view name = cursor_.token_in_line();
        if (name == "binary_little_endian") body_ = Encoding::little;
        else if (name == "binary_big_endian") body_ = Encoding::big;
        else if (name != "ascii") {
          cursor_.fail(in_quotes(name) +
                       " is no format of PLY: give ascii, binary_little_endian or binary_big_endian");
        }
        format = true;
      } else if (word == "element") {
        PlyElement element;
        element.name = cursor_.token_in_line();
        const long long count = cursor_.integer("the number of elements");
        if (count < 0 || count > 4000000000)
          cursor_.fail("a count of " + std::to_string(count) + " elements: correct it");
        element.count = static_cast<std::uint64_t>(count);
        elements_.push_back(std::move(element));
      } else if (word == "property") {
        if (elements_.empty()) cursor_.fail("a property before any element: declare its element first");
        PlyProperty property;
        std::string_view name = cursor_.token_in_line();
        if (name == "list") {
          property.count = type(cursor_.token_in_line());
          if (*property.count >= Type::float32)
            cursor_.fail("the length of a list must be a whole number: correct its type");
          name = cursor_.token_in_line();
        }
        property.type = type(name);
        property.name = cursor_.token_in_line();
        elements_.back().properties.push_back(std::move(property));
      } else if (word != "comment" && word != "obj_info") {
        cursor_.fail(in_quotes(word) + " is unknown in the header of PLY: correct it");
      }
      cursor_.next_line();
    }
    cursor_.next_line();
    if (!format) cursor_.fail("the header has no 'format': add one, such as 'format ascii 1.0'");
    encoding_ = body_;
    for (const PlyElement& element : elements_) {
      if (element.name == "vertex") vertices_ = element.count;
    }
  }

  /// One number of the body.
  double value(Type type) {
    if (encoding_ == Encoding::text) return cursor_.number("a value");
    const std::size_t size = size_of(type), at = at_;
    if (text_.size() - at_ < size) fail("the file ends within its data: it is truncated, or a count is wrong");
    at_ += size;
    const bool big = encoding_ == Encoding::big;
    return is_whole(type) ? static_cast<double>(whole_number_at(text_, at, type, big))
                          : real_number_at(text_, at, type, big);
  }

  std::uint64_t list_length(const PlyProperty& property) {
    const double length = encoding_ == Encoding::text
                              ? static_cast<double>(cursor_.integer("the length of a list"))
                              : value(*property.count);
    if (length < 0 || length > static_cast<double>(text_.size())) {
      fail("a list of " + std::to_string(static_cast<long long>(length)) +
           " values: the file is damaged, write it again");
    }
    return static_cast<std::uint64_t>(length);
  }

  void skip(const PlyProperty& property) {
    std::uint64_t n = property.count ? list_length(property) : 1;
    if (encoding_ == Encoding::text) {
      for (; n > 0; --n) cursor_.token("a value");
      return;
    }
    if ((text_.size() - at_) / size_of(property.type) < n) {
      fail("the file ends within its data: it is truncated, or a count is wrong");
    }
    at_ += n * size_of(property.type);
  }

  void skip(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) skip(property);
    }
  }

  std::uint32_t index(Type type, const char* what, std::uint64_t number) {
    const double given = value(type);
    if (!(given >= 0 && given < static_cast<double>(vertices_) && given == std::floor(given))) {
      const std::string text = std::isfinite(given) ? to_decimal(from_double(given)) : "nan";
      fail(std::string(what) + " " + std::to_string(number) + " has the vertex " + text + ", but there are " +
           std::to_string(vertices_) + " vertices, numbered from 0: correct the index");
    }
    return static_cast<std::uint32_t>(given);
  }

  std::size_t reserve_count(std::uint64_t count) const {
    return static_cast<std::size_t>(std::min<std::uint64_t>(count, text_.size()));
  }

  void read_vertices(const PlyElement& element) {
    int seen = 0;
    for (const PlyProperty& p : element.properties)
      seen += !p.count && (p.name == "x" || p.name == "y" || p.name == "z");
    if (seen != 3) fail("the element 'vertex' has no properties x, y and z: add them");
    mesh_.xyz.reserve(3 * reserve_count(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      double xyz[3];
      RationalPoint exact;
      bool doubles = true;
      for (const PlyProperty& property : element.properties) {
        const std::size_t axis = property.name == "x"   ? 0
                                 : property.name == "y" ? 1
                                 : property.name == "z" ? 2
                                                        : 3;
        if (property.count || axis == 3) {
          skip(property);
        } else if (decimal_ && encoding_ == Encoding::text) {
          xyz[axis] = cursor_.decimal("a coordinate", exact[axis]);
          doubles = doubles && is_double(exact[axis]);
        } else {
          xyz[axis] = value(property.type);
          if (!std::isfinite(xyz[axis])) {
            fail("vertex " + std::to_string(i) + " has a coordinate that is no finite number: correct the file");
          }
        }
      }
      mesh_.xyz.insert(mesh_.xyz.end(), xyz, xyz + 3);
      if (!doubles) mesh_.exact.emplace_back(static_cast<std::uint32_t>(mesh_.point_count() - 1), exact);
    }
  }

  void read_faces(const PlyElement& element) {
    const PlyProperty* corners = nullptr;
    const PlyProperty* label = nullptr;
    for (const PlyProperty& p : element.properties) {
      if (p.count && (p.name == "vertex_index" || p.name == "vertex_indices")) corners = &p;
      if (!p.count && !label && MeshLabels::is_label(p.name)) label = &p;
    }
    if (!corners && element.count > 0) fail("the element 'face' has no list 'vertex_indices': add it");
    mesh_.offsets.reserve(1 + reserve_count(element.count));
    mesh_.corners.reserve(3 * reserve_count(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      double group = 0;
      for (const PlyProperty& property : element.properties) {
        if (&property == corners) {
          const std::uint64_t n = list_length(property);
          for (std::uint64_t k = 0; k < n; ++k) mesh_.corners.push_back(index(property.type, "face", i));
          mesh_.end_face();
        } else if (&property == label) {
          group = value(property.type);
        } else {
          skip(property);
        }
      }
      if (label) mesh_.groups.push_back(labels_.group(group));
    }
  }

  void read_edges(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::array<std::uint32_t, 2> ends{0, 0};
      int seen = 0;
      for (const PlyProperty& property : element.properties) {
        if (!property.count && (property.name == "vertex1" || property.name == "vertex2")) {
          ends[property.name == "vertex1" ? 0 : 1] = index(property.type, "edge", i);
          ++seen;
        } else {
          skip(property);
        }
      }
      if (seen == 2) mesh_.wires.push_back(ends);
    }
  }

  const std::string& path_;
  const std::string& text_;
  bool decimal_;
  TextCursor cursor_;
  std::size_t at_ = 0;  ///< byte, for binary data
  Encoding body_ = Encoding::text, encoding_ = Encoding::text;
  std::uint64_t vertices_ = 0;
  std::vector<PlyElement> elements_;
  MeshLabels labels_;
  MeshData mesh_;
};

}  // namespace

MeshData read_ply(const std::string& path, const std::string& text, bool decimal) {
  return PlyReader(path, text, decimal).read();
}

}  // namespace cnrg
