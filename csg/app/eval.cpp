// `cnrg eval`.
#include <algorithm>
#include <iostream>
#include <map>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/app/joined.h"
#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/app/row_table.h"
#include "csg/certify/certificate.h"
#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/formats/writer.h"
#include "csg/operators/node_value.h"
#include "csg/result/result_data.h"
#include "csg/text/escape.h"
#include "csg/text/file.h"
#include "csg/text/plugin.h"
#include "csg/text/table.h"
#include "csg/topology/features.h"
#include "csg/topology/selectables.h"
#include "csg/topology/topology.h"
#include "csg/tree/selector.h"

namespace cnrg::app {
namespace {

/// A file, and what it shows: a node; or of a picture some of its panels.
struct FileRequest {
  std::string path;
  NodeId node;
  std::vector<PanelRequest> panels;
};

/// Files show the result; or the one `--node`; or one `--node` each. Of more nodes than that a picture has panels.
std::vector<FileRequest> requests(const Tree& tree, const EvalArguments& arguments,
                                  const std::vector<NodeId>& nodes, const PictureRequest& picture) {
  const std::vector<std::string>& files = arguments.files;
  const auto pictures = static_cast<std::size_t>(std::count_if(files.begin(), files.end(), is_picture));
  const bool one_each = nodes.size() > 1 && nodes.size() == files.size();
  if (nodes.size() > 1 && !one_each && files.size() > pictures) {
    throw InputError(
        "cnrg: error: " + std::to_string(nodes.size()) + " times --node and " + std::to_string(files.size()) +
        " times -o; give no --node (the files show the result), one for all files, or one for each file");
  }
  std::vector<FileRequest> out;
  for (std::size_t i = 0; i < files.size(); ++i) {
    FileRequest& file = out.emplace_back();
    file.path = files[i];
    file.node = nodes.empty() ? tree.result : nodes[one_each ? i : 0];
    if (!is_picture(files[i])) continue;
    if (one_each) file.panels = {picture.panels[i]};
    else file.panels = picture.panels;
  }
  return out;
}

/// The tree itself, of which nothing is evaluated.
bool is_tree(const std::string& path) { return extension_of(path) == ".yaml"; }

void check_trees(const EvalArguments& arguments, const Tree& tree) {
  for (const std::string& path : arguments.files) {
    if (!is_tree(path)) continue;
    if (tree.yaml.empty())
      throw InputError("-o " + path + " writes the tree of a .csg file, and " + tree.file +
                       " is a tree already; copy it");
    if (!arguments.nodes.empty() || !arguments.select.empty())
      throw InputError("-o " + path + " writes the whole tree; leave out --node and --select");
  }
}

/// The result of each node, joined once where that is asked for.
class Results {
 public:
  Results(const Tree& tree, const Evaluation& evaluation, const EvalArguments& arguments)
      : tree_(tree), evaluation_(evaluation), arguments_(arguments) {}
  const Result& operator()(NodeId node) {
    const auto known = known_.find(node);
    if (known != known_.end()) return known->second;
    Result result = evaluation_.result(node);
    if (!arguments_.join.empty()) result = joined(tree_, node, result, arguments_.join, arguments_.quiet);
    return known_.emplace(node, std::move(result)).first->second;
  }

 private:
  const Tree& tree_;
  const Evaluation& evaluation_;
  const EvalArguments& arguments_;
  std::map<NodeId, Result> known_;
};

/// Writes files, and snaps each node that needs it once. What is to be said of them is kept until the rows are
/// printed, whose last one has the time that this took.
class FileWriter {
 public:
  FileWriter(const Tree& tree, const Evaluation& evaluation, const EvalArguments& arguments, Results& results)
      : tree_(tree), evaluation_(evaluation), arguments_(arguments), results_(results) {}

  void write_file(const FileRequest& file, const std::optional<PictureSize>& size) {
    const std::string& path = file.path;
    const NodeId node = file.node;
    if (is_tree(path)) return replace_file(path, tree_.yaml);
    if (!file.panels.empty()) {
      ProgressBar bar(arguments_.quiet);
      bar.show("draw " + path);
      return write_picture(path, file.panels, size, tree_, evaluation_, arguments_.threads);
    }
    if (is_cad_file(path)) {
      if (const std::string doubt = certificate_of(evaluation_, node).doubt(tree_); !doubt.empty())
        say(path + ": warning: " + doubt);
    }
    FileReport report;
    {
      ProgressBar bar(arguments_.quiet);
      bar.show("write " + path);
      if (shows_dag(path)) {
        write(path, evaluation_);
      } else {
        const FileOptions options{arguments_.parameters, !arguments_.no_snap, arguments_.binary,
                                  arguments_.one_group, &snapped_[node]};
        report = at_node(tree_, node, [&] { return write(path, results_(node), options); });
      }
    }
    if (!arguments_.quiet) {
      for (const std::string& notice : report.notices) say(path + ": notice: " + notice);
    }
    if (!report.embedded) {
      say(path + ": warning: rounding moved " + counted(report.moved, "vertex", "vertices") +
          " and broke the result in this file; leave out " + (arguments_.no_snap ? "--no-snap" : "--parameters") +
          ", or write .json for the exact result");
    } else if (!arguments_.quiet && report.moved > 0) {
      say(path + ": notice: rounding moved " + counted(report.moved, "vertex", "vertices") +
          "; the facets still meet as they should");
    } else if (!arguments_.quiet && report.snapped.rounds > 0) {
      say(path + ": notice: " + report.snapped.text());
    } else if (!arguments_.quiet && arguments_.snap && is_exact(path)) {
      say(path + ": notice: this format is exact; --snap changes nothing in it");
    }
    for (const std::string& warning : report.snapped.warnings()) say(path + ": warning: " + warning);
  }

  /// Notices and warnings of the files that were written.
  void tell_all() const {
    for (const std::string& message : messages_) tell(message);
  }

 private:
  const Tree& tree_;
  const Evaluation& evaluation_;
  const EvalArguments& arguments_;
  Results& results_;
  std::map<NodeId, SnappedResultOnce> snapped_;
  std::vector<std::string> messages_;

  void say(std::string message) { messages_.push_back(std::move(message)); }
};

/// Of each node asked for, or of the result when there are none: a head, and what `tell` says.
template <class Tell>
std::string told_of(const Tree& tree, std::vector<NodeId> nodes, const std::string& head, Tell tell) {
  if (nodes.empty()) nodes = {tree.result};
  std::string text;
  for (const NodeId node : nodes) {
    append_line(text += "\n", head + tree.nodes[node].name);
    text += tell(node);
  }
  return text;
}

std::string topology_of(const Result& result) {
  return topology_text(result.complex(), result.selection(), result.cells(), result.data().value->attributes());
}

/// What of each node asked for, or of the result, is so near that it was probably meant to touch, and which names
/// it has no more.
void tell_near_and_lost(const Tree& tree, const Evaluation& evaluation, std::vector<NodeId> nodes) {
  if (nodes.empty()) nodes = {tree.result};
  for (const NodeId id : nodes) {
    ProgressBar bar(false);
    bar.show("near features");
    const std::vector<Diagnostic> all = near_and_lost(tree, evaluation, id, {bar.progress(), {}});
    bar.clear();
    print(all, false);
  }
}

/// What is shown becomes what `criteria` pick of it.
void select_in(Tree& tree, const std::string& criteria, std::vector<NodeId>& nodes, PictureRequest& picture) {
  const auto picked = [&](NodeId node) { return add_selection(tree, node, criteria, "--select"); };
  std::map<NodeId, NodeId> known;
  for (NodeId& node : nodes) {
    const auto [it, is_new] = known.try_emplace(node);
    if (is_new) it->second = picked(node);
    node = it->second;
  }
  for (PanelRequest& panel : picture.panels) {
    if (!panel.node.empty()) panel.node += "/select";
  }
  if (nodes.empty()) tree.result = picked(tree.result);
}

}  // namespace

int run_eval(const EvalArguments& arguments) {
  StageClock clock("leaves");
  require_distinct(arguments.files);
  bool pictures = false;
  for (const std::string& path : arguments.files) {  // before the work, not after it
    if (is_tree(path)) {
      require_no_directory(path);
    } else if (is_picture(path)) {
      pictures = true;
      require_no_directory(path);
      require_plugin(kPaperPlugin, path, "write .vtu or .json");
    } else {
      check_file_name(path, " .svg .png .pdf .yaml");
    }
    if (arguments.binary) check_binary(path);
    if (arguments.one_group) check_one_group_file_name(path);
  }
  PictureRequest picture = picture_request(arguments.picture);
  if (picture.given && !pictures) {
    throw InputError(
        "cnrg: error: options of pictures are given, and no picture; add `-o FILE.svg`, .png or .pdf");
  }
  if (!arguments.join.empty() && pictures) {
    throw InputError("cnrg: error: pictures show nodes as they are; leave out --join or the picture");
  }
  Tree tree = tree_of(arguments);
  require_writable(arguments.files, tree);
  check_trees(arguments, tree);
  EvaluateOptions options;
  options.threads = arguments.threads;
  options.raw = arguments.raw;
  options.refining = arguments.refining;
  const bool in_files = std::any_of(arguments.files.begin(), arguments.files.end(), shows_dag);
  options.proof = asked_proof(arguments.certify, arguments.no_certify);
  const bool prints_rows = !arguments.quiet || arguments.json;
  options.rows = prints_rows || in_files ? Rows::all : Rows::none;
  options.region_volumes = arguments.trace;
  for (const std::string& name : arguments.nodes) options.nodes.push_back(node_of(tree, name));
  std::vector<NodeId> roots = options.nodes;
  roots.push_back(tree.result);
  print(reading_warnings(tree, roots), arguments.quiet);
  if (!arguments.select.empty()) select_in(tree, arguments.select, options.nodes, picture);
  const std::vector<FileRequest> files = requests(tree, arguments, options.nodes, picture);
  options.keep_all =
      std::any_of(picture.panels.begin(), picture.panels.end(), [](const auto& p) { return p.ghosts; });

  // Kept to the end, when the system takes all memory back at once: to free it cell by cell takes long.
  static const Evaluation& evaluation = *new Evaluation(evaluate_in_view(tree, options, arguments.quiet, &clock));
  const bool crosses = arguments.certify ? require_certain(tree, evaluation, arguments.quiet)
                                         : tell_uncertain(tree, evaluation, arguments.quiet);
  clock.begin("results");
  if (prints_rows) {
    for (const NodeRow* const row : evaluation.all_rows()) row->volume_bound();  // kept for the table
  }
  Results results(tree, evaluation, arguments);
  if (!arguments.join.empty()) {  // what it has to say is said whether a file is written or not
    if (options.nodes.empty()) results(tree.result);
    for (const NodeId node : options.nodes) results(node);
  }
  if (!arguments.quiet && arguments.join.empty()) tell_near_and_lost(tree, evaluation, options.nodes);
  std::string told;
  if (arguments.topology) {
    ProgressBar bar(arguments.quiet);
    bar.show("topology");
    told = told_of(tree, options.nodes, "topology of ", [&](NodeId node) { return topology_of(results(node)); });
  }
  if (arguments.list) {
    told += told_of(tree, options.nodes, "what `select` can pick of ",
                    [&](NodeId node) { return selectables_text(selectables(results(node))); });
  }
  FileWriter writer(tree, evaluation, arguments, results);
  const auto print_all = [&](bool whole) {
    const StageRows stages = stage_rows(clock, evaluation, crosses, whole);
    if (arguments.json) std::cout << rows_json(evaluation, stages, arguments.raw);
    else if (!arguments.quiet) std::cout << row_table(evaluation, stages, arguments.raw, arguments.trace);
    if (!arguments.quiet && arguments.trace) std::cout << refinement_summary(evaluation);
    std::cout << told << std::flush;
    writer.tell_all();
  };
  try {
    write_each(files, [&](const FileRequest& file) { writer.write_file(file, picture.size); });
  } catch (...) {  // the rows are right all the same
    print_all(false);
    throw;
  }
  print_all(true);
  return kDone;
}

}  // namespace cnrg::app
