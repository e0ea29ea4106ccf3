// Graded materials of a result in .json (the format is that of csg/formats/result.schema.json).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "csg/imports/json_cursor.h"
#include "csg/materials/grade.h"

namespace cnrg::result {

/// The entries of `grades` in their order; none where the file has no such member. Throws LeafFileError
/// for what is wrong in them. `material` is called with each name of one and its place.
std::vector<std::shared_ptr<const PlacedGrade>> read_grades(
    const Cursor& root, const std::function<void(const std::string&, const Cursor&)>& material);

}  // namespace cnrg::result
