// 3MF (.3mf): a ZIP archive whose part 3D/3dmodel.model is XML: objects, each a mesh or made of others, and a
// build that places them.
//
// The XML of a mesh has an element for each point and triangle, so it is read as it comes (expat) and no tree is
// made of it. Positions are the doubles of the text, moved by the transforms in doubles. Each placed mesh is a
// group of faces. Colours and what extensions say are left out; an extension that is required is refused.
#include <zlib.h>

#include <charconv>
#include <cmath>
#include <map>
#include <new>

#include "csg/imports/affine.h"
#include "csg/imports/little_endian.h"
#include "csg/imports/mesh_file.h"
#include "csg/imports/xml_events.h"
#include "csg/leaves/leaf.h"

namespace cnrg {
namespace {

constexpr const char* kBrokenArchive = "the archive is truncated, or damaged: export it again";

[[noreturn]] void fail_3mf(const std::string& path, const std::string& text) {
  throw LeafFileError(path, 0, 0, text);
}

/// Raw deflate. zlib makes at most 1032 bytes of one.
std::string inflated(const std::string& path, std::string_view bytes, std::size_t size) {
  if (size / 1100 > bytes.size()) fail_3mf(path, kBrokenArchive);
  std::string out(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int done = inflate(&stream, Z_FINISH);
  const bool whole = done == Z_STREAM_END && stream.total_out == size;
  inflateEnd(&stream);
  if (!whole) fail_3mf(path, kBrokenArchive);
  return out;
}

/// The part of an archive with that name, by its directory (PKWARE's APPNOTE, 4.3).
std::string archive_part(const std::string& path, std::string_view archive, std::string_view name) {
  constexpr std::size_t kEnd = 22, kEntry = 46, kHead = 30;
  const std::size_t end = archive.rfind(std::string_view("PK\5\6", 4));
  if (end == std::string_view::npos || archive.size() - end < kEnd)
    fail_3mf(path, "this is no ZIP archive, which a .3mf is: export it again");
  std::size_t at = little_endian(archive, end + 16, 4);
  for (std::size_t left = little_endian(archive, end + 10, 2); left > 0; --left) {
    if (at > archive.size() || archive.size() - at < kEntry) fail_3mf(path, kBrokenArchive);
    const std::size_t length = little_endian(archive, at + 28, 2);
    if (archive.substr(at + kEntry, length) == name) {
      const std::size_t method = little_endian(archive, at + 10, 2), packed = little_endian(archive, at + 20, 4),
                        size = little_endian(archive, at + 24, 4), head = little_endian(archive, at + 42, 4);
      if (head > archive.size() || archive.size() - head < kHead) fail_3mf(path, kBrokenArchive);
      const std::size_t begin =
          head + kHead + little_endian(archive, head + 26, 2) + little_endian(archive, head + 28, 2);
      if (begin > archive.size() || archive.size() - begin < packed) fail_3mf(path, kBrokenArchive);
      const std::string_view bytes = archive.substr(begin, packed);
      if (method == 0) return std::string(bytes);
      if (method != 8) fail_3mf(path, "the archive is packed otherwise than by deflate: export it again");
      return inflated(path, bytes, size);
    }
    at += kEntry + length + little_endian(archive, at + 30, 2) + little_endian(archive, at + 32, 2);
  }
  fail_3mf(path, "the archive has no part " + std::string(name) + ": export it again");
}

class ThreeMfReader : XmlEvents {
 public:
  ThreeMfReader(const std::string& path, const std::string& text) : path_(path) { parse(text); }

  MeshData read() {
    for (const Use& item : build_) place(item, kInPlace, 0);
    if (group_ < 2) mesh_.groups.clear();
    return std::move(mesh_);
  }

 private:
  struct Use {
    std::string object;
    Affine place = kInPlace;
  };
  struct Object {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Use> parts;
  };

  const std::string& path_;
  std::map<std::string, Object, std::less<>> objects_;
  Object* object_ = nullptr;  ///< that is being read
  std::vector<Use> build_;
  MeshData mesh_;
  std::uint32_t group_ = 0;
  std::size_t placed_ = 0;

  [[noreturn]] void fail_here(const std::string& text) const {
    fail_3mf(path_, "3D/3dmodel.model, line " + std::to_string(line()) + ": " + text);
  }
  void fail_as_no_xml(const std::string& fault) const override { fail_here(fault + "; export it again"); }
  void refuse_doctype() const override { fail_here("a model has no DOCTYPE: leave it out"); }

  const std::string& wanted(const XmlAttributes& given, const char* key) const {
    const auto found = given.find(key);
    if (found == given.end()) fail_here(std::string("the attribute ") + key + " is missing: export it again");
    return found->second;
  }
  double number(std::string_view text) const {
    double x = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), x);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size() || !std::isfinite(x))
      fail_here("`" + std::string(text.substr(0, 40)) + "` is no finite number: export it again");
    return x;
  }
  std::uint32_t corner(const XmlAttributes& given, const char* key) const {
    const double x = number(wanted(given, key));
    if (!(x >= 0 && x < static_cast<double>(object_->points.size())) || x != std::floor(x))
      fail_here("a triangle has the point " + wanted(given, key) + " of " +
                std::to_string(object_->points.size()) + ": export it again");
    return static_cast<std::uint32_t>(x);
  }
  /// Twelve numbers, the images of the axes and of the origin.
  Affine affine(const XmlAttributes& given) const {
    const auto found = given.find("transform");
    if (found == given.end()) return kInPlace;
    std::vector<double> numbers;
    std::string_view rest = found->second;
    for (;;) {
      const std::size_t begin = std::min(rest.find_first_not_of(" \t\r\n"), rest.size());
      if (begin == rest.size()) break;
      rest.remove_prefix(begin);
      const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
      numbers.push_back(number(rest.substr(0, end)));
      rest.remove_prefix(end);
    }
    if (numbers.size() != 12) fail_here("a transform has 12 numbers: export it again");
    Affine out{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) out[i][j] = numbers[3 * j + i];
    return out;
  }

  void begin(const char* element, XmlAttributes given) override {
    const std::string_view name = element;
    if (name == "model") {
      const auto required = given.find("requiredextensions");
      if (required != given.end() && !required->second.empty())
        fail_here("the extension `" + required->second + "` is required, which is not read: export it without");
    } else if (name == "object") {
      const auto [it, fresh] = objects_.try_emplace(wanted(given, "id"));
      if (!fresh) fail_here("the object " + it->first + " is there twice: export it again");
      object_ = &it->second;
    } else if (name == "vertex" && object_ != nullptr) {
      object_->points.push_back(
          {number(wanted(given, "x")), number(wanted(given, "y")), number(wanted(given, "z"))});
    } else if (name == "triangle" && object_ != nullptr) {
      object_->triangles.push_back({corner(given, "v1"), corner(given, "v2"), corner(given, "v3")});
    } else if (name == "component" && object_ != nullptr) {
      object_->parts.push_back({wanted(given, "objectid"), affine(given)});
    } else if (name == "item") {
      build_.push_back({wanted(given, "objectid"), affine(given)});
    }
  }

  void place(const Use& use, const Affine& above, int depth) {
    constexpr int kDeepest = 1000;
    constexpr std::size_t kMostPlaced = 1'000'000;
    if (depth == kDeepest || ++placed_ > kMostPlaced)
      fail_3mf(path_, "objects are parts of each other in a circle, or too many: export it again");
    const auto found = objects_.find(use.object);
    if (found == objects_.end()) fail_3mf(path_, "there is no object " + use.object + ": export it again");
    const Affine here = product(above, use.place);
    const Object& object = found->second;
    const std::uint32_t first = place32(mesh_.point_count(), "points");
    for (const auto& p : object.points) {
      add_point(mesh_, here, p);
      if (!std::isfinite(mesh_.xyz.back() + mesh_.xyz.end()[-2] + mesh_.xyz.end()[-3]))
        fail_3mf(path_, "object " + use.object + " is placed beyond all doubles: export it again");
    }
    for (const auto& triangle : object.triangles) {
      for (const std::uint32_t p : triangle) mesh_.corners.push_back(first + p);
      mesh_.end_face();
      mesh_.groups.push_back(group_);
    }
    if (!object.triangles.empty()) ++group_;
    for (const Use& part : object.parts) place(part, here, depth + 1);
  }
};

}  // namespace

MeshData read_3mf(const std::string& path, const std::string& text, bool) {
  return ThreeMfReader(path, archive_part(path, text, "3D/3dmodel.model")).read();
}

}  // namespace cnrg
