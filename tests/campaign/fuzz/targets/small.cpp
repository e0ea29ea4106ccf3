// Counting comes before refinement, for that is what costs: the soup of each leaf alone says how many faces it
// has, and nodes that are placed in several ways count as often as they are placed.
#include "tests/campaign/fuzz/targets/small.h"

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/leaves/leaf.h"
#include "csg/tree/dag.h"

namespace cnrg::fuzz {
namespace {

constexpr std::size_t kMostParts = 160;     // faces, wires and points of all instances of leaves
constexpr std::size_t kMostInstances = 60;  // of nodes
constexpr int kMostSegments = 8;

/// The largest coordinate that a curved shape is made of.
class Extent {
 public:
  Rational value = 0;
  void add(const RationalPoint& p) {
    for (const Rational& x : p) value = std::max(value, Rational(abs(x)));
  }
  void add(const CurveNet& net) {
    for (const RationalPoint& p : net.points) add(p);
  }
  void add(const PatchNet& net) {
    for (const auto& row : net.points)
      for (const RationalPoint& p : row) add(p);
  }
  void add(const std::array<CurveNet, 4>& nets) {
    for (const CurveNet& net : nets) add(net);
  }
  void add(const ProfileLine& line) {
    for (const CurveNet& net : line.segments) add(net);
  }
};

struct Coarse {
  template <class S>
  void operator()(S& shape) const {
    if constexpr (requires { shape.segments; }) shape.segments = std::min(shape.segments, kMostSegments);
    if constexpr (requires { shape.rings; }) shape.rings = std::min(shape.rings, kMostSegments / 2);
    if constexpr (requires { shape.tessellation; }) coarsen(shape);
  }

 private:
  template <class S>
  static void coarsen(S& shape) {
    Tessellation& t = shape.tessellation;
    if (!t.chord) {
      t.segments = std::min(t.segments.value_or(kMostSegments), kMostSegments);
      return;
    }
    Extent extent;
    const auto add_all = [&](const auto& list) {
      for (const auto& item : list) extent.add(item);
    };
    if constexpr (requires { shape.patches; }) add_all(shape.patches);
    if constexpr (requires { shape.curves; }) add_all(shape.curves);
    if constexpr (requires { shape.profile; }) add_all(shape.profile.lines);
    t.chord = std::max(*t.chord, Rational(extent.value / 8));
  }
};

/// How many instances of nodes a tree has at most: paths from the result.
bool few_instances(const Tree& tree) {
  IdVector<NodeId, std::size_t> paths(tree.nodes.size(), 0);
  std::vector<NodeId> order = tree.dag->order();
  std::reverse(order.begin(), order.end());
  if (tree.result.valid()) paths[tree.result] = 1;
  std::size_t total = 0;
  for (const NodeId node : order) {
    total += paths[node];
    if (total > kMostInstances) return false;
    for (const NodeId operand : tree.dag->operands(node)) paths[operand] += paths[node];
  }
  return true;
}

std::size_t parts(const PreparedLeaf& leaf) {
  Soup soup;
  leaf.add_to(soup, Transform());
  return soup.face_count() + soup.wires().size() + soup.isolated().size();
}

bool few_parts(const Tree& tree) {
  std::size_t total = 0;
  for (const Node& node : tree.nodes) {
    if (node.shape) total += parts(*prepare(*node.shape));
    if (total > kMostParts) return false;
  }
  return true;
}

/// Names and volumes of the components of a result, sorted; a volume that is not finite is empty.
std::vector<std::pair<std::string, std::optional<Rational>>> components(const Result& result) {
  std::vector<std::pair<std::string, std::optional<Rational>>> list;
  for (Component i = 1; i <= result.component_count(); ++i) {
    list.emplace_back(result.attributes(i).name, result.volume(i));
  }
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

Folder::Folder() {
  const std::filesystem::path memory = "/dev/shm";
  std::error_code ignored;
  const auto base =
      std::filesystem::is_directory(memory, ignored) ? memory : std::filesystem::temp_directory_path();
  folder_ = (base / "cnrg_fuzz_XXXXXX").string();
  if (mkdtemp(folder_.data()) == nullptr) throw std::runtime_error("no folder " + folder_);
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void Folder::write(const std::string& name, std::string_view content) const {
  std::ofstream(path(name), std::ios::binary) << content;
}

const Folder& folder() {
  static const Folder one;
  return one;
}

void make_coarse(Tree& tree) {
  for (Node& node : tree.nodes) {
    if (node.shape) std::visit(Coarse{}, *node.shape);
  }
}

void evaluate_small(const Tree& tree) {
  if (!few_instances(tree) || !few_parts(tree)) return;
  EvaluateOptions options;
  options.threads = 1;
  options.validate = true;
  options.region_volumes = true;
  options.keep_all = true;
  const Result result = evaluate(tree, options).result();
  const std::string file = folder().path("result.json");
  write(file, result);
  const Result back = read_result(file);
  if (active_counts(back.cells()) != active_counts(result.cells())) fault("read back, cells are not as many");
  if (components(back) != components(result)) fault("read back, components have other names or volumes");
}

void fault(const std::string& what) { throw std::logic_error("fault: " + what); }

}  // namespace cnrg::fuzz
