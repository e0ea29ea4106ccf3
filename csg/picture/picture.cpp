#include "csg/picture/picture.h"

#include "csg/explain/fates.h"
#include "csg/picture/options.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

struct Request {
  PanelOptions panel;
  std::optional<PictureSize> size;
};

Request request(const PictureOptions& options) {
  const OptionNames names(false);
  Request out;
  for (const auto& [option, value] : options) {
    if (option == "size") out.size = picture_size(value, names);
    else set_option(out.panel, option, value, names);
  }
  check_options(out.panel, names);
  return out;
}

std::string drawn(const std::string& extension, const Result& result, Request request, const Result* removed,
                  int threads) {
  if (!is_picture("picture" + extension)) {
    throw InputError("`" + extension + "` is no format of pictures; use one of .svg .png .pdf");
  }
  PanelOptions& panel = request.panel;
  if (!panel.draw.camera) panel.draw.camera = camera_for({result});
  return picture_bytes("picture" + extension, {{draw(result, panel.draw, removed, threads), panel.caption}},
                       request.size);
}

}  // namespace

bool check_picture_options(const PictureOptions& options) { return request(options).panel.ghosts; }

std::string picture(const std::string& extension, const Result& result, const PictureOptions& options,
                    int threads) {
  Request asked = request(options);
  if (asked.panel.ghosts) {
    throw InputError(
        "ghosts show what the node of a tree removed, and this result comes from no tree; leave them out");
  }
  return drawn(extension, result, std::move(asked), nullptr, threads);
}

std::string picture(const std::string& extension, const Tree& tree, const Evaluation& evaluation, NodeId node,
                    const PictureOptions& options, int threads) {
  Request asked = request(options);
  const Result result = evaluation.result(node);
  if (!asked.panel.ghosts) return drawn(extension, result, std::move(asked), nullptr, threads);
  const Result removed(evaluation.complex, removed_entities(tree, evaluation, evaluation.value(node)));
  return drawn(extension, result, std::move(asked), &removed, threads);
}

}  // namespace cnrg
