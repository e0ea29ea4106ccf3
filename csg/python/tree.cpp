// Trees come as texts: what Python writes for an expression, and what it reads from a file, go one way, through
// the reader of tree files, which knows every leaf and every fault. Meshes alone are handed over as arrays.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <variant>

#include "bind.h"
#include "csg/tree/expression.h"
#include "csg/tree/yaml_value.h"
#include "numbers.h"

namespace cnrg::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style>;
using Numbers = py::array_t<std::int64_t, py::array::c_style>;

/// A mesh from arrays, which are copied: a node does not change when they do.
std::shared_ptr<const MeshData> mesh_of(const Doubles& points, const Numbers& corners, const Numbers& offsets) {
  auto data = std::make_shared<MeshData>();
  if (points.ndim() != 2 || points.shape(1) != 3)
    throw py::value_error("mesh: points must have the shape (n, 3), three coordinates for each");
  if (corners.ndim() != 1 || offsets.ndim() != 1 || offsets.size() == 0)
    throw py::value_error("mesh: corners and offsets must be lists of numbers");
  if (points.shape(0) > std::numeric_limits<std::int32_t>::max() ||
      corners.size() > std::numeric_limits<std::int32_t>::max())
    throw InputError("mesh: more than 2147483647 points or corners");
  data->xyz.assign(points.data(), points.data() + points.size());
  for (std::size_t i = 0; i < data->xyz.size(); ++i) {
    if (!std::isfinite(data->xyz[i])) {
      throw InputError("mesh: point " + std::to_string(i / 3) +
                       " has a coordinate that is not finite; remove the point or mend it");
    }
  }
  const std::int64_t count = points.shape(0);
  data->corners.reserve(std::size_t(corners.size()));
  for (py::ssize_t i = 0; i < corners.size(); ++i) {
    const std::int64_t corner = corners.data()[i];
    if (corner < 0 || corner >= count) {
      throw InputError("mesh: a face names the point " + std::to_string(corner) + ", but " +
                       (count == 0 ? std::string("there are none")
                                   : "they are numbered from 0 to " + std::to_string(count - 1)));
    }
    data->corners.push_back(std::uint32_t(corner));
  }
  data->offsets.clear();
  for (py::ssize_t i = 0; i < offsets.size(); ++i) {
    const std::int64_t offset = offsets.data()[i];
    const std::int64_t least = i == 0 ? 0 : std::int64_t(data->offsets.back()) + 3;
    if (offset < least || offset > corners.size() || (i == 0 && offset != 0))
      throw InputError("mesh: each face must have three corners or more");
    data->offsets.push_back(std::uint32_t(offset));
  }
  if (std::int64_t(data->offsets.back()) != corners.size())
    throw InputError("mesh: the offsets of faces must end with the number of corners");
  return data;
}

/// The exact coordinates of point i.
RationalPoint point_of(const MeshData& data, std::size_t i) {
  return {from_double(data.xyz[3 * i]), from_double(data.xyz[3 * i + 1]), from_double(data.xyz[3 * i + 2])};
}

/// `points: [...], faces: [...]` as in a tree file.
std::string mesh_text(const MeshData& data) {
  std::string text = "points: [";
  for (std::size_t i = 0; i < data.point_count(); ++i) {
    const RationalPoint p = point_of(data, i);
    text += (i == 0 ? "[" : ", [") + to_string(p[0]) + ", " + to_string(p[1]) + ", " + to_string(p[2]) + "]";
  }
  text += "], faces: [";
  for (std::size_t f = 0; f < data.face_count(); ++f) {
    text += f == 0 ? "[" : ", [";
    for (std::uint32_t i = data.offsets[f]; i < data.offsets[f + 1]; ++i)
      text += (i == data.offsets[f] ? "" : ", ") + std::to_string(data.corners[i]);
    text += "]";
  }
  return text + "]";
}

using InMemory = std::map<std::string, std::variant<std::shared_ptr<const MeshData>, ResultLeaf>>;

template <class Shape>
Shape& shape_of(Node& node) {
  auto* const shape = node.shape ? std::get_if<Shape>(&*node.shape) : nullptr;
  if (shape == nullptr) throw InvariantError("the node " + node.name + " is another leaf");
  return *shape;
}

/// Replaces what the text only names: the empty meshes by those given as arrays, and results.
void put(Tree& tree, const InMemory& in_memory) {
  for (const auto& [name, data] : in_memory) {
    Node& node = tree.nodes[tree.find(name)];
    if (const auto* const mesh = std::get_if<std::shared_ptr<const MeshData>>(&data)) {
      shape_of<MeshShape>(node).data = *mesh;
    } else {
      shape_of<ResultShape>(node).in_memory = std::get<ResultLeaf>(data).leaf;
    }
  }
}

py::object yaml_data(const YAML::Node& node, const ParameterValues& parameters) {
  if (node.IsSequence()) {
    py::list list;
    for (const YAML::Node& item : node) list.append(yaml_data(item, parameters));
    return list;
  }
  if (node.IsMap()) {
    py::dict map;
    for (const auto& entry : node)
      map[py::str(with_values(entry.first.Scalar(), parameters))] = yaml_data(entry.second, parameters);
    return map;
  }
  if (node.IsNull()) return py::none();
  const std::string& text = node.Scalar();
  if (node.Tag() != "!") {  // without quotes
    if (text == "true" || text == "True" || text == "TRUE") return py::bool_(true);
    if (text == "false" || text == "False" || text == "FALSE") return py::bool_(false);
  }
  return py::str(with_values(text, parameters));
}

/// A text as it is, and a number as the only item of a tuple.
py::object yaml_data(const Property& value) {
  const py::str text(to_text(value));
  if (std::holds_alternative<Rational>(value)) return py::make_tuple(text);
  return text;
}

py::object properties_of(const Node& node) {
  py::dict map;
  for (const auto& [key, value] : node.properties) map[py::str(key)] = yaml_data(value);
  return map;
}

/// The criteria by their keys in a tree, each a list; nodes below by number, by key, too; how many operands are
/// those of `inside`.
py::object picked_by(const Selector& selector) {
  const Criteria& c = selector.criteria;
  py::dict criteria;
  if (!c.dimensions.empty()) criteria["dimension"] = c.dimensions;
  if (!c.names.empty()) criteria["name"] = c.names;
  if (!c.materials.empty()) criteria["material"] = c.materials;
  if (!c.properties.empty()) {
    py::dict map;
    for (const auto& [key, value] : c.properties) {
      if (!map.contains(py::str(key))) map[py::str(key)] = py::list();
      py::list(map[py::str(key)]).append(yaml_data(value));
    }
    criteria["attributes"] = map;
  }
  if (!c.regions.empty() || !c.region_numbers.empty()) {
    py::list regions = py::cast(c.regions);
    for (const Component number : c.region_numbers) regions.append(number);
    criteria["region"] = regions;
  }
  if (!c.source_faces.empty()) criteria["source face"] = c.source_faces;
  if (!c.between.empty()) {
    py::list between;
    for (const auto& [first, second] : c.between) between.append(py::make_tuple(first, second));
    criteria["between"] = between;
  }
  std::map<std::string, std::vector<std::size_t>> below;
  for (const NodeId node : selector.from) below["from"].push_back(node.index());
  for (const Selector::Side& side : selector.sides)
    below[side.front ? "front of" : "behind"].push_back(side.of.index());
  return py::make_tuple(criteria, below, selector.inside);
}

/// A node of a tree file as data: what the reader decided of it, and the values of its keys as they are written.
struct NodeRecord {
  std::string name, operator_name;
  bool is_inline = false, is_leaf = false, forgets_features = false;
  int line = 1, column = 1;
  std::vector<std::size_t> operands;
  py::object value;                ///< of a leaf
  py::object picked = py::none();  ///< of `select`
  py::object within = py::none();  ///< of `simplify`, as a fraction in a text
  std::vector<std::pair<std::string, py::object>> attributes;
};

/// The records of a tree that was read from this text.
class Records {
 public:
  Records(const std::string& text, const Tree& tree) : tree_(tree), records_(tree.nodes.size()) {
    for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
      const Node& node = tree.nodes[id];
      if (node.is_inline && !node.is_layer) places_[{node.at.line, node.at.column}].push_back(id);
    }
    const YAML::Node nodes = YAML::Load(text)["nodes"];
    const Scope everywhere{NodeId(0), NodeId(tree.nodes.size()), tree.parameters};
    for (const auto& entry : nodes)
      add(tree.names.at(with_values(entry.first.Scalar(), tree.parameters)), entry.second, everywhere);
    while (!open_.empty()) {
      const auto [node, scope] = open_.back();
      open_.pop_back();
      find_inline(node, scope);
    }
  }
  std::vector<NodeRecord> take() { return std::move(records_); }

 private:
  /// The file, or a copy of `repeat`, whose inline nodes are one after the other.
  struct Scope {
    NodeId begin, end;
    ParameterValues parameters;
  };

  const Tree& tree_;
  std::vector<NodeRecord> records_;
  std::map<std::pair<int, int>, std::vector<NodeId>> places_;  // inline nodes; those of copies at one place
  std::vector<std::pair<YAML::Node, Scope>> open_;

  void find_inline(const YAML::Node& value, const Scope& scope) {
    if (value.IsSequence()) {
      for (const YAML::Node& item : value) find_inline(item, scope);
    } else if (value.IsMap()) {
      const auto place = places_.find({value.Mark().line + 1, value.Mark().column + 1});
      if (place == places_.end()) {
        for (const auto& entry : value) find_inline(entry.second, scope);
        return;
      }
      const std::vector<NodeId>& ids = place->second;
      const auto id = std::lower_bound(ids.begin(), ids.end(), scope.begin);
      if (id != ids.end() && *id < scope.end && records_[id->index()].name.empty()) add(*id, value, scope);
    }
  }

  void add(NodeId id, const YAML::Node& map, const Scope& scope) {
    const Node& node = tree_.nodes[id];
    NodeRecord& r = records_[id.index()];
    const bool repeats = node.operator_name == "repeat";
    r.name = node.name;
    const bool layers = node.operator_name == "layers";
    r.operator_name = !repeats && !layers              ? node.operator_name
                      : tree_.operands(id).size() == 1 ? "simplify"
                                                       : "union";
    if (layers) r.attributes.emplace_back("dominance", py::str("left"));
    r.is_inline = node.is_inline;
    r.is_leaf = node.op == Operator::leaf;
    r.forgets_features = node.op == Operator::simplify && node.forget_features;
    if (node.within) r.within = py::str(to_string(*node.within));
    r.line = node.at.line;
    r.column = node.at.column;
    if (node.selector) r.picked = picked_by(*node.selector);
    const std::vector<NodeId> operands = tree_.operands(id);
    for (const NodeId operand : operands) {
      r.operands.push_back(operand.index());
      if (tree_.nodes[operand].is_layer) add_made(operand);
    }
    for (const auto& entry : map) {
      const std::string key = with_values(entry.first.Scalar(), scope.parameters);
      const bool is_operand = key == "within";
      if (key == "attributes") r.attributes.emplace_back(key, properties_of(node));
      else if (is_of_others(key)) continue;
      else if (key != node.operator_name && !is_operand)
        r.attributes.emplace_back(key, yaml_data(entry.second, scope.parameters));
      else if (r.is_leaf) r.value = yaml_data(entry.second, scope.parameters);
      else if (repeats) add_copies(operands, entry.second, scope);
      else open_.emplace_back(entry.second, scope);
    }
  }

  /// A node that `layers` makes, and those below it.
  void add_made(NodeId id) {
    const Node& node = tree_.nodes[id];
    NodeRecord& r = records_[id.index()];
    if (!r.name.empty()) return;
    r.name = node.name;
    r.operator_name = node.operator_name;
    r.is_inline = true;
    r.line = node.at.line;
    r.column = node.at.column;
    if (!node.label.empty()) r.attributes.emplace_back("name", py::str(node.label));
    if (!node.material.empty()) r.attributes.emplace_back("material", py::str(node.material));
    for (const NodeId operand : tree_.operands(id)) {
      r.operands.push_back(operand.index());
      if (tree_.nodes[operand].is_layer) add_made(operand);
    }
  }

  void add_copies(const std::vector<NodeId>& copies, const YAML::Node& repeat, const Scope& scope) {
    const YAML::Node of = repeat["of"];
    const std::string index = with_values(repeat["index"].Scalar(), scope.parameters);
    for (std::size_t i = 0; i < copies.size(); ++i) {
      Scope within{copies[i], i + 1 < copies.size() ? copies[i + 1] : scope.end, scope.parameters};
      within.parameters[index] = Rational(static_cast<std::int64_t>(i));
      add(copies[i], of, within);
    }
  }
};

TreeObject parse(const std::string& text, const std::string& file, const InMemory& in_memory,
                 const std::string& inside, const std::map<std::string, std::string>& parameters) {
  Tree tree = parse_tree(text, file, {inside, parameters});
  put(tree, in_memory);
  return {std::make_shared<const Tree>(std::move(tree)), text};
}

}  // namespace

void bind_tree(py::module_& module) {
  py::class_<MeshData, std::shared_ptr<MeshData>>(module, "MeshData")
      .def(py::init([](const Doubles& points, const Numbers& corners, const Numbers& offsets) {
        return std::const_pointer_cast<MeshData>(mesh_of(points, corners, offsets));
      }))
      .def_property_readonly("point_count", &MeshData::point_count)
      .def_property_readonly("face_count", &MeshData::face_count)
      .def("text", &mesh_text)
      .def(py::pickle(
          [](const MeshData& data) {
            const Doubles points({py::ssize_t(data.point_count()), py::ssize_t(3)}, data.xyz.data());
            const std::vector<std::int64_t> corners(data.corners.begin(), data.corners.end());
            const std::vector<std::int64_t> offsets(data.offsets.begin(), data.offsets.end());
            return py::make_tuple(points, Numbers(py::ssize_t(corners.size()), corners.data()),
                                  Numbers(py::ssize_t(offsets.size()), offsets.data()));
          },
          [](const py::tuple& state) {
            if (state.size() != 3) throw py::value_error("this is no mesh that was pickled");
            return std::const_pointer_cast<MeshData>(
                mesh_of(state[0].cast<Doubles>(), state[1].cast<Numbers>(), state[2].cast<Numbers>()));
          }));

  py::class_<NodeRecord>(module, "NodeRecord")
      .def_readonly("name", &NodeRecord::name)
      .def_readonly("operator_name", &NodeRecord::operator_name)
      .def_readonly("is_inline", &NodeRecord::is_inline)
      .def_readonly("is_leaf", &NodeRecord::is_leaf)
      .def_readonly("forgets_features", &NodeRecord::forgets_features)
      .def_readonly("line", &NodeRecord::line)
      .def_readonly("column", &NodeRecord::column)
      .def_readonly("operands", &NodeRecord::operands)
      .def_readonly("value", &NodeRecord::value)
      .def_readonly("picked", &NodeRecord::picked)
      .def_readonly("within", &NodeRecord::within)
      .def_readonly("attributes", &NodeRecord::attributes);

  py::class_<TreeObject>(module, "Tree")
      .def_static(
          "read",
          [](const std::string& path, const std::string& inside,
             const std::map<std::string, std::string>& parameters) {
            const Tree tree = read_tree(path, {inside, parameters});
            std::ifstream file(path, std::ios::binary);
            std::string text{std::istreambuf_iterator<char>(file), {}};
            return TreeObject{std::make_shared<const Tree>(tree), std::move(text)};
          },
          py::arg("path"), py::arg("inside"), py::arg("parameters"))
      .def_static("parse", &parse, py::arg("text"), py::arg("file"), py::arg("in_memory"), py::arg("inside"),
                  py::arg("parameters"))
      .def_property_readonly("file", [](const TreeObject& t) { return t.tree->file; })
      .def_property_readonly("result", [](const TreeObject& t) { return t.tree->result.index(); })
      .def_property_readonly("text", [](const TreeObject& t) { return t.text; })
      .def_property_readonly("weld",
                             [](const TreeObject& t) -> py::object {
                               return t.tree->weld ? py::object(py::str(to_string(*t.tree->weld)))
                                                   : py::object(py::none());
                             })
      .def("records", [](const TreeObject& t) { return Records(t.text, *t.tree).take(); })
      .def("materials",
           [](const TreeObject& t) {
             py::list list;
             const YAML::Node materials = YAML::Load(t.text)["materials"];
             if (!materials || !materials.IsMap()) return list;
             for (const auto& entry : materials)
               list.append(py::make_tuple(with_values(entry.first.Scalar(), t.tree->parameters),
                                          yaml_data(entry.second, t.tree->parameters)));
             return list;
           })
      .def("check", [](const TreeObject& t) {
        std::vector<std::string> texts;
        for (const Diagnostic& d : check(*t.tree)) texts.push_back(d.text());
        return texts;
      });
}

}  // namespace cnrg::python
