// How long a value lives: until its last user has run, unless a root or `keep_all` keeps it.
#include "csg/evaluate/value_store.h"

#include <memory>
#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

const Tree& tree() {
  static const Tree kTree = parse_tree(R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  b: {box: {min: [1, 1, 1], max: [3, 3, 3]}}
  twice: {union: [a, a]}
  both: {difference: [a, b]}
  top: {union: [twice, both]}
result: top
)",
                                       "t.yaml");
  return kTree;
}

/// All values put, as a leaf or an operator would.
struct Filled {
  explicit Filled(std::vector<std::string> roots, bool keep_all = false)
      : unfolding(unfold(tree(), ids(roots))), values(unfolding.instances.size(), keep_all) {
    for (const Instance& instance : unfolding.instances) {
      for (const InstanceId operand : instance.operands) values.add_use(operand);
    }
    for (const InstanceId root : unfolding.roots) values.add_use(root);
    for (const InstanceId i : IdRange<InstanceId>(unfolding.instances.size())) {
      CHECK_FALSE(values.has(i));
      values.put(i, NodeValue());
      seen.push_back(values.share(i));
    }
  }
  static std::vector<NodeId> ids(const std::vector<std::string>& names) {
    std::vector<NodeId> out;
    for (const std::string& name : names) out.push_back(tree().find(name));
    return out;
  }
  InstanceId at(const std::string& name) const {
    InstanceId i(0);
    while (unfolding.instances[i].node != tree().find(name)) ++i;
    return i;
  }
  bool has(const std::string& name) const { return values.has(at(name)); }
  bool lives(const std::string& name) const { return !seen[at(name)].expired(); }
  void run(const std::string& user) { values.release(unfolding.instances[at(user)].operands); }

  Unfolding unfolding;
  ValueStore values;
  IdVector<InstanceId, std::weak_ptr<const NodeValue>> seen;
};

TEST_CASE("a value is freed when its last user has run", "[values]") {
  Filled f({"top"});
  CHECK_FALSE(f.values.expendable(f.at("a")));  // three places need it
  f.run("twice");
  CHECK(f.has("a"));
  CHECK(f.values.expendable(f.at("a")));
  f.run("both");
  CHECK_FALSE(f.has("a"));
  CHECK_FALSE(f.lives("a"));
  CHECK_FALSE(f.lives("b"));
  CHECK(f.lives("twice"));
  f.run("top");
  CHECK_FALSE(f.lives("twice"));
  CHECK_FALSE(f.lives("both"));
  CHECK(f.lives("top"));
}

TEST_CASE("who uses a value in two places is no last user until both are gone", "[values]") {
  Filled f({"twice"});
  CHECK_FALSE(f.values.used_once_more(f.at("a")));
  CHECK_FALSE(f.values.expendable(f.at("a")));
  f.run("twice");
  CHECK_FALSE(f.lives("a"));
}

TEST_CASE("the value of a root stays, and no operator takes it apart", "[values]") {
  Filled f({"top", "both"});
  CHECK_FALSE(f.values.expendable(f.at("both")));
  for (const char* user : {"twice", "both", "top"}) f.run(user);
  CHECK(f.lives("both"));
  CHECK(f.values.used_once_more(f.at("both")));
  CHECK_FALSE(f.lives("twice"));
}

TEST_CASE("with keep_all every value stays whole", "[values]") {
  Filled f({"top"}, true);
  CHECK_FALSE(f.values.expendable(f.at("twice")));
  for (const char* user : {"twice", "both", "top"}) f.run(user);
  for (const auto& value : f.values.take()) CHECK(value != nullptr);
}

TEST_CASE("a value outlives the evaluation's end if it is kept, and all do with keep_all", "[values]") {
  EvaluateOptions options;
  options.nodes = {tree().find("both")};
  const Evaluation some = evaluate(tree(), options);
  CHECK(some.values.size() == 0);
  REQUIRE(some.kept.size() == 2);
  options.keep_all = true;
  const Evaluation all = evaluate(tree(), options);
  REQUIRE(all.values.size() == all.instances.size());
  for (const InstanceId i : IdRange<InstanceId>(all.instances.size())) {
    const Group& group = all.values[i]->group();
    CHECK(group.regions.size() == 1);
    if (all.instances[i].node == tree().find("both")) {
      CHECK(group.cells == some.value(tree().find("both")).group().cells);
      CHECK(all.values[i] == all.value(tree().find("both")).value);
    }
  }
}

}  // namespace
}  // namespace cnrg
