#include "bench/sweep/experiment.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "bench/cases/tree_problem.h"
#include "bench/peers/program.h"
#include "csg/evaluate/evaluate.h"
#include "csg/text/input_file.h"
#include "csg/text/number.h"
#include "csg/tree/read_selector.h"
#include "csg/tree/suggest.h"
#include "csg/tree/tree.h"
#include "csg/tree/yaml_value.h"
#include "kernel/exact/integers.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostProblems = 1'000'000, kMostBytes = 10'000'000, kLongestName = 200, kLongestValue = 40;
constexpr std::string_view kNode = "node";
/// What a family's maker is told, and what rows tell of any problem.
constexpr std::array<std::string_view, 4> kRoles{"operation", "size", "k", "seed"};

std::string file_word(std::string text) {
  for (char& c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-' && c != '_') c = '_';
  return text;
}

/// A long value as its first letters, and a number that tells it from others.
std::string short_word(const std::string& value) {
  if (value.size() <= kLongestValue) return file_word(value);
  return file_word(value.substr(0, 16)) + "_" + digest(value);
}

bool is_word(const std::string& text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 && file_word(text) == text;
}

/// `1/3`, `10^-3`, `exact`: a number in lowest terms, or a word. Throws InputError for anything else.
std::string value_of(const std::string& text) {
  try {
    return cnrg::to_string(evaluate_expression(text, {}));
  } catch (const InputError&) {
    if (is_word(text)) return text;
    throw;
  }
}

/// One value, or whole numbers from `LOW..HIGH`.
void add_values(const std::string& text, std::vector<std::string>& values) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    const std::size_t dash = text.find('-');
    const auto digits = [](const std::string& part) {
      return !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
    };
    if (dash != std::string::npos && digits(text.substr(0, dash)) && digits(text.substr(dash + 1)))
      throw InputError("`" + text + "` is " + value_of(text) + "; a range is written " + text.substr(0, dash) +
                       ".." + text.substr(dash + 1) + ", a difference with blanks");
    values.push_back(value_of(text));
    return;
  }
  const Rational low = evaluate_expression(text.substr(0, dots), {}),
                 high = evaluate_expression(text.substr(dots + 2), {});
  if (low.get_den() != 1 || high.get_den() != 1 || low > high || high - low >= kMostProblems)
    throw InputError("`" + text + "` is no range of whole numbers, such as 0..16");
  for (Rational value = low; value <= high; value += 1) values.push_back(cnrg::to_string(value));
}

std::string list_of(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

// --- the file

std::vector<std::string> texts(const Value& value, const std::string& what) {
  std::vector<std::string> all;
  for (const Value& v : one_or_more(value, what)) all.push_back(v.text(what));
  return all;
}

/// The form of a map of an experiment: its keys, each with what a message proposes for it if it is required.
Form form_of(std::initializer_list<std::pair<std::string_view, std::string_view>> keys) {
  static std::deque<Type> types;  // values are read without them
  Form form;
  for (const auto& [name, proposed] : keys) {
    types.emplace_back().hint = proposed;
    form.keys.push_back({name, &types.back(), proposed.empty() ? "" : "required", {}});
  }
  return form;
}

Parameter read_parameter(const Value::Entry& entry) {
  const std::string what = "`" + entry.key + "` of values";
  Parameter parameter{entry.key, {}};
  std::optional<Value> values(entry.value);
  if (entry.value.is_map()) {
    static const Form form = form_of({{"values", "0..16"}, {"means", {}}});
    const Fields f(entry.value, form, entry.key);
    values.emplace(f.at("values"));
    if (const Value* means = f.find("means")) parameter.means = means->text(f.name("means"));
  }
  for (const Value& v : one_or_more(*values, what)) {
    try {
      add_values(v.text(what), parameter.values);
    } catch (const TreeError&) {
      throw;
    } catch (const InputError& error) {
      v.fail(what + ": " + error.what());
    }
  }
  std::vector<std::string> sorted = parameter.values;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) values->fail(what + " has " + *twice + " twice; remove one");
  return parameter;
}

void read_system(const Value& value, Experiment& experiment) {
  if (!value.is_map()) {
    experiment.systems.push_back(value.text("a system"));
    return;
  }
  static const Form form =
      form_of({{"name", "mine"}, {"program", "./my-boolean"}, {"rounding", {}}, {"rescale", {}}});
  const Fields f(value, form, "a system");
  ProgramSystem system;
  system.name = f.at("name").text(f.name("name"));
  system.words = texts(f.at("program"), f.name("program"));
  if (const Value* rounding = f.find("rounding")) {
    system.rounding = to_double(rounding->number(f.name("rounding")));
    if (!(system.rounding >= 0 && system.rounding < 1))
      rounding->fail(f.name("rounding") + " is no part of the largest coordinate, such as 1e-12");
  }
  if (const Value* rescale = f.find("rescale"))
    system.rescale = static_cast<int>(rescale->integer(f.name("rescale"), -1000, 1000));
  try {
    system.words[0] = program_path(system.name, fs::path(experiment.path).parent_path() / system.words[0]);
  } catch (const std::runtime_error& error) {
    value.fail(error.what());
  }
  experiment.systems.push_back(system.name);
  experiment.programs.push_back(std::move(system));
}

void read_claims(const Value& value, Experiment& experiment) {
  for (const Value::Entry& entry : value.entries("`truth`")) {
    if (std::find(experiment.nodes.begin(), experiment.nodes.end(), entry.key) == experiment.nodes.end())
      value.document().fail(entry.key_at, "`" + entry.key + "` is no node of this experiment; there are " +
                                              list_of(experiment.nodes));
    static const Form form = form_of({{"volume", {}}, {"node", {}}});
    const Fields f(entry.value, form, "truth of `" + entry.key + "`");
    Claim& claim = experiment.claims[entry.key];
    if (const Value* volume = f.find("volume")) claim.volume = volume->text(f.name("volume"));
    if (const Value* node = f.find("node")) claim.node = node->text(f.name("node"));
    if (claim.volume.empty() == claim.node.empty())
      entry.value.fail("the truth is a `volume`, an expression of the parameters, or another `node`: one of them");
    if (claim.volume.empty() || !experiment.program.empty()) continue;  // what it prints may have other parameters
    try {
      evaluate_expression(claim.volume, value.document().parameters);
    } catch (const InputError& error) {
      f.find("volume")->fail(error.what());
    }
  }
}

double limit_of(const Fields& f, const char* key) {
  const Value& value = *f.find(key);
  const Rational limit = value.number(f.name(key));
  if (limit < Rational(1) / 100 || limit > 100'000) value.fail(f.name(key) + " is from 0.01 to 100000");
  return to_double(limit);
}

/// Nodes that other systems have, by `all`.
std::vector<std::string> boolean_nodes(const Tree& tree) {
  std::vector<std::string> nodes;
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size()))
    if (!tree.nodes[id].is_inline && is_tree_problem(tree, id)) nodes.push_back(tree.nodes[id].name);
  return nodes;
}

std::vector<std::string> operator_nodes(const Tree& tree) {
  std::vector<std::string> nodes;
  for (const Node& node : tree.nodes)
    if (node.op != Operator::leaf) nodes.push_back(node.name);
  return nodes;
}

/// Of the tree of the file: those that it names, `all` of them, or its result.
void choose_nodes(const Tree& tree, const Value* said, Experiment& experiment) {
  const bool results = experiment.compared == Compared::results;
  if (said == nullptr) experiment.nodes = {tree.nodes[tree.result].name};
  if (experiment.nodes == std::vector<std::string>{"all"}) {
    experiment.nodes = results ? boolean_nodes(tree) : operator_nodes(tree);
    if (experiment.nodes.empty())
      said->fail(results ? "no union, intersection or difference of this tree has a name"
                         : "this tree has no operator");
  }
  try {
    for (const std::string& node : experiment.nodes)
      if (tree.nodes[tree.find(node)].op == Operator::leaf && !results)
        throw InputError("`" + node + "` is a leaf, which systems are given: name a node with an operator");
  } catch (const InputError& error) {
    if (said == nullptr) throw TreeError(tree.file, tree.nodes[tree.result].at, error.what());
    said->fail(error.what());
  }
}

constexpr std::array<std::pair<std::string_view, Compared>, 3> kCompared{
    {{"results", Compared::results}, {"sets", Compared::sets}, {"regions", Compared::regions}}};

std::vector<Compared> read_compared(const Value& value, const std::string& what) {
  std::vector<Compared> kinds;
  for (const Value& v : one_or_more(value, what)) {
    const std::string word = v.text(what);
    const auto it =
        std::find_if(kCompared.begin(), kCompared.end(), [&](const auto& known) { return known.first == word; });
    if (it == kCompared.end()) v.fail_type(what, "results, sets, regions or several of them");
    if (std::find(kinds.begin(), kinds.end(), it->second) != kinds.end()) v.fail(what + " has " + word + " twice");
    kinds.push_back(it->second);
  }
  return kinds;
}

/// The same experiment on another kind of what is compared.
Experiment of_kind(Experiment experiment, Compared kind) {
  experiment.compared = kind;
  if (kind == Compared::results) return experiment;
  experiment.name += kind == Compared::sets ? ".sets" : ".regions";
  experiment.title += kind == Compared::sets ? ": sets of marked cells" : ": regions";
  experiment.claims.clear();
  return experiment;
}

/// A tree alone: all its nodes, in each way in which they can be compared.
std::vector<Experiment> experiments_of_tree(const Tree& tree, const Document& document, Experiment base) {
  std::vector<Experiment> experiments;
  for (const auto& [word, kind] : kCompared) {
    Experiment experiment = of_kind(base, kind);
    experiment.nodes = kind == Compared::results ? boolean_nodes(tree) : operator_nodes(tree);
    if (!experiment.nodes.empty()) experiments.push_back(std::move(experiment));
  }
  if (experiments.empty()) document.fail({}, "this tree has no operator, which systems could be given");
  return experiments;
}

std::vector<Experiment> read_experiment_file(const fs::path& path) {
  Experiment experiment;
  experiment.name = file_word(path.stem().string());
  if (experiment.name[0] == '.' || experiment.name[0] == '-')
    experiment.name[0] = '_';  // neither hidden nor an option
  experiment.path = fs::absolute(path).lexically_normal().string();
  experiment.text = cnrg::read_file(path.string(), {}, kMostBytes);
  Document document{path.string(), experiment.text.size() + 1000};
  const YAML::Node root = load_yaml(document, experiment.text);
  const YAML::Node own = root.IsMap() ? root["x-experiment"] : YAML::Node();
  if (root.IsMap())
    for (const auto& entry : root) {
      if (!entry.first.IsScalar() || own.IsDefined()) continue;
      const std::string hint = did_you_mean(entry.first.Scalar(), std::array<std::string_view, 1>{"x-experiment"});
      if (!hint.empty())
        Value(document, entry.first, {}).fail("unknown key `" + entry.first.Scalar() + "`" + hint);
    }
  std::optional<Tree> tree;
  if (!own.IsDefined() || root["nodes"].IsDefined()) {
    tree = parse_tree(experiment.text, path.string());
    document.parameters = tree->parameters;
  }
  if (!own.IsDefined()) {
    experiment.title = "each node of " + path.filename().string();
    return experiments_of_tree(*tree, document, std::move(experiment));
  }
  const Value value(document, own, {});
  static const Form form = form_of({{"title", "what is tried"},
                                    {"values", {}},
                                    {"nodes", {}},
                                    {"family", {}},
                                    {"program", {}},
                                    {"truth", {}},
                                    {"systems", {}},
                                    {"seconds", {}},
                                    {"gigabytes", {}},
                                    {"runs", {}},
                                    {"growth", {}},
                                    {"compare", {}}});
  const Fields f(value, form, "x-experiment");
  experiment.title = f.at("title").text(f.name("title"));
  if (const Value* family = f.find("family")) experiment.family = family->text(f.name("family"));
  if (const Value* program = f.find("program")) {
    experiment.program = texts(*program, f.name("program"));
    experiment.program[0] = fs::absolute(path.parent_path() / experiment.program[0]).lexically_normal().string();
  }
  if (!experiment.family.empty() + !experiment.program.empty() + tree.has_value() != 1)
    value.fail(
        "problems come from `nodes` of this file, from a `program` that prints a tree, or from a `family`: "
        "give one of them");
  if (const Value* values = f.find("values"))
    for (const Value::Entry& entry : values->entries(f.name("values"))) {
      if (entry.key == kNode || !is_parameter_name(entry.key))
        document.fail(entry.key_at, "`" + entry.key + "` is no name of a parameter");
      if (!experiment.family.empty() && std::find(kRoles.begin(), kRoles.end(), entry.key) == kRoles.end())
        document.fail(entry.key_at,
                      "a family has the parameters operation, size, k and seed, and no `" + entry.key + "`");
      experiment.parameters.push_back(read_parameter(entry));
    }
  if (const Value* nodes = f.find("nodes")) {
    if (!experiment.family.empty()) nodes->fail("a family has no nodes: leave `nodes` out");
    experiment.nodes = texts(*nodes, f.name("nodes"));
  }
  std::vector<Compared> kinds{Compared::results};
  if (const Value* compare = f.find("compare")) {
    kinds = read_compared(*compare, f.name("compare"));
    if (!experiment.family.empty()) compare->fail("of a family results are compared: leave `compare` out");
  }
  if (!tree && experiment.family.empty() && experiment.nodes.empty())
    value.fail("say which `nodes` of the trees that the program prints are problems");
  if (const Value* systems = f.find("systems"))
    for (const Value& v : one_or_more(*systems, f.name("systems"))) read_system(v, experiment);
  if (f.has("seconds")) experiment.seconds = limit_of(f, "seconds");
  if (f.has("gigabytes")) experiment.gigabytes = limit_of(f, "gigabytes");
  if (const Value* runs = f.find("runs"))
    experiment.warm_runs = static_cast<int>(runs->integer(f.name("runs"), 1, 1000)) - 1;
  if (const Value* growth = f.find("growth")) {
    experiment.growth = growth->text(f.name("growth"));
    if (experiment.growth != "triangles" &&
        (experiment.growth != "size" || experiment.parameter("size") == nullptr))
      growth->fail_type(f.name("growth"), "triangles, or size where there is a parameter `size`");
  }
  std::vector<Experiment> experiments;
  for (const Compared kind : kinds) {
    Experiment& one = experiments.emplace_back(of_kind(experiment, kind));
    if (tree) choose_nodes(*tree, f.find("nodes"), one);
    const Value* const truth = f.find("truth");
    if (truth != nullptr && kind == Compared::results) read_claims(*truth, one);
  }
  if (const Value* truth = f.find("truth"); truth != nullptr && experiments[0].claims.empty())
    truth->fail("a truth is one of results: compare them, too, or leave `truth` out");
  return experiments;
}

Experiment read_folder(const fs::path& path) {
  Experiment experiment;
  experiment.name = "files";
  experiment.title = "meshes of a folder: two that belong together, or one and its copy turned about its middle";
  experiment.path = fs::canonical(path).string();
  experiment.parameters = {{"operation", {"union"}}};
  return experiment;
}

// --- problems

Tree tree_of(const Experiment& experiment, const Values& values) {
  if (experiment.program.empty()) {
    ReadOptions options;
    for (const auto& [name, value] : values)
      if (name != kNode) options.parameters[name] = value;
    return parse_tree(experiment.text, experiment.path, options);
  }
  std::vector<std::string> words = experiment.program;
  for (const auto& [name, value] : values)
    if (name != kNode) words.push_back(name + "=" + value);
  const TemporaryFolder folder;
  const std::string out = folder.file("tree.yaml");
  const ProgramRun run = run_program(words, folder, out.c_str());
  if (!run.succeeded()) throw std::runtime_error(experiment.program[0] + ": " + run.reason());
  return parse_tree(cnrg::read_file(out), experiment.program[0] + " (what it prints)");
}

template <class Integer>
Integer whole_number(const Experiment& experiment, const std::string& name, const std::string& text,
                     std::int64_t low, std::int64_t high) {
  const std::optional<Rational> value = parse_rational(text);
  if (!value || value->get_den() != 1 || *value < low || *value > high)
    throw std::runtime_error(experiment.name + ": `" + name + "` is a whole number from " + std::to_string(low) +
                             " to " + std::to_string(high) + ", not " + text);
  return to_machine<Integer>(value->get_num());
}

std::string name_of(const Experiment& experiment, const Experiment::Named& problem) {
  if (!experiment.family.empty()) {
    ProblemId id = experiment.roles(problem);
    id.family = experiment.name;
    return id.name();
  }
  const std::string& node = problem.values.at(std::string(kNode));
  std::string word = file_word(node);
  for (std::size_t i = 0; i < node.size(); ++i)
    if (node[i] == '/') word[i] = '+';  // of an inline node
  std::string name = experiment.name + "-" + word;
  for (const Parameter& p : experiment.parameters) {
    const std::string& value = problem.values.at(p.name);
    name += "-" + (is_word(value) ? value : p.name + short_word(value));
  }
  return name;
}

Claimed claimed_of(const Experiment& experiment, const Tree& tree, const Values& values) {
  const std::string& node = values.at(std::string(kNode));
  const auto it = experiment.claims.find(node);
  if (it == experiment.claims.end()) return {};
  const Claim& claim = it->second;
  if (!claim.node.empty()) return {{}, tree_model(tree, tree.find(claim.node), tree.find(node))};
  ParameterValues numbers = tree.parameters;
  for (const auto& [name, value] : values)
    if (const auto number = parse_rational(value)) numbers[name] = *number;
  return {evaluate_expression(claim.volume, numbers), {}};
}

}  // namespace

std::string digest(const std::string& text) {
  std::uint64_t mix = 14695981039346656037u;
  for (const char c : text) mix = (mix ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return std::to_string(mix);
}

const Parameter* Experiment::parameter(const std::string& wanted) const {
  const auto it =
      std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == wanted; });
  return it == parameters.end() ? nullptr : &*it;
}

bool Experiment::is_own() const { return fs::path(path).parent_path() == fs::path(CNRG_EXPERIMENTS); }

std::vector<Experiment::Named> Experiment::problems() const {
  std::vector<Named> all;
  if (is_folder()) {
    for (const std::string& operation : parameter("operation")->values)
      for (const std::string& problem : folder_problems(path, operation))
        all.push_back({problem, {{"operation", operation}}});
    return all;
  }
  std::vector<Parameter> axes;
  if (family.empty()) axes.push_back({std::string(kNode), nodes});
  axes.insert(axes.end(), parameters.begin(), parameters.end());
  std::size_t count = 1;
  for (const Parameter& axis : axes) {
    count *= axis.values.size();
    if (count > kMostProblems) throw std::runtime_error(path + ": there are more than a million problems");
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    Named& problem = all.emplace_back();
    std::size_t rest = i;
    for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
      problem.values[axis->name] = axis->values[rest % axis->values.size()];
      rest /= axis->values.size();
    }
    problem.name = name_of(*this, problem);
    if (!names.insert(problem.name).second)
      throw std::runtime_error(path + ": two problems are called " + problem.name +
                               "; rename a parameter or a node");
  }
  return all;
}

Problem Experiment::make(const Named& named) const {
  Problem problem;
  if (is_folder()) {
    problem = make_folder_problem(path, named.name);
  } else if (!family.empty()) {
    problem = make_problem(roles(named));
  } else {
    const auto tree = std::make_shared<const Tree>(tree_of(*this, named.values));
    const NodeId node = tree->find(named.values.at(std::string(kNode)));
    problem = tree_problem(*tree, node);
    problem.tree = tree;
    problem.node = node;
  }
  problem.name = named.name;
  return problem;
}

Tree Experiment::tree(const Named& named) const { return tree_of(*this, named.values); }

void Experiment::check(const Named& named) const {
  const ProblemId id = roles(named);
  if (is_folder()) {
    make(named);
  } else if (!family.empty()) {
    try {
      check_problem(id);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path + ": " + error.what());
    }
  } else {
    if (named.name.size() > kLongestName)
      throw std::runtime_error(path + ": the name of a problem has more than 200 letters: " + named.name);
    const Tree tree = tree_of(*this, named.values);
    const NodeId node = tree.find(named.values.at(std::string(kNode)));
    if (compared == Compared::results) check_tree_problem(tree, node);
    else cnrg::check(tree);
    claimed_of(*this, tree, named.values);
  }
}

Claimed Experiment::claimed(const Named& named) const {
  if (claims.empty()) return {};
  return claimed_of(*this, tree_of(*this, named.values), named.values);
}

ProblemId Experiment::roles(const Named& named) const {
  ProblemId id{family.empty() ? name : family, {}, family.empty() ? -1 : 1, {}, 1};
  const auto value = [&](const char* role) {
    const auto it = named.values.find(role);
    return it == named.values.end() ? std::string() : it->second;
  };
  id.operation = value("operation");
  if (const std::string size = value("size"); !size.empty())
    id.size = whole_number<long>(*this, "size", size, 0, 1'000'000'000);
  if (const std::string k = value("k"); !k.empty() && k != "exact")
    id.distance = whole_number<int>(*this, "k", k, 0, 300);
  if (const std::string seed = value("seed"); !seed.empty())
    id.seed = whole_number<unsigned>(*this, "seed", seed, 0, 1'000'000'000);
  return id;
}

GivenValues given_values(const std::string& text) {
  const std::size_t equals = text.find('=');
  GivenValues given{text.substr(0, equals), {}};
  if (equals == std::string::npos || !is_parameter_name(given.name) || equals + 1 == text.size() ||
      text.back() == ',')
    throw std::runtime_error("'" + text + "' is no NAME=VALUE,LOW..HIGH,...");
  std::istringstream parts(text.substr(equals + 1));
  try {
    for (std::string part; std::getline(parts, part, ',');) add_values(part, given.values);
  } catch (const InputError& error) {
    throw std::runtime_error("'" + text + "': " + error.what());
  }
  return given;
}

std::vector<std::string> experiment_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(CNRG_EXPERIMENTS))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

std::vector<Experiment> found_experiments(const std::string& name) {
  const fs::path own = fs::path(CNRG_EXPERIMENTS) / (name + ".yaml");
  if (is_word(name) && fs::exists(own)) return read_experiment_file(own);
  if (fs::is_directory(name)) return {read_folder(name)};
  if (fs::exists(name)) return read_experiment_file(name);
  const std::vector<std::string> names = experiment_names();
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string hint = did_you_mean(name, known);
  throw std::runtime_error("'" + name + "' is no experiment, file or folder" +
                           (hint.empty() ? "; `--list` lists experiments" : hint));
}

}  // namespace

std::vector<Experiment> read_experiments(const std::string& name, const std::vector<GivenValues>& given,
                                         std::set<std::string>& used) {
  std::vector<Experiment> experiments = found_experiments(name);
  for (Experiment& experiment : experiments) {
    for (Parameter& parameter : experiment.parameters) {
      parameter.usual = parameter.values;
      for (const GivenValues& values : given) {
        if (parameter.name != values.name) continue;
        parameter.values = values.values;
        used.insert(values.name);
      }
    }
  }
  return experiments;
}

}  // namespace cnrg::bench
