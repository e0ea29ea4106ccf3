#include "csg/app/panels.h"

#include "csg/app/evaluation.h"
#include "csg/explain/fates.h"
#include "csg/text/file.h"
#include "kernel/base/error.h"

namespace cnrg::app {
namespace {

/// Reads an option; faults of the command line begin so.
template <class Read>
void read_option(Read read) {
  try {
    read(OptionNames(true));
  } catch (const InputError& e) {
    throw InputError(std::string("cnrg: error: ") + e.what());
  }
}

}  // namespace

PictureRequest picture_request(const PictureWords& words) {
  PictureRequest out;
  PanelRequest common;
  bool first_cut = true;
  for (const auto& word : words) {  // not as [option, value], which clang 14 does not let lambdas capture
    const std::string& option = word.first;
    const std::string& value = word.second;
    if (option == "--node") {
      out.panels.push_back(common);
      out.panels.back().node = value;
      first_cut = true;
      continue;
    }
    out.given = true;
    if (option == "--size") {
      read_option([&](const OptionNames& names) { out.size = picture_size(value, names); });
      continue;
    }
    PanelRequest& panel = out.panels.empty() ? common : out.panels.back();
    if (option == "--cut") {  // those of a panel replace those of all panels
      if (first_cut) panel.draw.cuts.clear();
      first_cut = false;
    }
    read_option([&](const OptionNames& names) { set_option(panel, option.substr(2), value, names); });
  }
  if (out.panels.empty()) out.panels.push_back(common);
  for (const PanelRequest& panel : out.panels) {
    read_option([&](const OptionNames& names) { check_options(panel, names); });
  }
  return out;
}

void write_picture(const std::string& path, const std::vector<PanelRequest>& panels,
                   const std::optional<PictureSize>& size, const Tree& tree, const Evaluation& evaluation,
                   int threads) {
  std::vector<NodeId> nodes;
  std::vector<Result> results;
  for (const PanelRequest& panel : panels) {
    nodes.push_back(node_of(tree, panel.node));
    results.push_back(evaluation.result(nodes.back()));
  }
  const DrawOptions::Camera camera = camera_for(results);
  std::vector<std::string> leaf_names;
  for (const Result& result : results) add_names(*result.data().view().leaves, leaf_names);
  std::vector<Panel> drawn;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    DrawOptions options = panels[i].draw;
    if (!options.camera) options.camera = camera;
    options.leaf_names = leaf_names;
    std::optional<Result> removed;
    if (panels[i].ghosts) {
      removed.emplace(evaluation.complex, removed_entities(tree, evaluation, evaluation.value(nodes[i])));
    }
    Figure figure =
        at_node(tree, nodes[i], [&] { return draw(results[i], options, removed ? &*removed : nullptr, threads); });
    const std::string caption = panels[i].has_caption ? panels[i].caption
                                : panels.size() > 1   ? results[i].name()
                                                      : "";
    drawn.push_back({std::move(figure), caption});
  }
  replace_file(path, picture_bytes(path, drawn, size));
}

}  // namespace cnrg::app
