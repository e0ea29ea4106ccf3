// GLB, glTF 2.0 in one file (.glb): triangles, lines and points of the meshes of a scene, where its nodes place
// them.
//
// Positions have 32 bits in the file; the transforms of nodes are multiplied in doubles. glTF has y upward: as for
// the files of ours, the scene is turned so that z is. Each node with a mesh is a group of faces. Materials,
// skins, animations and what extensions say are left out; an extension that is required is refused.
#include <bit>
#include <cmath>

#include "csg/imports/affine.h"
#include "csg/imports/little_endian.h"
#include "csg/imports/mesh_file.h"
#include "csg/leaves/leaf.h"
#include "csg/text/json_document.h"
#include "csg/text/number.h"

namespace cnrg {
namespace {

class GlbReader {
 public:
  GlbReader(const std::string& path, const std::string& bytes)
      : path_(path), json_(document_of(path, bytes, binary_)) {}

  MeshData read() {
    if (const Value* required = member(json_.root(), "extensionsRequired");
        required != nullptr && required->count > 0)
      fail("the extension `" + json_.decoded(json_.at(*required, 0)) + "` is not read: write the file without it");
    const Value* const scenes = member(json_.root(), "scenes");
    if (scenes == nullptr || scenes->count == 0) fail("the file has no scene: export one");
    const std::size_t scene = number_of(json_.root(), "scene", 0);
    const Value* const nodes = member(item(*scenes, scene, "scene"), "nodes");
    constexpr Affine kUpward{{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}}};  // z of the model is y of glTF
    for (std::size_t i = 0; nodes != nullptr && i < nodes->count; ++i)
      add_node(whole(json_.at(*nodes, i)), kUpward, 0);
    if (group_ < 2) mesh_.groups.clear();
    return std::move(mesh_);
  }

 private:
  using Value = JsonDocument::Value;
  using Kind = JsonDocument::Kind;
  const std::string& path_;
  std::string_view binary_{};
  JsonDocument json_;
  MeshData mesh_;
  std::uint32_t group_ = 0;
  std::size_t placed_ = 0;

  [[noreturn]] static void fail_in(const std::string& path, const std::string& text) {
    throw LeafFileError(path, 0, 0, text);
  }
  [[noreturn]] void fail(const std::string& text) const { fail_in(path_, text); }

  /// The first chunk as JSON; `binary` becomes the second one.
  static JsonDocument document_of(const std::string& path, const std::string& bytes, std::string_view& binary) {
    const std::string truncated = "the file is truncated, or no GLB: export it again";
    if (bytes.size() < 20 || !bytes.starts_with("glTF")) fail_in(path, truncated);
    if (little_endian(bytes, 4) != 2)
      fail_in(path, "glTF " + std::to_string(little_endian(bytes, 4)) + " is not read: export glTF 2.0");
    const std::size_t size = little_endian(bytes, 12);
    if (bytes.size() - 20 < size || bytes.compare(16, 4, "JSON") != 0) fail_in(path, truncated);
    const std::size_t next = 20 + size;
    if (bytes.size() >= next + 8) {
      const std::size_t rest = little_endian(bytes, next);
      if (bytes.size() - next - 8 < rest || bytes.compare(next + 4, 4, std::string_view("BIN\0", 4)) != 0)
        fail_in(path, truncated);
      binary = std::string_view(bytes).substr(next + 8, rest);
    }
    try {
      return JsonDocument(bytes.substr(20, size));
    } catch (const JsonError& e) {
      fail_in(path, "byte " + std::to_string(20 + e.at()) + ": " + e.what());
    }
  }

  const Value* member(const Value& object, std::string_view key) const {
    return object.kind() == Kind::object ? json_.member(object, key) : nullptr;
  }
  double number(const Value& value) const {
    const NumberText text = read_number(value.kind() == Kind::number ? json_.written(value) : "?", 400);
    const double x = text.value ? to_double(*text.value) : INFINITY;
    if (!std::isfinite(x)) fail(json_.path(value) + " is no finite number: export the file again");
    return x;
  }
  std::size_t whole(const Value& value) const {
    const double x = number(value);
    if (!(x >= 0 && x < 0x1p32) || x != std::floor(x))
      fail(json_.path(value) + " is no whole number from 0: export the file again");
    return static_cast<std::size_t>(x);
  }
  std::size_t number_of(const Value& object, std::string_view key, std::size_t otherwise) const {
    const Value* const value = member(object, key);
    return value == nullptr ? otherwise : whole(*value);
  }
  const Value& item(const Value& list, std::size_t i, const char* what) const {
    if (list.kind() != Kind::list || i >= list.count)
      fail(std::string("there is no ") + what + " " + std::to_string(i) + ": export the file again");
    return json_.at(list, i);
  }
  /// Entry i of a list of the document.
  const Value& entry(const char* list, std::size_t i) const {
    const Value* const found = member(json_.root(), list);
    if (found == nullptr) fail(std::string("the file has no ") + list + ": export it again");
    return item(*found, i, list);
  }

  template <std::size_t N>
  std::array<double, N> numbers(const Value& node, const char* key, std::array<double, N> otherwise) const {
    const Value* const list = member(node, key);
    if (list == nullptr) return otherwise;
    if (list->kind() != Kind::list || list->count != N)
      fail(json_.path(*list) + " must have " + std::to_string(N) + " numbers: export the file again");
    for (std::size_t i = 0; i < N; ++i) otherwise[i] = number(json_.at(*list, i));
    return otherwise;
  }

  Affine placed(const Value& node) const {
    Affine out{};
    if (member(node, "matrix") != nullptr) {
      const auto columns = numbers<16>(node, "matrix", {});
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j) out[i][j] = columns[4 * j + i];
      return out;
    }
    const auto move = numbers<3>(node, "translation", {0, 0, 0}), scale = numbers<3>(node, "scale", {1, 1, 1});
    auto [x, y, z, w] = numbers<4>(node, "rotation", {0, 0, 0, 1});
    const double length = x * x + y * y + z * z + w * w;  // 1 but for rounding
    if (length == 0) fail(json_.path(node) + " has a rotation of length 0: export the file again");
    // Quotients of sums: of a quarter turn, with its two equal roots, they are exact.
    const Affine turn{{{(w * w + x * x - y * y - z * z) / length, 2 * (x * y - z * w) / length,
                        2 * (x * z + y * w) / length, move[0]},
                       {2 * (x * y + z * w) / length, (w * w - x * x + y * y - z * z) / length,
                        2 * (y * z - x * w) / length, move[1]},
                       {2 * (x * z - y * w) / length, 2 * (y * z + x * w) / length,
                        (w * w - x * x - y * y + z * z) / length, move[2]}}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j) out[i][j] = turn[i][j] * (j < 3 ? scale[j] : 1);
    }
    return out;
  }

  void add_node(std::size_t number, const Affine& above, int depth) {
    constexpr int kDeepest = 1000;
    constexpr std::size_t kMostPlaced = 1'000'000;
    if (depth == kDeepest || ++placed_ > kMostPlaced)
      fail("nodes are children of each other in a circle, or too many: export the file again");
    const Value& node = entry("nodes", number);
    const Affine here = product(above, placed(node));
    if (const Value* const mesh = member(node, "mesh")) add_mesh(entry("meshes", whole(*mesh)), here);
    if (const Value* const children = member(node, "children")) {
      for (std::size_t i = 0; i < children->count; ++i)
        add_node(whole(item(*children, i, "child")), here, depth + 1);
    }
  }

  void add_mesh(const Value& mesh, const Affine& place) {
    const Value* const parts = member(mesh, "primitives");
    const std::size_t faces = mesh_.face_count();
    for (std::size_t i = 0; parts != nullptr && i < parts->count; ++i)
      add_part(item(*parts, i, "primitive"), place);
    if (mesh_.face_count() > faces) ++group_;
  }

  void add_part(const Value& part, const Affine& place) {
    const Value* const attributes = member(part, "attributes");
    const Value* const position = attributes == nullptr ? nullptr : member(*attributes, "POSITION");
    if (position == nullptr) return;
    const std::uint32_t first = place32(mesh_.point_count(), "points");
    const std::size_t count = add_points(entry("accessors", whole(*position)), place);
    std::vector<std::uint32_t> corners;
    if (const Value* const list = member(part, "indices"))
      corners = indices(entry("accessors", whole(*list)), count);
    else
      for (std::size_t i = 0; i < count; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    for (std::uint32_t& p : corners) p += first;
    switch (number_of(part, "mode", 4)) {
      case 0: mesh_.points.insert(mesh_.points.end(), corners.begin(), corners.end()); break;
      case 1:
        for (std::size_t i = 0; i + 1 < corners.size(); i += 2)
          mesh_.wires.push_back({corners[i], corners[i + 1]});
        break;
      case 4:
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
          mesh_.corners.insert(mesh_.corners.end(), {corners[i], corners[i + 1], corners[i + 2]});
          mesh_.end_face();
          mesh_.groups.push_back(group_);
        }
        break;
      default: fail(json_.path(part) + " has strips, fans or loops: export triangles, lines and points");
    }
  }

  /// The bytes of an accessor: `count` items of `size` bytes, `stride` apart.
  struct Items {
    std::string_view bytes;
    std::size_t count = 0, stride = 0;
  };
  Items items(const Value& accessor, std::size_t size) const {
    const Value* const number = member(accessor, "bufferView");
    if (number == nullptr || member(accessor, "sparse") != nullptr)
      fail(json_.path(accessor) + " has no bytes of its own, or sparse ones: export the file without");
    const Value& view = entry("bufferViews", whole(*number));
    if (number_of(view, "buffer", 0) != 0) fail(json_.path(view) + " is in another file: export one file");
    const std::size_t count = number_of(accessor, "count", 0), stride = number_of(view, "byteStride", size);
    const std::size_t begin = number_of(view, "byteOffset", 0) + number_of(accessor, "byteOffset", 0);
    if (begin > binary_.size() || stride < size ||
        (count > 0 && (binary_.size() - begin < size || (binary_.size() - begin - size) / stride < count - 1)))
      fail(json_.path(accessor) + " reaches beyond the bytes of the file: it is truncated, or damaged");
    return {binary_.substr(begin), count, stride};
  }

  std::size_t add_points(const Value& accessor, const Affine& place) {
    constexpr std::size_t kFloat = 5126;
    const Value* const type = member(accessor, "type");
    if (number_of(accessor, "componentType", 0) != kFloat || type == nullptr || json_.decoded(*type) != "VEC3")
      fail(json_.path(accessor) + " is no list of three floats: export positions as these");
    const Items found = items(accessor, 12);
    for (std::size_t i = 0; i < found.count; ++i) {
      std::array<double, 3> p{};
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = std::bit_cast<float>(little_endian(found.bytes, i * found.stride + 4 * k));
      add_point(mesh_, place, p);
      for (auto x = mesh_.xyz.end() - 3; x != mesh_.xyz.end(); ++x) {
        if (!std::isfinite(*x))
          fail(json_.path(accessor) + " has a position that is no finite number: export the file again");
      }
    }
    return found.count;
  }

  std::vector<std::uint32_t> indices(const Value& accessor, std::size_t count) const {
    const std::size_t type = number_of(accessor, "componentType", 0);
    const std::size_t size = type == 5121 ? 1 : type == 5123 ? 2 : type == 5125 ? 4 : 0;
    if (size == 0) fail(json_.path(accessor) + " is no list of whole numbers: export the file again");
    const Items found = items(accessor, size);
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < found.count; ++i) {
      const auto n = static_cast<std::uint32_t>(little_endian(found.bytes, i * found.stride, size));
      if (n >= count)
        fail(json_.path(accessor) + " names point " + std::to_string(n) + " of " + std::to_string(count));
      out.push_back(n);
    }
    return out;
  }
};

}  // namespace

MeshData read_glb(const std::string& path, const std::string& text, bool) { return GlbReader(path, text).read(); }

}  // namespace cnrg
