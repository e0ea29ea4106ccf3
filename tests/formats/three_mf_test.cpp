// 3MF: the package taken apart by a reader of the test, which knows ZIP and just the XML that may stand there; and
// by lib3MF, where that is installed.
#include <zlib.h>

#include <map>
#include <random>
#include <regex>
#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/tree/tree.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at, int size) {
  std::uint32_t n = 0;
  for (int k = size; k-- > 0;) n = n << 8 | std::uint8_t(bytes.at(at + std::size_t(k)));
  return n;
}

/// The files of an archive by name. Looks at every field of its headers.
std::map<std::string, std::string> read_zip(const std::string& bytes) {
  const std::size_t end = bytes.size() - 22;
  REQUIRE(bytes.compare(end, 8, std::string("PK\5\6\0\0\0\0", 8)) == 0);
  const std::size_t count = number_at(bytes, end + 10, 2);
  CHECK(number_at(bytes, end + 8, 2) == count);
  std::size_t at = number_at(bytes, end + 16, 4);
  CHECK(at + number_at(bytes, end + 12, 4) == end);
  std::map<std::string, std::string> files;
  for (std::size_t i = 0; i < count; ++i) {
    REQUIRE(bytes.compare(at, 4, "PK\1\2") == 0);
    const std::size_t packed = number_at(bytes, at + 20, 4), size = number_at(bytes, at + 24, 4);
    const std::size_t length = number_at(bytes, at + 28, 2);
    CHECK(number_at(bytes, at + 12, 4) == 0x00210000);  // midnight, 1 January 1980
    const std::size_t local = number_at(bytes, at + 42, 4);
    REQUIRE(bytes.compare(local, 4, "PK\3\4") == 0);
    CHECK(bytes.substr(local + 4, 26) == bytes.substr(at + 6, 26));
    const std::string name = bytes.substr(at + 46, length);
    CHECK(bytes.substr(local + 30, length) == name);
    std::string content(size, '\0');
    z_stream stream{};
    REQUIRE(inflateInit2(&stream, -MAX_WBITS) == Z_OK);
    std::string input = bytes.substr(local + 30 + length, packed);
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = uInt(packed);
    stream.next_out = reinterpret_cast<Bytef*>(content.data());
    stream.avail_out = uInt(size);
    CHECK(inflate(&stream, Z_FINISH) == Z_STREAM_END);
    CHECK(stream.total_out == size);
    inflateEnd(&stream);
    CHECK(crc32(0, reinterpret_cast<const Bytef*>(content.data()), uInt(size)) == number_at(bytes, at + 16, 4));
    files[name] = content;
    at += 46 + length;
  }
  CHECK(at == end);
  return files;
}

struct Object {
  std::string name, color, material;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> parts;  // of an assembly

  Rational volume() const {
    Rational sum = 0;
    for (const auto& t : triangles) {
      std::array<RationalPoint, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) p[i][k] = from_double(points.at(t[i])[k]);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        sum += p[0][k] * (p[1][(k + 1) % 3] * p[2][(k + 2) % 3] - p[1][(k + 2) % 3] * p[2][(k + 1) % 3]);
      }
    }
    return sum / 6;
  }
  /// Each side of a triangle has one neighbour, which runs the other way; and around each vertex the triangles are
  /// one fan.
  bool manifold() const {
    std::map<std::pair<std::size_t, std::size_t>, int> sides;
    std::map<std::size_t, std::map<std::size_t, std::size_t>> next;  // around a vertex, from corner to corner
    for (const auto& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        ++sides[{t[k], t[(k + 1) % 3]}];
        next[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
      }
    }
    for (const auto& [side, n] : sides) {
      const auto back = sides.find({side.second, side.first});
      if (n != 1 || back == sides.end()) return false;
    }
    for (const auto& [v, fan] : next) {
      std::size_t at = fan.begin()->first, n = 0;
      do at = fan.at(at), ++n;
      while (at != fan.begin()->first);
      if (n != fan.size()) return false;
    }
    return next.size() == points.size();
  }
};

struct Model {
  std::string title;
  std::map<int, Object> objects;
  std::vector<int> built;

  const Object& named(const std::string& name) const {
    for (const auto& [id, object] : objects) {
      if (object.name == name) return object;
    }
    throw std::runtime_error("no object " + name);
  }
};

Model read_3mf(const std::string& bytes) {
  const auto files = read_zip(bytes);
  REQUIRE(files.size() == 3);
  CHECK(files.at("[Content_Types].xml").find("3dmanufacturing-3dmodel+xml") != std::string::npos);
  CHECK(files.at("_rels/.rels").find("Target=\"/3D/3dmodel.model\"") != std::string::npos);
  const std::string& text = files.at("3D/3dmodel.model");
  Model model;
  std::vector<std::pair<std::string, std::string>> bases;
  Object* object = nullptr;
  const std::regex tag("<([/?]?[a-z]+)([^>]*)>([^<]*)"), pair("([a-z0-9:]+)=\"([^\"]*)\"");
  for (std::sregex_iterator it(text.begin(), text.end(), tag), last; it != last; ++it) {
    const std::string name = (*it)[1], rest = (*it)[2];
    std::map<std::string, std::string> keys;
    for (std::sregex_iterator k(rest.begin(), rest.end(), pair); k != last; ++k) keys[(*k)[1]] = (*k)[2];
    if (name == "model") CHECK(keys["unit"] == "millimeter");
    else if (name == "metadata" && keys["name"] == "Title") model.title = (*it)[3];
    else if (name == "base") bases.emplace_back(keys["name"], keys["displaycolor"]);
    else if (name == "object") {
      object = &model.objects[std::stoi(keys["id"])];
      object->name = keys["name"];
      if (keys.count("pindex") != 0) {
        CHECK(keys["pid"] == "1");
        std::tie(object->material, object->color) = bases.at(std::stoul(keys["pindex"]));
      }
    } else if (name == "vertex") {
      object->points.push_back({std::stod(keys["x"]), std::stod(keys["y"]), std::stod(keys["z"])});
    } else if (name == "triangle") {
      object->triangles.push_back({std::stoul(keys["v1"]), std::stoul(keys["v2"]), std::stoul(keys["v3"])});
    } else if (name == "component") {
      object->parts.push_back(std::stoi(keys["objectid"]));
    } else if (name == "item") {
      model.built.push_back(std::stoi(keys["objectid"]));
    }
  }
  return model;
}

Result evaluated(const std::string& tree) { return evaluate(parse_tree(tree, "t.yaml")).result(); }

std::string written(const Result& result) {
  const ScratchFolder dir;
  write(dir / "m.3mf", result);
  return text_of(dir / "m.3mf");
}

std::string refusal_of(const Result& result) {
  const ScratchFolder dir;
  try {
    write(dir / "m.3mf", result);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const char* const kLayers = R"(cnrg: 1
materials: {rock: {color: "#998877"}, ore: {}}
nodes:
  low:   {box: {min: [0, 0, 0], max: [3, 3, 1]}, material: rock}
  high:  {box: {min: [0, 0, 1], max: [3, 3, "4/3"]}, material: ore}
  vein:  {box: {min: [1, 1, 0.5], max: [2, 2, 1]}, material: ore, name: "vein & \"lode\""}
  model: {union: [vein, low, high], dominance: left}
result: model
)";

}  // namespace

TEST_CASE("3mf: an object per region with its material, in an assembly that is built") {
  const Model model = read_3mf(written(evaluated(kLayers)));
  CHECK(model.title == "model");
  REQUIRE(model.objects.size() == 4);
  const Object &low = model.named("low"), &high = model.named("high"), &all = model.named("model");
  const Object& vein = model.named("vein &amp; 'lode'");  // names of groups have apostrophes
  CHECK(low.material == "rock");
  CHECK(low.color == "#998877");
  CHECK(high.material == "ore");
  CHECK(vein.material == "ore");
  CHECK(vein.color == high.color);
  CHECK(low.volume() == 9 - Rational(1, 2));
  CHECK(vein.volume() == Rational(1, 2));
  CHECK(high.volume() == 9 * (from_double(4.0 / 3) - 1));
  for (const auto& [id, object] : model.objects) CHECK((object.manifold() || &object == &all));
  CHECK(all.parts.size() == 3);
  REQUIRE(model.built.size() == 1);
  CHECK(&model.objects.at(model.built[0]) == &all);
}

TEST_CASE("3mf: parts that adjoin have the same triangles where they do, turned") {
  const Model model = read_3mf(written(evaluated(kLayers)));
  using Triangle = std::array<std::array<double, 3>, 3>;
  const auto of = [&](const std::string& name, bool turned) {
    const Object& object = model.named(name);
    std::set<Triangle> all;
    for (const auto& t : object.triangles) {
      Triangle p{object.points[t[0]], object.points[t[1]], object.points[t[2]]};
      if (turned) std::swap(p[1], p[2]);
      std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
      all.insert(p);
    }
    return all;
  };
  const auto shared = [&](const std::string& a, const std::string& b) {
    double area = 0;  // in the plane z = 1
    const auto other = of(b, true);
    for (const Triangle& t : of(a, false)) {
      if (other.count(t) == 0) continue;
      area += std::abs((t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[2][0] - t[0][0]) * (t[1][1] - t[0][1])) / 2;
    }
    return area;
  };
  CHECK(shared("low", "high") == 8);
  CHECK(shared("vein &amp; 'lode'", "high") == 1);
  CHECK(shared("low", "vein &amp; 'lode'") == 1);  // its bottom, and sides without area in that plane
}

TEST_CASE("3mf: where a region touches itself each edge has two triangles all the same") {
  // Two cubes of one region share an edge, two others a corner; a torus of four bars that share edges.
  const std::string cubes = R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {box: {min: [1, 1, 0], max: [2, 2, 1]}}
  c: {box: {min: [2, 2, 1], max: [3, 3, 2]}}
  d: {box: {min: [2, 0, 0], max: [3, 1, 1]}}
  all: {unify: {sum: [a, b, c, d]}}
result: all
)";
  const Model model = read_3mf(written(evaluated(cubes)));
  Rational volume;
  for (const auto& [id, object] : model.objects) {
    if (!object.parts.empty()) continue;
    CHECK(object.manifold());
    volume += object.volume();
  }
  CHECK(volume == 4);

  // The same edges within one region, which goes round below.
  const std::string joined = R"(cnrg: 1
nodes:
  base: {box: {min: [0, 0, -1], max: [3, 3, 0]}}
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {box: {min: [1, 1, 0], max: [2, 2, 1]}}
  hole: {box: {min: [2, 2, -1], max: [3, 3, 0]}}
  well: {box: {min: [1, 1, -1], max: [2, 2, -1/2]}}
  all: {difference: [{union: [base, a, b]}, hole, well]}
  one: {unify: all}
result: one
)";
  const Model one = read_3mf(written(evaluated(joined)));
  REQUIRE(one.objects.size() == 2);
  const Object& object = one.objects.at(2);
  CHECK(object.manifold());
  CHECK(object.volume() == 9 + 2 - 1 - Rational(1, 2));
  std::set<std::array<double, 3>> places(object.points.begin(), object.points.end());
  CHECK(places.size() < object.points.size());

  // A cavity of two cubes that share an edge: the solid is around it, and joins across the edge.
  const std::string cavity = R"(cnrg: 1
nodes:
  block: {box: {min: [-1, -1, -1], max: [3, 3, 2]}}
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {box: {min: [1, 1, 0], max: [2, 2, 1]}}
  all: {difference: [block, a, b]}
result: all
)";
  const Model hollow = read_3mf(written(evaluated(cavity)));
  CHECK(hollow.objects.at(2).manifold());
  CHECK(hollow.objects.at(2).volume() == 4 * 4 * 3 - 2);
}

TEST_CASE("3mf: random cubes of one region touch in edges and corners, and the surfaces are closed") {
  std::mt19937 random(1);
  for (int i = 0; i < 40; ++i) {
    std::string nodes, list;
    int n = 0;
    for (int c = 0; c < 27; ++c) {
      if (random() % 2 == 0) continue;
      const int x = c % 3, y = c / 3 % 3, z = c / 9;
      const auto corner = [&](int d) {
        return "[" + std::to_string(x + d) + ", " + std::to_string(y + d) + ", " + std::to_string(z + d) + "]";
      };
      nodes += "  c" + std::to_string(c) + ": {box: {min: " + corner(0) + ", max: " + corner(1) + "}}\n";
      list += (n++ == 0 ? "c" : ", c") + std::to_string(c);
    }
    if (n < 2) continue;
    CAPTURE(list);
    const Model model = read_3mf(written(evaluated(
        "cnrg: 1\nnodes:\n" + nodes + "  all: {regularize: {unify: {sum: [" + list + "]}}}\n" + "result: all\n")));
    Rational volume;
    for (const auto& [id, object] : model.objects) {
      if (!object.parts.empty()) continue;
      CHECK(object.manifold());
      volume += object.volume();
    }
    CHECK(volume == n);
  }
}

TEST_CASE("3mf: what bounds no region is refused and named, with what helps") {
  const std::string head = R"(cnrg: 1
nodes:
  block: {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  crack: {polygon: [[1, 0.5, 0.5], [1, 1.5, 0.5], [1, 1.5, 1.5]]}
  sheet: {polygon: [[3, 0, 0], [4, 0, 0], [4, 1, 0]]}
  bolt:  {polyline: [[1, 1, 1], [5, 1, 1]]}
  dot:   {points: [[9, 9, 9]]}
  all:   {union: [bolt, dot, crack, sheet, block], dominance: left}
  solid: {regularize: all}
  inner: {interior: block}
  rest:  {complement: block}
)";
  const std::string message = refusal_of(evaluated(head + "result: all\n"));
  CHECK_THAT(message, Catch::Contains("3MF holds solid regions only, and the result has"));
  for (const std::string part : {"1 face inside of a region", "1 face that bounds no region", "2 wires",
                                 "1 isolated point", "write .glb, .obj", "`regularize`"}) {
    CHECK_THAT(message, Catch::Contains(part));
  }
  CHECK(refusal_of(evaluated(head + "result: solid\n")) == "");
  CHECK_THAT(refusal_of(evaluated(head + "result: inner\n")), Catch::Contains("apply `closure`"));
  CHECK_THAT(refusal_of(evaluated(head + "result: rest\n")), Catch::Contains("without bounds"));
}

TEST_CASE("3mf: an empty result is a package without objects") {
  const std::string tree = R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  none: {difference: [a, a]}
result: none
)";
  const Model model = read_3mf(written(evaluated(tree)));
  CHECK(model.objects.empty());
  CHECK(model.built.empty());
}

TEST_CASE("3mf: the same result gives the same bytes, and doubles are not rounded") {
  const std::string bytes = written(evaluated(kLayers));
  CHECK(written(evaluated(kLayers)) == bytes);
  CHECK(read_zip(bytes).at("3D/3dmodel.model").find("\"1.3333333333333333\"") != std::string::npos);
}

#ifdef CNRG_LIB3MF
#include <Model/COM/NMR_DLLInterfaces.h>

TEST_CASE("3mf: lib3MF reads it without a warning and finds closed objects") {
  using namespace NMR;
  const ScratchFolder dir;
  write(dir / "m.3mf", evaluated(kLayers));
  PLib3MFModel* model = nullptr;
  PLib3MFModelReader* reader = nullptr;
  REQUIRE(lib3mf_createmodel(&model) == 0);
  REQUIRE(lib3mf_model_queryreader(model, "3mf", &reader) == 0);
  REQUIRE(lib3mf_reader_readfromfileutf8(reader, (dir / "m.3mf").c_str()) == 0);
  DWORD warnings = 1;
  CHECK(lib3mf_reader_getwarningcount(reader, &warnings) == 0);
  CHECK(warnings == 0);
  PLib3MFModelResourceIterator* objects = nullptr;
  REQUIRE(lib3mf_model_getmeshobjects(model, &objects) == 0);
  std::map<std::string, DWORD> triangles;
  for (BOOL more = false; lib3mf_resourceiterator_movenext(objects, &more) == 0 && more;) {
    PLib3MFModelResource* object = nullptr;
    REQUIRE(lib3mf_resourceiterator_getcurrent(objects, &object) == 0);
    char name[100];
    ULONG length = 0;
    REQUIRE(lib3mf_object_getnameutf8(object, name, sizeof name, &length) == 0);
    REQUIRE(lib3mf_meshobject_gettrianglecount(object, &triangles[name]) == 0);
    BOOL manifold = false;
    CHECK(lib3mf_meshobject_ismanifoldandoriented(object, &manifold) == 0);
    CHECK(manifold);
    lib3mf_release(object);
  }
  CHECK(triangles.size() == 3);
  CHECK(triangles["vein & 'lode'"] == 12);
  lib3mf_release(objects);
  lib3mf_release(reader);
  lib3mf_release(model);
}
#else
TEST_CASE("3mf: lib3MF reads it without a warning and finds closed objects") {
  NOT_RUN("lib3MF is not installed (Debian: lib3mf-dev)");
}
#endif
