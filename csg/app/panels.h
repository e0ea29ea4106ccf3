// What the command line says of pictures: their panels, and how each is drawn.
//
// An option behind a `--node` is for that node's panel, one before the first `--node` for all panels. So options
// of pictures come here as words in the order in which they were given.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/picture/options.h"
#include "csg/tree/tree.h"

namespace cnrg::app {

/// An option and its value; `--node` among them.
using PictureWords = std::vector<std::pair<std::string, std::string>>;

struct PanelRequest : PanelOptions {
  std::string node;  ///< empty: the result
};
struct PictureRequest {
  std::vector<PanelRequest> panels;  ///< at least one
  std::optional<PictureSize> size;
  bool given = false;  ///< an option of pictures was
};

/// Throws InputError for a value that is not what its option takes.
PictureRequest picture_request(const PictureWords& words);

/// Draws these panels and writes the picture.
void write_picture(const std::string& path, const std::vector<PanelRequest>& panels,
                   const std::optional<PictureSize>& size, const Tree& tree, const Evaluation& evaluation,
                   int threads);

}  // namespace cnrg::app
