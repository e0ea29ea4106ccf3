// A still of one result: what `cnrg eval -o model.svg` draws (csg/FORMATS.md#pictures), as bytes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/result/result.h"
#include "csg/tree/tree.h"

namespace cnrg {

/// Options and values as on the command line, without dashes: {"cut", "x=5"}, {"ghosts", ""}, {"color-by",
/// "region"}.
using PictureOptions = std::vector<std::pair<std::string, std::string>>;

/// Throws InputError for what is no option or no value of it, whose name has `_` for `-` there: to be asked before
/// long work. True if the options ask for ghosts.
bool check_picture_options(const PictureOptions& options);

/// `extension` is .svg, .png or .pdf. Throws InputError for options, and for what cannot be drawn so; ghosts need
/// the tree.
std::string picture(const std::string& extension, const Result& result, const PictureOptions& options = {},
                    int threads = 0);
/// Of a node that was asked for. For ghosts the evaluation must have kept all values.
std::string picture(const std::string& extension, const Tree& tree, const Evaluation& evaluation, NodeId node,
                    const PictureOptions& options = {}, int threads = 0);

}  // namespace cnrg
