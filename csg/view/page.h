// One page that shows an evaluated tree: opened from a file, it needs no server, no network and no program.
//
// The page is made of two things that know nothing of each other. The *template* is HTML with styles and script,
// bundled when the program is built (csg/view/web); it holds one empty element for data. The *data* is JSON,
// compressed, that says what each node is made of, in the numbers that files have: what the page shows of a cell
// is what `cnrg explain`, `cnrg eval --topology` and an exact .json say of it. To let the page compute any of that
// would be a second truth, in doubles. Points that are drawn are rounded; what is read is exact.
#pragma once

#include <cstddef>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/tree/tree.h"

namespace cnrg {

/// How much a page tells in all. Of what would be more, nodes of few cells are told first, the result before all
/// others; of those that are left out the page says so, and names the command that tells.
struct PageLimits {
  std::size_t stories = 1'000'000;  ///< cells of the refinement that a node unites, times the nodes below it
  std::size_t topology = 300'000;   ///< cells of the refinement that a node unites
  std::size_t classes = 1'000'000;  ///< entities that the steps of a Boolean ask about
  std::size_t removed = 300'000;    ///< entities that went, times the nodes below
};

/// The data of the page, as JSON. The evaluation must have kept all values
/// and have rows with the volumes of regions; the nodes shown are those that it was asked for, operands before
/// users.
std::string page_data(const Tree& tree, const Evaluation& evaluation, const PageLimits& limits = {});

/// The template with the data, compressed, and the title in it. `stamp` tells this page from one made later: a
/// page that has one looks every second whether its file has another. Throws InputError if the template has no
/// place for them.
std::string page_text(const std::string& page_template, const std::string& title, const std::string& data,
                      const std::string& stamp = {});

}  // namespace cnrg
