// The command line: what is asked for, and how the program ends.
//
// Results go to standard output; everything said about them goes to standard error.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <memory>

#include "csg/app/commands.h"
#include "csg/app/exit_status.h"
#include "csg/app/manual.h"
#include "csg/app/program_text.h"
#include "csg/app/run_program.h"
#include "csg/app/versions.h"
#include "csg/text/digits.h"
#include "csg/text/file.h"
#include "csg/text/number.h"
#include "csg/tree/expression.h"
#include "csg/tree/suggest.h"
#include "kernel/base/error.h"

namespace cnrg::app {
namespace {

/// What is wrong with the name of a file, a folder or a node.
std::string name_fault(const std::string& name) { return name.empty() ? "the name is empty" : ""; }

/// A whole number from `low` to `high`.
CLI::Validator whole_check(std::uint64_t low, std::uint64_t high) {
  const std::string from = std::to_string(low), to = std::to_string(high);
  return CLI::Validator(
      [=](std::string& text) {
        std::uint64_t value = 0;
        const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool read = fault == std::errc() && end == text.data() + text.size();
        return read && value >= low && value <= high
                   ? std::string()
                   : "`" + text + "` is not a whole number from " + from + " to " + to;
      },
      "INT in [" + from + " - " + to + "]");
}

/// How a tree is read.
template <class Arguments>
void add_fineness(CLI::App* sub, Arguments& arguments) {
  sub->add_option("--finer", arguments.finer,
                  "Curved leaves are K times finer than the tree says: segments times K, chord by K squared")
      ->type_name("K")
      ->check(whole_check(1, 1000));
  sub->add_option_function<std::vector<std::string>>(
         "-D",
         [&arguments](const std::vector<std::string>& all) {
           for (const std::string& one : all) {
             const std::size_t sign = one.find('=');
             if (sign == std::string::npos || sign + 1 == one.size() || !is_parameter_name(one.substr(0, sign)))
               throw CLI::ValidationError("-D", "`" + one + "` is no NAME=NUMBER, such as R=5/2");
             if (!arguments.reading.parameters.emplace(one.substr(0, sign), one.substr(sign + 1)).second)
               throw CLI::ValidationError("-D", "`" + one.substr(0, sign) + "` is given twice");
           }
         },
         "A parameter of the tree is this number, or expression; may be repeated")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false);
  sub->add_option("--inside", arguments.reading.inside,
                  "For a tree that is not trusted: refuse every file that it names outside of this folder")
      ->type_name("FOLDER")
      ->check(name_fault);
}

/// What all commands have that read a tree.
template <class Arguments>
void add_tree(CLI::App* sub, Arguments& arguments,
              const char* what =
                  "Tree (YAML or JSON, or a .csg file of OpenSCAD), exact result, mesh or CAD model; `-` "
                  "for a tree on standard input") {
  sub->add_option("TREE", arguments.tree, what)->required()->check(name_fault);
  add_fineness(sub, arguments);
}

/// What all commands have that evaluate.
void add_threads(CLI::App* sub, int& threads) {
  sub->add_option("--threads", threads, "Threads; 0 is one per core")->type_name("K")->check(whole_check(0, 4096));
}

/// Such a number as a double.
CLI::Validator number_check(double above, double below, const std::string& wanted) {
  return CLI::Validator(
      [=](std::string& text) {
        const NumberText number = read_number(text);
        const double value = number.value ? to_double(*number.value) : above;
        if (!(value > above && value < below)) return "`" + text + "` is not " + wanted;
        text = double_text(value);
        return std::string();
      },
      "");
}

/// What is wrong with an exact number that must be positive.
std::string distance_fault(const std::string& text) {
  const NumberText number = read_number(text);
  if (!number.value) return "`" + text + "`" + number.fault;
  return *number.value > 0 ? "" : "`" + text + "` is not a positive number";
}

constexpr const char* kFlagGiven = "true";  // what CLI11 makes of a flag without a value

/// `--features 0.01 TREE` as `--features=0.01 TREE`: a value that may be left out must not take the tree for it.
std::vector<std::string> command_line(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] != "--features" || !read_number(words[i + 1]).value) continue;
    words[i] += "=" + words[i + 1];
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  return words;
}

/// Options of pictures. Behind a `--node` they are for its panel alone, so their order matters: `picture_words`.
void add_picture_options(CLI::App* sub) {
  constexpr const char* kGroup = "Pictures (before the first --node for all panels, behind one for its own)";
  const auto add = [&](const char* name, const char* type, const char* help) {
    sub->add_option(std::string(name), CLI::callback_t([](const CLI::results_t&) { return true; }), help)
        ->type_name(type)
        ->expected(1)
        ->take_all()
        ->group(kGroup);
  };
  add("--camera", "A,E", "From where, in degrees: 0,0 looks along +y; around to the right, and up; such as 30,20");
  add("--cut", "PLANE", "Take away what is on the camera's side of x=5, or of NX,NY,NZ,D; several times for more");
  add("--explode", "F", "Pull regions apart, by F of their distance from the middle");
  add("--opacity", "F", "See through faces: from 1 (not at all) down to 0.01");
  sub->add_flag_function(
         "--ghosts", [](std::int64_t) {},
         "Show what the node's operator removed, faintly; not with --cut or --explode")
      ->take_all()
      ->group(kGroup);
  add("--color-by", color_choices().c_str(), "What gives a cell its color");
  add("--labels", "LIST", "Numbers of cells, and names: of v,e,f,r,names");
  add("--caption", "TEXT", "Below the panel; the node's name, if there are several");
  add("--size", "WxH",
      "No panel is larger, in pixels (without it one fills a page's width, or all of a row do); a .png has two "
      "for each");
}

/// The options of pictures and `--node` as they were given, in their order.
PictureWords picture_words(const CLI::App& sub) {
  PictureWords out;
  std::map<const CLI::Option*, std::size_t> seen;
  for (const CLI::Option* option : sub.parse_order()) {
    const std::string name = "--" + (option->get_lnames().empty() ? "" : option->get_lnames().front());
    const std::size_t i = seen[option]++;
    if (name != "--node" && option->get_group().rfind("Pictures", 0) != 0) continue;
    out.emplace_back(name, option->results()[i]);
  }
  return out;
}

/// For a word where a command should be: a tree was probably to be evaluated.
std::string forgotten_command(const std::string& word) {
  const std::string extension = extension_of(word);
  const bool is_tree = extension == ".yaml" || extension == ".yml" || extension == ".json";
  return is_tree ? "; to evaluate this tree: `cnrg eval " + word + "`;" : "";
}

/// `-q`: all short names are alike, so what is near to it says nothing.
bool is_letter(const std::string& name) { return name.size() == 2 && name[0] == '-' && name[1] != '-'; }
/// The long names that begin with the letter of a short one.
std::string options_of_letter(const std::string& letter, const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names)
    if (name.rfind("-" + letter, 0) == 0) out += (out.empty() ? "`" : " or `") + name + "`";
  return out.empty() ? out : "; did you mean " + out + "?";
}

/// What is wrong with the command line, what was probably meant, and where to look.
std::string command_line_fault(const CLI::App& program, const CLI::ParseError& e) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const CLI::App& asked = chosen.empty() ? program : *chosen.front();
  std::vector<std::string> names;
  if (chosen.empty())
    for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  for (const CLI::Option* option : asked.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  std::string hint, what = e.what();
  const std::vector<std::string> left = program.remaining(true);  // what no option took
  for (const std::string& word : left) {
    const std::string name = word.substr(0, word.find('='));
    hint = is_letter(name) ? options_of_letter(name, names) : did_you_mean(name, known);
    if (!hint.empty()) break;
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&e) != nullptr) {  // CLI11 tells them from the last to the first
    what = "not expected:";
    for (const std::string& word : left) what += " " + word;
  }
  if (chosen.empty() && !program.remaining().empty()) {
    const std::string word = program.remaining()[0];
    what = "there is no command `" + word + "`";
    if (const std::string tree = forgotten_command(word); !tree.empty()) hint = tree;
  }
  return what + (hint.empty() ? ";" : hint) + " see `cnrg " + (chosen.empty() ? "" : asked.get_name() + " ") +
         "--help`";
}

/// Prints the help of a command, or without a name that of the program.
int run_help(const CLI::App& program, const std::string& name) {
  if (!name.empty()) std::cout << program.get_subcommand(name)->help("cnrg");
  else std::cout << program.get_formatter()->make_help(&program, "cnrg", CLI::AppFormatMode::Normal);
  return kDone;
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> out;
  for (const CommandText& command : program_text(program).commands) out.push_back(command.name);
  return out;
}

constexpr const char* kSnap =
    "What is done without --no-snap: where rounding to doubles would break the result, move vertices until it "
    "does not, and say how far";
constexpr const char* kNoSnap = "Do not move vertices where rounding to doubles breaks the result: ";
constexpr const char* kOneGroup = "Of .msh: each element in the first of its groups alone; others are left out";
constexpr const char* kCertify =
    "Where it is not proven that curved surfaces meet as their facets do: ask with twenty times the steps, "
    "and make an error of what is left";
constexpr const char* kNoCertify = "Do not ask whether they do: facets stay as they are, right or wrong";
constexpr const char* kJoin =
    "Join what is nearer than D and does not touch: corners, edges and faces; say what met and how far it moved";

/// What is asked for, once a command line is read.
using Command = std::function<int()>;

/// A command with its arguments, which live as long as somebody may run it.
template <class Arguments>
void on_callback(CLI::App* sub, Command& command, int (*run)(const Arguments&),
                 const std::shared_ptr<Arguments>& arguments) {
  sub->callback([=, &command] { command = [=] { return run(*arguments); }; });
}

/// The name of a node or a file.
CLI::Option* add_name(CLI::App* sub, const char* option, std::string& name, const char* type, const char* help) {
  return sub->add_option(option, name, help)->type_name(type)->check(name_fault);
}
/// Several of them, each behind the option.
CLI::Option* add_all_names(CLI::App* sub, const char* option, std::vector<std::string>& names, const char* type,
                           const char* help) {
  return sub->add_option(option, names, help)->type_name(type)->check(name_fault)->expected(1)->take_all();
}

/// Two flags of which only one can be given.
CLI::Option* add_either(CLI::App* sub, const char* flag, bool& yes, const char* help, const char* no_flag,
                        bool& no, const std::string& no_help) {
  CLI::Option* const option = sub->add_flag(flag, yes, help);
  sub->add_flag(no_flag, no, no_help)->excludes(option);
  return option;
}

void add_eval(CLI::App& program, Command& command) {
  const auto given = std::make_shared<EvalArguments>();
  CLI::App* const sub = program.add_subcommand("eval", "Evaluates a tree: one row per node, files of the result");
  add_tree(sub, *given);
  add_all_names(sub, "--node", given->nodes, "N",
                "Evaluate this node too; files show it instead of the result: one node for all, or one for each "
                "-o");
  add_all_names(
      sub, "-o,--output", given->files, "FILE",
      "Write this file, in the format of its extension: .json .vtu .msh .msh2 .mesh .smesh .poly .inp .bdf "
      ".h5m .med .obj .off .stl .ply .3mf .glb .step .brep .dot .regions.dot; pictures: .svg .png "
      ".pdf; of a .csg the tree: .yaml");
  sub->add_flag("--trace", given->trace, "Under each row: what each table row removed, volumes of regions");
  sub->add_flag("--raw", given->raw, "Keep the unsimplified cells of the refinement");
  sub->add_option_function<std::string>(
         "--refine",
         [given](const std::string& word) {
           given->refining = word == "apart" ? Refining::apart : Refining::together;
         },
         "Refine all leaves `together`, or every node that may be `apart`; without it, apart what dies before it "
         "meets others")
      ->type_name("WAY")
      ->check(CLI::IsMember({"together", "apart"}));
  sub->add_flag("--topology", given->topology,
                "For the result, or each --node: Euler-Poincare, Betti numbers, manifoldness, which regions "
                "touch");
  sub->add_flag("--list", given->list,
                "For the result, or each --node: what the operator `select` can pick, with numbers of cells");
  sub->add_option(
         "--select", given->select,
         "Files, --topology and --list show what this picks of the result, or of each --node: criteria of "
         "the operator `select`, such as '{dimension: 2, between: [rock, clay]}'")
      ->type_name("CRITERIA")
      ->check([](const std::string& text) {
        return text.empty() ? std::string("it is empty; give criteria, such as '{dimension: 2}'") : std::string();
      });
  CLI::Option* const snap = add_either(sub, "--snap", given->snap, kSnap, "--no-snap", given->no_snap,
                                       std::string(kNoSnap) + "write the file, and warn");
  sub->add_flag("--binary", given->binary, "Of .stl (numbers of 24 bits) and .ply (doubles): the binary form");
  sub->add_flag("--one-group", given->one_group, kOneGroup);
  add_either(sub, "--certify", given->certify, kCertify, "--no-certify", given->no_certify, kNoCertify);
  sub->add_flag("--parameters", given->parameters,
                "In .json and .vtu: the parameters u, v of faces on curved patches")
      ->excludes(snap);
  sub->add_option("--join", given->join, kJoin)->type_name("D")->check(distance_fault);
  add_threads(sub, given->threads);
  sub->add_flag("-q,--quiet", given->quiet, "No notices, and no rows but those of --json");
  CLI::Option* const json = sub->add_flag("--json", given->json, "The rows as JSON instead, volumes as fractions");
  for (const char* const other : {"--trace", "--topology", "--list"}) json->excludes(sub->get_option(other));
  add_picture_options(sub);
  sub->footer(
      "Examples:\n  cnrg eval model.yaml --node split -o split.vtu --trace\n"
      "  cnrg eval model.yaml --node split --node model --cut y=50 -o model.svg");
  sub->callback([=, &command] {
    given->picture = picture_words(*sub);
    command = [=] { return run_eval(*given); };
  });
}

void add_check(CLI::App& program, Command& command) {
  const auto given = std::make_shared<CheckArguments>();
  CLI::App* const sub = program.add_subcommand(
      "check", "Reads and validates a tree file without evaluating it; with --features, lists what is small");
  add_tree(sub, *given);
  sub->add_flag(
         "--features", given->features,
         "List the smallest distances between what does not touch, lengths of edges and angles, with places "
         "and nodes; with `--features D`, all distances and lengths below D")
      ->check([](const std::string& text) { return text == kFlagGiven ? std::string() : distance_fault(text); });
  add_name(sub, "--node", given->node, "N", "Of --features: this node; the result without it");
  add_threads(sub, given->threads);
  sub->footer("Example:\n  cnrg check model.yaml\n  cnrg check --features 0.001 model.yaml");
  on_callback(sub, command, run_check, given);
}

void add_locate(CLI::App& program, Command& command) {
  const auto given = std::make_shared<LocateArguments>();
  CLI::App* const sub =
      program.add_subcommand("locate", "Reads points `x y z` and prints `dim cell component name` for each");
  add_tree(sub, *given, "Tree (YAML or JSON, or .csg), exact result, mesh or CAD model");
  add_name(sub, "--node", given->node, "N", "Node to look into; the result without it");
  add_threads(sub, given->threads);
  sub->add_flag("--parameters", given->parameters,
                "Also the place on patches and curves of leaves: `leaf: patch: u v`, `leaf: curve: t`, each "
                "behind a tabulator");
  sub->add_flag("--material", given->material,
                "Also what a graded material is there: `material: steel 3/4, ceramic 1/4`, behind a tabulator");
  sub->footer("Example:\n  echo \"1/3 0.5 2\" | cnrg locate model.yaml --node split");
  on_callback(sub, command, run_locate, given);
}

void add_explain(CLI::App& program, Command& command) {
  const auto given = std::make_shared<ExplainArguments>();
  CLI::App* const sub =
      program.add_subcommand("explain", "Tells of one cell, at every node, what kept or removed it, and why");
  add_tree(sub, *given);
  add_name(sub, "--node", given->node, "N", "Node to look into; the result without it");
  sub->add_option("--cell", given->cell, "Cell of the node, as `cnrg locate` names it: v3, e0, f12, r1")
      ->type_name("NAME");
  sub->add_option("--point", given->point, "Instead of a cell: what holds this point, active or not")
      ->type_name("X,Y,Z");
  add_threads(sub, given->threads);
  sub->footer(
      "Example:\n  cnrg explain model.yaml --node split --cell f12\n  cnrg explain model.yaml --point 1/3,0.5,2");
  on_callback(sub, command, run_explain, given);
}

void add_view(CLI::App& program, Command& command) {
  const auto given = std::make_shared<ViewArguments>();
  CLI::App* const sub =
      program.add_subcommand("view", "Writes a page for a browser: the tree beside the cells of each node");
  add_tree(sub, *given);
  add_name(sub, "-o,--output", given->file, "FILE.html",
           "Write this file; without it the tree's name with .html, in the current folder");
  add_all_names(sub, "--node", given->nodes, "N", "Show this node and what is below it; without it all nodes");
  sub->add_flag("--certify", given->certify, kCertify);
  sub->add_flag("--open", given->open, "Open the page in the browser");
  sub->add_flag("--watch", given->watch, "Write the page again whenever the tree changes; open pages follow");
  add_threads(sub, given->threads);
  sub->add_flag("-q,--quiet", given->quiet, "No line about the page and no notices");
  sub->footer("Example:\n  cnrg view model.yaml -o model.html --open");
  on_callback(sub, command, run_view, given);
}

/// A number between two bounds, as trees have them; it becomes a double.
CLI::Option* add_number(CLI::App* sub, const char* option, double& number, const char* type, double above,
                        double below, const char* wanted, const char* help) {
  return sub->add_option(option, number, help)->type_name(type)->transform(number_check(above, below, wanted));
}

void add_bounds(CLI::App* sub, TetrahedraOptions& options) {
  constexpr const char* kPositive = "a positive number";
  add_number(sub, "--size", options.size, "H", 0, HUGE_VAL, kPositive,
             "Edges are about as long as H, or shorter where the model asks for it");
  add_number(sub, "--growth", options.growth, "G", 0.0499999, 2.0000001, "a number from 0.05 to 2",
             "How much longer edges may be per unit of distance from where they are to be short, from 0.05 to 2")
      ->capture_default_str();
  add_number(sub, "--max-volume", options.max_volume, "V", 0, HUGE_VAL, kPositive,
             "No tetrahedron is larger than V cubic units");
  add_number(sub, "--quality", options.quality, "Q", 1.0999, 100.0001, "a number from 1.1 to 100",
             "Largest ratio of circumradius to shortest edge, from 1.1: 2 is usual, below 1.4 may take very long; "
             "thin regions take as many tetrahedra as that needs, if the forecast is no more than 20 seconds or a "
             "third of --seconds; else, and without it, they are as flat as they are");
  sub->add_option(
         "--seconds", options.seconds,
         "For all of the meshing, by the clock: a mesh that is there then is kept as it is, and said to be so; 0: "
         "no bound. Without it steps are counted, and the mesh is the same on every machine")
      ->type_name("S")
      ->check(whole_check(0, 1'000'000));
}

void add_mesh(CLI::App& program, Command& command) {
  const auto given = std::make_shared<MeshArguments>();
  CLI::App* const sub = program.add_subcommand(
      "mesh",
      "Fills the regions with tetrahedra that conform to every face, wire and point; with --surface meshes faces "
      "and wires alone. Nothing has to be asked for: shapes are as good as some thousand points more make them");
  add_tree(sub, *given);
  add_name(sub, "--node", given->node, "N", "Node to mesh; the result without it");
  add_all_names(
      sub, "-o,--output", given->files, "FILE",
      "Write this file, in the format of its extension: .msh .msh2 .mesh .vtu .inp .bdf .h5m .f3grid .med .xdmf; "
      ".html is a report with pictures")
      ->required();
  add_bounds(sub, given->options);
  sub->add_flag(
      "-Y,--keep-boundary", given->options.keep_boundary,
      "No new points on faces and edges, so that the meshes of neighbours fit; inside only is there room for "
      "--size, --max-volume and --quality, and what they miss is said");
  sub->add_flag(
      "--constrained", given->options.constrained,
      "Not by TetGen: exact constrained tetrahedra, improved; without it these are made only where TetGen "
      "fails");
  add_either(sub, "--certify", given->certify, kCertify, "--no-certify", given->no_certify, kNoCertify);
  sub->add_option("--join", given->join, kJoin)->type_name("D")->check(distance_fault);
  sub->add_option("--chord", given->chord,
                  "Facets of curved faces become fewer, as large as sizes allow, within D of those that were")
      ->type_name("D")
      ->check(distance_fault);
  sub->add_flag("--curved", given->options.curved,
                "Move points to the true surfaces and bend tetrahedra after them: second order, 10 nodes");
  CLI::Option* const surface =
      sub->add_flag("--surface", given->surface,
                    "Triangles on all faces and segments on edges and wires, without volumes: no angle below 25 "
                    "degrees but where the result has smaller ones or is very narrow");
  sub->add_option("--max-points", given->max_points,
                  "Of --surface: no points are added beyond N; parts that are very narrow get a fiftieth of them")
      ->type_name("N")
      ->check(whole_check(1, 1'000'000'000))
      ->capture_default_str()
      ->needs(surface);
  sub->add_flag("--surface-first", given->options.surface_first,
                "Begin with the triangles that --surface makes, and keep them as the boundary of the tetrahedra: "
                "faces are as good as there; where TetGen fails it only fills them, and where it cannot, it is an "
                "error");
  sub->add_option(
         "--order", given->options.order,
         "Of the elements: 1, or 2 with a node in the middle of each straight edge; --curved is of order 2")
      ->type_name("N")
      ->check(CLI::IsMember({1, 2}));
  sub->add_option_function<std::vector<std::string>>(
         "--periodic",
         [given](const std::vector<std::string>& axes) {
           for (const std::string& axis : axes) given->options.periodic[std::size_t(axis[0] - 'x')] = true;
         },
         "Opposite sides along these axes, as `x,y`, get the same triangles, as of --surface-first; pairs of "
         "nodes are in .msh, .msh2, .inp and .vtu")
      ->type_name("AXES")
      ->delimiter(',')
      ->check(CLI::IsMember({"x", "y", "z"}));
  sub->add_flag("--quads", given->quads,
                "Of --surface: merge triangles of a face by pairs into quadrilaterals with angles from 30 to 150 "
                "degrees, as many as can be")
      ->needs(surface);
  sub->add_flag("--one-group", given->one_group, kOneGroup);
  CLI::Option* const split = add_all_names(
      sub, "--split", given->options.split, "NAME",
      "More than once: give both sides of the faces of a group nodes of their own, in groups `back of "
      "NAME` and `front of NAME`, so that a fault can open and slip");
  sub->add_flag("--interfaces", given->options.interfaces,
                "Of --split: wedges without thickness between the sides, in groups `interface NAME`")
      ->needs(split);
  add_either(sub, "--snap", given->snap, kSnap, "--no-snap", given->no_snap, std::string(kNoSnap) + "refuse it");
  for (const auto& [one, others] : std::initializer_list<std::pair<const char*, std::vector<const char*>>>{
           {"--curved",
            {"--join", "--chord", "--surface", "--surface-first", "--periodic", "--interfaces", "--snap"}},
           {"--surface",
            {"--max-volume", "--quality", "--keep-boundary", "--constrained", "--surface-first", "--split"}},
           {"--surface-first", {"--keep-boundary", "--constrained"}},
           {"--periodic", {"--keep-boundary", "--constrained", "--quads", "--split"}},
           {"--order", {"--quads", "--interfaces"}}}) {
    for (const char* const other : others) sub->get_option(one)->excludes(sub->get_option(other));
  }
  add_threads(sub, given->threads);
  sub->add_flag("-q,--quiet", given->quiet, "No table and no notices");
  sub->footer("Example:\n  cnrg mesh model.yaml -o model.msh --quality 1.4");
  on_callback(sub, command, run_mesh, given);
}

void add_compare(CLI::App& program, Command& command) {
  const auto given = std::make_shared<CompareArguments>();
  CLI::App* const sub =
      program.add_subcommand("compare", "Says whether two trees mean the same, and if not, what differs");
  sub->add_option("A", given->a, "Tree, exact result (.json), mesh or CAD model; `-` for a tree on standard input")
      ->required()
      ->check(name_fault);
  sub->add_option("B", given->b, "Another one")->required()->check(name_fault);
  add_name(sub, "--node-a", given->node_a, "N", "Node of A; its result without it");
  add_name(sub, "--node-b", given->node_b, "N", "Node of B; its result without it");
  sub->add_option("--ignore", given->ignored,
                  "More than once: `names`, `materials` or `attributes` (keys with values) of components, sheets, "
                  "wires and "
                  "points; `features`, that is lines and points that "
                  "parts of one surface or line have by themselves; `components`, that is all but the point sets")
      ->type_name("WHAT")
      ->check(CLI::IsMember({"names", "materials", "attributes", "features", "components"}))
      ->expected(1)
      ->take_all();
  add_fineness(sub, *given);
  add_threads(sub, given->threads);
  sub->add_flag("-q,--quiet", given->quiet, "Only the exit status");
  sub->footer(
      "Example:\n  cnrg compare answer.yaml solution.yaml\n\nExit status: 0 the same, 4 different, else as of all "
      "commands.");
  on_callback(sub, command, run_compare, given);
}

/// Of the commands that print what the program knows of itself.
struct TextArguments {
  bool tables = false;
  std::string shell = "bash", helped;
};

void add_texts(CLI::App& program, Command& command) {
  const auto given = std::make_shared<TextArguments>();
  const auto add = [&](const char* name, const char* help, const char* footer, const Command& run) {
    CLI::App* const sub = program.add_subcommand(name, help);
    sub->footer(footer);
    sub->callback([=, &command] { command = run; });
    return sub;
  };
  add("tables", "Prints the tables of the Booleans in Markdown", "Example:\n  cnrg tables > tables.md",
      run_tables);
  add("schema", "Prints the JSON schema of a tree file, for editors", "Example:\n  cnrg schema > tree.schema.json",
      [=] { return run_schema(given->tables); })
      ->add_flag("--tables", given->tables, "The keys of a tree file in Markdown instead");
  add("manual", "Prints the manual page of cnrg, for `man`", "Example:\n  cnrg manual > cnrg.1\n  man -l cnrg.1",
      [&] { return run_manual(program_text(program)); });
  add("completion", "Prints what a shell needs to complete commands, options, files and nodes",
      "Example:\n  source <(cnrg completion)\n  cnrg completion fish | source",
      [=] { return run_completion(given->shell); })
      ->add_option("SHELL", given->shell, "Which")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->capture_default_str();
  CLI::App* const help =
      add("help", "Prints the help of a command, or of the program", "Example:\n  cnrg help mesh",
          [=, &program] { return run_help(program, given->helped); });
  help->add_option("COMMAND", given->helped, "Which")->check(CLI::IsMember(command_names(program)));
}

constexpr void (*kCommands[])(CLI::App&, Command&) = {add_eval, add_check, add_locate,  add_explain,
                                                      add_view, add_mesh,  add_compare, add_texts};

int run(int argc, char** argv) {
  CLI::App program{"Exact Booleans of non-manifold solids, surfaces, wires and points, by tree files.", "cnrg"};
  program.set_version_flag(
      "--version", [] { return version_text("cnrg", kPlugins); }, "Versions of cnrg and of the libraries in it");
  program.require_subcommand(1);
  program.formatter_fn([](const CLI::App* app, std::string name, CLI::AppFormatMode mode) {
    return wrapped_help(CLI::Formatter().make_help(app, std::move(name), mode));
  });
  program.footer(
      "Example:\n  cnrg eval model.yaml -o model.vtu\n\nExit status: 0 done, 2 bad input, 3 a file could not be "
      "read or written or memory ran out, 4 of `cnrg compare`: different, 1 a bug.");
  Command command;
  for (const auto add : kCommands) add(program, command);
  if (argc > 1 && argv[1] == std::string("__complete"))
    return run_complete(program_text(program), {argv + 2, argv + argc});
  try {
    program.parse(command_line(argc, argv));
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return program.exit(e);
    throw InputError("cnrg: error: " + command_line_fault(program, e));
  }
  return command();
}

}  // namespace
}  // namespace cnrg::app

int main(int argc, char** argv) {
  return cnrg::app::run_program("cnrg", [&] { return cnrg::app::run(argc, argv); });
}
