// The tables themselves, in the order of the page.
#include "csg/tree/forms.h"

#include <algorithm>
#include <string>

#include "csg/curves/boundary_curves.h"
#include "csg/curves/control_nets.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Kind = Type::Kind;

constexpr Type count(std::string_view name, std::int64_t least, std::int64_t most = Fineness::kMostSegments) {
  return {Kind::count, name, "16", "", {}, least, most};
}
constexpr Type choice(std::string_view name, std::span<const std::string_view> choices) {
  return {Kind::choice, name, choices[0], "", choices};
}

constexpr std::string_view kFills[] = {"winding", "parity", "cells", "none"};
constexpr std::string_view kCadFills[] = {"solids", "winding", "cells", "none"};
constexpr std::string_view kUnits[] = {"um", "mm", "cm", "m", "km", "in", "ft"};
constexpr std::string_view kCoordinates[] = {"double", "decimal"};
constexpr std::string_view kModes[] = {"features", "points"};
constexpr std::string_view kBlends[] = {"linear"};

constexpr Type kNumber{Kind::number, "number", "1", "number"},
    kPositive{Kind::number, "number > 0", "1", "positive number"},
    kFromZero{Kind::number, "number from 0", "1", "number from 0"},
    kPoint{Kind::point, "point", "[x, y, z]", "point"}, kVector{Kind::point, "vector", "[x, y, z]", "point"},
    kPair{Kind::pair, "`[x, y]`", "[x, y]", "pair"},
    kPoints{Kind::points, "points", "[[x, y, z], ...]", "[point]"},
    kLoops{Kind::loops, "loops", "[[[x, y, z], ...], ...]", "[[point]]"},
    kText{Kind::text, "text", "TEXT", "text"}, kPath{Kind::text, "path", "FILE", "text"},
    kBoolean{Kind::boolean, "`true`, `false`", "true", "boolean"},
    kFill = choice("[fill](#fill)", kFills), kChord{Kind::number, "number > 0", "0.1", "positive number"},
    kSteps = count("count from 3", 3), kSegments = count("count", 1);

// Lists and maps that readers read item by item.
constexpr Type other(std::string_view name, std::string_view hint, std::string_view schema) {
  return {Kind::other, name, hint, schema};
}
constexpr Type kOperand = other("node", "NODE", "operand"),
               kOperands = other("list of two nodes or more", "[a, b]", "[operand;2+]"),
               kSomeOperands = other("list of nodes", "[a, b]", "[operand;1+]"),
               kLine = other("line", "[[x, y, z], ...]", "line"),
               kFlatLine = other("line of points `[r, z]`", "[[r, z], ...]", "flat line"),
               kArea = other("line, closed, or a map", "[[x, y, z], ...]", "line|profile"),
               kFlatArea =
                   other("line of points `[r, z]`, closed, or a map", "[[r, z], ...]", "flat line|flat profile"),
               kLines = other("list of lines", "[[[x, y, z], ...], ...]", "[line]"),
               kFlatLines = other("list of lines", "[[[r, z], ...], ...]", "[flat line]"),
               kFlatPoints = other("points `[r, z]`", "[[r, z], ...]", "[pair]"),
               kRows = other("rows of points", "[[[x, y, z], ...], ...]", "[[point;2+];2+]"),
               kWeights = other("numbers > 0", "[1, 1, 2]", "[positive number]"),
               kWeightRows = other("rows of numbers > 0", "[[1, 1], [1, 1]]", "[[positive number]]"),
               kPatch = other("patch", "{points: [[[x, y, z], ...], ...]}", "patch of bezier"),
               kPatches = other("list of patches", "[PATCH, ...]", "[patch of bezier]"),
               kBezierCurve = other("curve", "[[x, y, z], ...]", "curve of bezier"),
               kBezierCurves = other("list of curves", "[CURVE, ...]", "[curve of bezier]"),
               kSplinePatch =
                   other("patch", "{points: [[[x, y, z], ...], ...], degree: [3, 3]}", "patch of bspline"),
               kSplinePatches = other("list of patches", "[PATCH, ...]", "[patch of bspline]"),
               kSplineCurve = other("curve", "{points: [[x, y, z], ...], degree: 3}", "curve of bspline"),
               kSplineCurves = other("list of curves", "[CURVE, ...]", "[curve of bspline]"),
               kRound = other("list of four Bézier curves", "[CURVE, CURVE, CURVE, CURVE]", "[curve of bezier;4]"),
               kRounds =
                   other("list of such lists", "[[CURVE, CURVE, CURVE, CURVE], ...]", "[[curve of bezier;4]]"),
               kDegree = count("count", 1, kMostDegree), kDegrees = other("`[u, v]`", "[3, 3]", "[degree;2]"),
               kKnots = other("numbers", "[0, 0, 1, 1]", "[number]"),
               kBothKnots = other("two lists of numbers", "[[0, 0, 1, 1], [0, 0, 1, 1]]", "[[number];2]"),
               kHeights =
                   other("list of equally long rows of numbers, at least 2 by 2", "[[z, ...], ...]", "[[number]]"),
               kFaces = other("list of polygons", "[[0, 1, 2], ...]", "[[number from a list;3+]]"),
               kSolids = other("list of numbers from 1, or names", "[1, 2]", "[text;1+]"),
               kLoopsOfVertices = other("lists of vertices, three or more in each", "[[0, 1, 2]]",
                                        "[[number from a list;3+];1+]"),
               kRegionSides = other("`[front, back]`", "[1, 0]", "[number from a list;2]"),
               kStops = other("list of stops", "[[0, MATERIAL], [1, MATERIAL]]", "[stop;2+]");
constexpr Type kVersion = other("`1`", "1", "version"), kAnything = other("anything", "", "anything"),
               kParameters = other("map of numbers", "{R: 1}", "parameters"),
               kMaterials = other("map of [materials](#materials)", "{rock: {}}", "nothing|{material|nothing}"),
               kNodes = other("map, not empty", "{NAME: {box: {min: [0, 0, 0], max: [1, 1, 1]}}, ...}", "nodes"),
               kLinear = other("map", "{from: [x, y, z], to: [x, y, z], stops: [...]}", "linear"),
               kDistance = other("map", "{to: NODE, stops: [...]}", "distance"),
               kGroupFaces = other("list of maps", "[{loops: [[0, 1, 2]]}]", "[face of a group]"),
               kPairsOfVertices = other("list of pairs of vertices", "[[0, 1]]", "[[number from a list;2]]"),
               kVertices = other("list of vertices", "[0]", "[number from a list]"),
               kRegions = other("map: number of a region: map", "{1: {}}", "regions"),
               kProperties = other("map", "{diameter: 25}", "{text}"),
               kWantedProperties =
                   other("map: key, a value or a list of them", "{diameter: 25}", "{text|[text;1+]}"),
               kDominance = other("number, or `left`, `right`, `equal`", "1", "number|side"),
               kRegularize = other("`true`, `false`", "true", "boolean|operand"),
               kScale = other("number, or three", "2", "number|point"),
               kMatrix = other("three rows of four numbers", "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]",
                               "[[number;4];3]"),
               kRotate = other("map, below", "{axis: [0, 0, 1], degrees: 90}", "rotate"),
               kMirror = other("map, below", "{normal: [1, 0, 0]}", "mirror"),
               kSimplify = other("node, or a map, below", "NODE", "operand|simplify"),
               kSelect = other("map, below", "{of: NODE, dimension: 2}", "select"),
               kRepeat = other("map, below", "{of: {...}, count: 30, index: i}", "repeat"),
               kInline = other("node `{...}`", "{OPERATOR: ..., translate: [\"${i}\", 0, 0]}", "node"),
               kDimension = other("0, 1, 2, 3", "2", "dimension|[dimension;1+]"),
               kTexts = other("text", "TEXT", "text|[text;1+]"),
               kRegionNames = other("name, or number from 1; a number in quotes is a name", "1", "text|[text;1+]"),
               kNodeNames = other("names of nodes below `of`", "NODE", "text|[text;1+]"),
               kFaceNumbers = other("number of a face of `from`, a single leaf", "0",
                                    "number from a list|[number from a list;1+]"),
               kBetween =
                   other("`[A, B]`, or a list of such pairs: names of regions or materials, `null` for no region",
                         "[A, B]", "[text|nothing;2]|[[text|nothing;2];1+]"),
               kPlaces = other("node, or a list of them", "NODE", "operand|[operand;1+]");
constexpr Type kNodeName{Kind::text, "name of a node", "NODE", "text"},
    kMaterial{Kind::text, "name in `materials`", "MATERIAL", "text"},
    kColor{Kind::text, "`\"#rrggbb\"`", "\"#998877\"", "color"},
    kFourPoints{Kind::points, "four points", "", "[point;4]"},
    kSummands{Kind::loops, "lists of points, two or more", "", "[[point];2+]"},
    kCorners{Kind::points, "points", "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]", "[point]"};
constexpr Type kUnit = choice("`um`, `mm`, `cm`, `m`, `km`, `in`, `ft`", kUnits),
               kCadFill = choice("`solids`, `winding`, `cells`, `none`", kCadFills),
               kCoordinate = choice("`double`, `decimal`", kCoordinates),
               kMode = choice("`features`, `points`", kModes), kBlend = choice("`linear`", kBlends),
               kRings = count("count from 2", 2), kCopies{Kind::count, "count to 50000", "30", "", {}, 1, 50'000};

constexpr Key kFinenessKeys[] = {
    {"chord",
     kPositive,
     "none",
     "largest distance of a facet from the exact surface, and of a piece of a wire from its curve; proven (of CAD "
     "models "
     "measured)",
     "segments",
     {},
     "fineness"},
    {"segments",
     kSegments,
     "16",
     "equal steps of each curve, and of a whole turn (at least 3)",
     {},
     {},
     "fineness"},
};
constexpr Key kChordKey = kFinenessKeys[0], kStepsKey = kFinenessKeys[1],
              kTurnKey{"segments", kSteps, "32", "around the axis"},
              kWeldKey{"weld", kPositive, "none", "[joins](#weld) what is that near"};

constexpr Key kTreeKeys[] = {
    {"cnrg", kVersion, kRequired, "version of the format"},
    {"materials", kMaterials, "none", "names that nodes may use"},
    {"nodes", kNodes, kRequired, "name of a node: the node"},
    {"result", kNodeName, kRequired, "what is evaluated, shown, meshed"},
    {"weld", kPositive, "none", "[joins](#weld) what is that near, in all leaves together"},
    {"parameters", kParameters, "none",
     "names for [expressions](#expressions); `-D NAME=NUMBER` gives one another number"},
    {"$schema", kAnything, "none", "for editors"},
};
constexpr Key kOperatorKeys[] = {
    {"union", kOperands, {}, "groups; of components [closed ones](SEMANTICS.md#from-one-family-to-the-other)"},
    {"intersection",
     kOperands,
     {},
     "groups; of components [closed ones](SEMANTICS.md#from-one-family-to-the-other)"},
    {"difference",
     kOperands,
     {},
     "groups; of components [closed ones](SEMANTICS.md#from-one-family-to-the-other)"},
    {"sum", kOperands, {}, "any values"},
    {"product", kOperands, {}, "any values"},
    {"subtract", kOperands, {}, "any values"},
    {"aggregate", kSomeOperands, {}, "any values that do not overlap"},
    {"unify", kOperand, {}, "any value"},
    {"complement", kOperand, {}, "any value"},
    {"interior", kOperand, {}, "any value"},
    {"closure", kOperand, {}, "any value"},
    {"boundary", kOperand, {}, "any value"},
    {"regularize", kOperand, {}, "any value"},
    {"simplify", kSimplify, {}, "any value; the node itself, to be moved or to get attributes"},
    {"select", kSelect, {}, "any value; [the cells that meet all criteria](SEMANTICS.md#select)"},
    {"below",
     kOperand,
     {},
     "of a surface, with a solid as `within`: [what is on that side](SEMANTICS.md#below-and-above)"},
    {"above",
     kOperand,
     {},
     "of a surface, with a solid as `within`: [what is on that side](SEMANTICS.md#below-and-above)"},
    {"repeat", kRepeat, {}, "the `union` of copies"},
    {"csg", kPath, {}, "the [solid](#openscad) of a `.csg` file"},
};
constexpr Key kSimplifyKeys[] = {
    {"of", kOperand, kRequired},
    {"mode", kMode, "`features`", "`points` forgets features: unites all coplanar faces and collinear edges"},
    {"within", kPositive, "none",
     "[joins](SEMANTICS.md#joined-nodes) what does not touch and is nearer; a length before transforms of "
     "`simplify`"},
};
constexpr Key kSelectKeys[] = {
    {"of", kOperand, kRequired},
    {"dimension", kDimension, "any"},
    {"name", kTexts, "any"},
    {"material", kTexts, "any", "in `materials`"},
    {"attributes", kWantedProperties, "any"},
    {"region", kRegionNames, "any"},
    {"front of", kNodeNames, "any", "[sides](SEMANTICS.md#sides-of-surfaces)"},
    {"behind", kNodeNames, "any", "[sides](SEMANTICS.md#sides-of-surfaces)"},
    {"from", kNodeNames, "any"},
    {"source face", kFaceNumbers, "any"},
    {"between", kBetween, "any"},
    {"inside", kPlaces, "any"},
    {"touching", kPlaces, "any"},
};
constexpr Key kRepeatKeys[] = {
    {"of", kInline, kRequired, "read anew for each copy"},
    {"count", kCopies, kRequired},
    {"index", kText, kRequired, "a name for the [number](#expressions) of the copy, from 0"},
};
constexpr Key kAttributeKeys[] = {
    {"material", kMaterial, "none", "of regions, sheets, wires and points ([rules](SEMANTICS.md#attributes))"},
    {"name", kText, "the node's",
     "likewise; several unnamed regions of a leaf are `NAME.1`, `NAME.2`, or `NODE.1`, `NODE.2`"},
    {"attributes", kProperties, "none",
     "likewise, key by key: keys of any name with numbers or texts; a number in quotes is a text"},
    {"size", kPositive, "none",
     "length of [mesh edges](#sizes) on what comes from the leaves below, unless a node nearer to the leaf has "
     "one"},
    {"dominance", kDominance, "0 of a leaf, the largest of the operands'",
     "[of the value](SEMANTICS.md#dominance). A word, of `union`, `intersection`, `difference`, `sum`, `product`: "
     "which "
     "operand dominates, whatever the numbers"},
    {"blend", kBlend, "none",
     "of `union`: overlaps become [a mixture](SEMANTICS.md#blending); excludes a word as `dominance`"},
    {"regularize", kRegularize, "`false`", "as the operator"},
    {"simplify", kMode, "none", "beside another operator or a leaf: as the operator with this mode"},
    {"each", kBoolean, "`false`",
     "of `interior`, `closure`, `boundary`, `regularize`: [by component](SEMANTICS.md#components)"},
    {"within", kOperand, "none", "of `below`, `above`: the solid"},
    {"translate", kVector, "none", "moves by it"},
    {"rotate", kRotate, "none", "turns by the right-hand rule"},
    {"scale", kScale, "none", "from the origin; none is 0"},
    {"mirror", kMirror, "none", "reflects in a plane"},
    {"matrix", kMatrix, "none",
     "moves by any affine map that flattens nothing: the last number of a row is added"},
};
constexpr Key kRotateKeys[] = {
    {"axis", kVector, kRequired, "not zero"},
    {"degrees", kNumber, kRequired,
     "exact for multiples of 90 about coordinate axes; else a rational, exactly orthogonal rotation whose angle "
     "is off by "
     "less than 1e-15"},
    {"center", kPoint, "the origin", "the axis goes through it"},
};
constexpr Key kMirrorKeys[] = {
    {"normal", kVector, kRequired, "of the plane, not zero"},
    {"point", kPoint, "the origin", "in the plane"},
};
constexpr Key kMaterialKeys[] = {
    {"color", kColor, "none", "goes to [`.json`](#json)"},
    {"dominance", kNumber, "0",
     "[which material wins](SEMANTICS.md#dominance-of-materials) where operands have equal numbers"},
    {"linear", kLinear, "none", "graded along a line", "distance"},
    {"distance", kDistance, "none", "graded by a distance"},
};
constexpr Key kLinearKeys[] = {
    {"from", kPoint, kRequired, "here the parameter is 0"},
    {"to", kPoint, kRequired, "here it is 1; differs from `from`"},
    {"stops", kStops, kRequired},
};
constexpr Key kDistanceKeys[] = {
    {"to", kNodeName, kRequired, "to its faces, wires and points; the parameter is the distance"},
    {"stops", kStops, kRequired, "none negative"},
};
constexpr Key kBoxKeys[] = {
    {"min", kPoint, kRequired, "faces 0 to 5: least x, greatest x, least y, greatest y, least z, greatest z"},
    {"max", kPoint, kRequired, "greater than `min` in every axis"},
};
constexpr Key kPrismKeys[] = {
    {"base", kPoints, kRequired, "a simple polygon in a plane; face 0"},
    {"holes", kLoops, "none", "in the polygon, disjoint"},
    {"vector", kVector, kRequired,
     "out of the plane; the base moved by it is face 1, sides are faces from 2, one for collinear edges"},
};
constexpr Key kPyramidKeys[] = {
    {"base", kPoints, kRequired, "as for `prism`"},
    {"apex", kPoint, kRequired, "off the plane; sides are faces from 1"},
};
constexpr Key kTetrahedronValue[] = {{"", kFourPoints, kRequired, "not in one plane"}};
constexpr Key kHullValue[] = {
    {"", kPoints, kRequired, "not all in one plane; their convex hull, a face for each of its planes"}};
constexpr Key kMinkowskiValue[] = {
    {"", kSummands, kRequired, "all sums of a point of the convex hull of each list"}};
constexpr Key kPolygonKeys[] = {
    {"outer", kPoints, kRequired, "a simple polygon in a plane, exactly; face 0"},
    {"holes", kLoops, "none", "in the polygon, disjoint"},
};
constexpr Key kPolylineKeys[] = {
    {"points", kPoints, kRequired, "two or more; edge 0"},
    {"closed", kBoolean, "`false`", "returns to the first point"},
};
constexpr Key kPointsValue[] = {{"", kPoints, kRequired, "one or more"}};
constexpr Key kPlaneKeys[] = {
    {"point", kPoint, kRequired, "in the plane"},
    {"normal", kVector, kRequired, "not zero; the plane is face 0, its front looks along the normal"},
};
constexpr Key kHalfspaceKeys[] = {
    {"point", kPoint, kRequired, "in the plane"},
    {"normal", kVector, kRequired, "points away from the region"},
};
constexpr Key kSphereKeys[] = {
    {"center", kPoint, kRequired},
    {"radius", kPositive, kRequired},
    {"segments", kSteps, "32", "meridians"},
    {"rings", kRings, "half of `segments`", "bands from pole to pole, along z; all are face 0"},
};
constexpr Key kCylinderKeys[] = {
    {"from", kPoint, kRequired, "centre of face 0, a flat cap"},
    {"to", kPoint, kRequired, "centre of face 1, a flat cap; the side is face 2"},
    {"radius", kPositive, kRequired},
    kTurnKey,
};
constexpr Key kConeKeys[] = {
    {"from", kPoint, kRequired, "faces as for `cylinder`"},
    {"to", kPoint, kRequired, "faces as for `cylinder`"},
    {"radius", kFromZero, kRequired, "at `from`"},
    {"top", kFromZero, "0", "at `to`; where a radius is 0 there is no cap"},
    kTurnKey,
};
constexpr Key kTorusKeys[] = {
    {"center", kPoint, kRequired},
    {"axis", kVector, kRequired},
    {"radius", kPositive, kRequired, "from the centre to the middle of the tube"},
    {"tube", kPositive, kRequired, "radius of the tube, less than `radius`"},
    kTurnKey,
    {"rings", kSteps, "16", "around the tube; all is face 0"},
};
constexpr Key kExtrudeKeys[] = {
    {"profile", kArea, {}, "bounds an area in a plane; a solid", "curve"},
    {"curve", kLine, {}, "open; a surface"},
    {"vector", kVector, kRequired, "path of the sweep; out of the plane of a profile"},
    {"twist", kNumber, "0", "degrees in all, about the axis through `center` along the vector"},
    {"scale", kFromZero, "1",
     "at the end, about `center`; with it or `twist` the profile is at right angles to the vector"},
    {"center", kPoint, "first corner"},
    kChordKey,
    kStepsKey,
};
constexpr Key kRevolveKeys[] = {
    {"profile", kFlatArea, {}, "r from 0, the distance from the axis, z along it; a solid", "curve"},
    {"curve", kFlatLine, {}, "open; a surface"},
    {"center", kPoint, "the origin", "where z is 0"},
    {"axis", kVector, "`[0, 0, 1]`"},
    {"degrees", kPositive, "360", "the turn, by the right-hand rule; at most 360"},
    kChordKey,
    kStepsKey,
};
constexpr Key kProfileKeys[] = {
    {"outer", kLine, kRequired, "closed"},
    {"holes", kLines, "none"},
};
constexpr Key kFlatProfileKeys[] = {
    {"outer", kFlatLine, kRequired, "closed"},
    {"holes", kFlatLines, "none"},
};
constexpr Key kCurveKeys[] = {
    {"bezier", kPoints, kRequired, "control points between the two corners"},
    {"weights", kWeights, "all 1", "of all control points, corners too"},
};
constexpr Key kFlatCurveKeys[] = {
    {"bezier", kFlatPoints, kRequired, "control points between the two corners"},
    {"weights", kWeights, "all 1", "of all control points, corners too"},
};
constexpr Key kBezierKeys[] = {
    {"patch", kPatch, {}, {}, "patches"},
    {"patches", kPatches},
    {"curve", kBezierCurve, {}, {}, "curves"},
    {"curves", kBezierCurves},
    {"fill", kFill, "`none`"},
    kChordKey,
    kStepsKey,
};
constexpr Key kBsplineKeys[] = {
    {"patch", kSplinePatch, {}, {}, "patches"},
    {"patches", kSplinePatches},
    {"curve", kSplineCurve, {}, {}, "curves"},
    {"curves", kSplineCurves},
    {"fill", kFill, "`none`"},
    kChordKey,
    kStepsKey,
};
constexpr Key kCoonsKeys[] = {
    {"patch",
     kRound,
     {},
     "each begins where the one before it ends; the first runs along u. A side may be one point, twice",
     "patches"},
    {"patches", kRounds},
    {"fill", kFill, "`none`"},
    kChordKey,
    kStepsKey,
};
constexpr Key kPatchKeys[] = {
    {"points", kRows, kRequired,
     "equally long rows. u runs along a row, v from row to row; the front is the side of S_u × S_v"},
    {"weights", kWeightRows, "all 1"},
    {"degree", kDegrees, kRequired, "1 to 32, less than the number of points"},
    {"knots", kBothKnots, "clamped, equal spans", "ascending, points + degree + 1 of them"},
};
constexpr Key kNetCurveKeys[] = {
    {"points", kPoints, kRequired},
    {"weights", kWeights, "all 1", "`[1, 1, 2]` makes a quarter of a circle of three points, exactly"},
    {"degree", kDegree, kRequired, "1 to 32, less than the number of points"},
    {"knots", kKnots, "clamped, equal spans", "ascending, points + degree + 1 of them"},
};
constexpr Key kHeightfieldKeys[] = {
    {"heights", kHeights, {}, "rows run along y, entries along x"},
    {"origin", kPair, "`[0, 0]`", "of the first entry of the first row"},
    {"spacing", kPair, "`[1, 1]`", "both > 0"},
    {"file", kPath, {}, "of an ESRI ASCII grid; of points, `.xyz`", "heights,origin,spacing"},
    {"base", kNumber, "none", "below all heights: the solid down to this level; without it a surface"},
};
constexpr Key kMeshKeys[] = {
    {"file", kPath, {}, "`.off`, `.obj`, `.stl`, `.ply`, `.vtp`, `.vtk`, `.ts`, `.pl`, `.wl`", "points,faces"},
    {"points", kPoints, {}, "numbered from 0", {}, "faces"},
    {"faces", kFaces, {}, "numbers of points, three or more each, counter-clockwise from outside", {}, "points"},
    {"fill", kFill, "`winding` if closed, else `none` with a notice"},
    {"coordinates", kCoordinate, "`double`", "of a file; `decimal`: text as exact decimals", "points,faces"},
    kWeldKey,
};
constexpr Key kStepKeys[] = {
    {"file", kPath, kRequired},
    kChordKey,
    kStepsKey,
    {"fill", kCadFill, "`solids` if there are any, else `none`",
     "`solids`: each solid is a region with its name, or its product's, in STEP; solids may share faces, and are "
     "an error "
     "where they overlap"},
    {"solids", kSolids, "all", "only these"},
    {"seams", kBoolean, "`false`",
     "adds edges and vertices where a face meets itself (the seam of a cylinder, the pole of a sphere)"},
    kWeldKey,
    {"unit", kUnit, "that of the file", "of the model"},
};
constexpr Key kGroupKeys[] = {
    {"vertices", kPoints, kRequired, "numbered from 0"}, {"faces", kGroupFaces, "none", "numbered from 0"},
    {"edges", kPairsOfVertices, "none", "wires"},        {"points", kVertices, "none", "isolated points"},
    {"regions", kRegions, "none", "numbered from 1"},    {"fill", kFill, "by `sides`", "excludes `sides`"},
};
constexpr Key kGroupFaceKeys[] = {
    {"loops", kLoopsOfVertices, kRequired, "the outer one, then holes; planar, simple"},
    {"sides", kRegionSides, "`[0, 0]`",
     "the regions on the side from which the first loop is counter-clockwise, and on the other; 0: none. "
     "Contradictions in "
     "one cavity are an error"},
};
constexpr Key kGroupRegionKeys[] = {
    {"material", kMaterial, "none"},
    {"name", kText, "none"},
};
constexpr Key kResultValue[] = {{"", kPath, kRequired,
                                 "a `.json` of `cnrg eval -o`: the same value, with numbers, names, materials, "
                                 "dominance, features, parameters"}};

constexpr std::string_view kCriteria =
    "dimension,name,material,attributes,region,front of,behind,from,between,inside,touching";

constexpr Form kForms[] = {
    {"a tree file", "file", kTreeKeys},
    {"operator", "operators", kOperatorKeys},
    {"simplify", "parts of operators", kSimplifyKeys, "{of: a, within: 0.001}"},
    {"select", "parts of operators", kSelectKeys, "{of: model, dimension: 2, between: [rock, clay]}", kCriteria},
    {"repeat", "parts of operators", kRepeatKeys,
     "{of: {simplify: bolt, translate: [\"${3 * i}\", 0, 0]}, count: 30, index: i}"},
    {"criteria", {}, std::span(kSelectKeys).subspan(1)},
    {"attribute", "attributes", kAttributeKeys},
    {"rotate", "parts of attributes", kRotateKeys, "{axis: [0, 0, 1], degrees: 45, center: [1, 0, 0]}"},
    {"mirror", "parts of attributes", kMirrorKeys, "{normal: [1, 0, 0]}"},
    {"fineness", "fineness", kFinenessKeys},
    {"box", "solids", kBoxKeys, "{min: [0, 0, 0], max: [1, 2, 3]}"},
    {"prism", "solids", kPrismKeys, "{base: [[0, 0, 0], [3, 0, 0], [0, 3, 0]], vector: [0, 0, 1/2]}"},
    {"pyramid", "solids", kPyramidKeys, "{base: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], apex: [0, 0, 1]}"},
    {"tetrahedron", "solids", kTetrahedronValue, "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]"},
    {"hull", "solids", kHullValue, "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]"},
    {"minkowski", "solids", kMinkowskiValue, "[[[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 0, 0], [0, 0, 1]]]"},
    {"polygon",
     "surfaces",
     kPolygonKeys,
     "{outer: [[0, 0, 0], [3, 0, 0], [0, 3, 0]], holes: [[[1/2, 1/2, 0], [1, 1/2, 0], [1/2, 1, 0]]]}",
     {},
     {},
     true},
    {"polyline", "surfaces", kPolylineKeys, "[[0, 0, 0], [0, 0, 145/3]]", {}, {}, true},
    {"points", "surfaces", kPointsValue, "[[0, 0, 0], [0.1, 2e-3, 1/3]]"},
    {"plane", "planes", kPlaneKeys, "{point: [0, 0, 1], normal: [0, 0, 1]}"},
    {"halfspace", "planes", kHalfspaceKeys, "{point: [0, 0, 1], normal: [0, 0, 1]}"},
    {"sphere", "round", kSphereKeys, "{center: [0, 0, 0], radius: 1}"},
    {"cylinder", "round", kCylinderKeys, "{from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 48}"},
    {"cone", "round", kConeKeys, "{from: [0, 0, 0], to: [0, 0, 1], radius: 1, top: 1/2}"},
    {"torus", "round", kTorusKeys, "{center: [0, 0, 0], axis: [0, 0, 1], radius: 2, tube: 1/2}"},
    {"extrude", "sweeps", kExtrudeKeys,
     "{profile: [[0, 0, 0], [1, 0, 0], {bezier: [[2, 1, 0]]}, [0, 1, 0]], vector: [0, 0, 2], chord: 0.01}",
     "profile,curve"},
    {"revolve", "sweeps", kRevolveKeys, "{profile: [[1, 0], [2, 0], [2, 1]], degrees: 90}", "profile,curve"},
    {"profile", "parts of sweeps", kProfileKeys, {}, {}, {}, true},
    {"flat profile", {}, kFlatProfileKeys, {}, {}, {}, true},
    {"curve of a line", "parts of sweeps", kCurveKeys},
    {"curve of a flat line", {}, kFlatCurveKeys},
    {"bezier", "patches", kBezierKeys, "{patch: [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 1]]], segments: 8}",
     "patch,patches,curve,curves"},
    {"bspline", "patches", kBsplineKeys,
     "{curve: {points: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 1, 0]], degree: 2}}", "patch,patches,curve,curves"},
    {"coons", "patches", kCoonsKeys,
     "{patch: [[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 1, 1]], [[1, 1, 1], [0, 1, 0]], [[0, 1, 0], [0, 0, 0]]]}",
     "patch,patches"},
    {"patch of bspline", "parts of patches", kPatchKeys},
    {"curve of bspline", "parts of patches", kNetCurveKeys},
    {"patch of bezier", "parts of patches", std::span(kPatchKeys).first(2), {}, {}, {}, true},
    {"curve of bezier", "parts of patches", std::span(kNetCurveKeys).first(2), {}, {}, {}, true},
    {"heightfield", "terrain", kHeightfieldKeys, "{heights: [[0, 1, 0], [1, 2, 1]], spacing: [10, 10], base: -5}",
     "heights,file"},
    {"mesh", "meshes", kMeshKeys,
     "{points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], faces: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]}",
     "file,faces"},
    {"step", "cad", kStepKeys, {}},
    {"brep", "cad", std::span(kStepKeys).first(7)},
    {"group",
     "groups",
     kGroupKeys,
     "{vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], faces: [{loops: [[0, 1, 2]]}], edges: [[0, 1]]}",
     {},
     R"("if":{"required":["fill"]},"then":{"properties":{"faces":{"items":{"properties":{"sides":false}}}}})"},
    {"face of a group", "parts of groups", kGroupFaceKeys},
    {"region of a group", "parts of groups", kGroupRegionKeys},
    {"cnrg", "results", kResultValue},
    {"material", "materials", kMaterialKeys,
     "{color: \"#998877\", linear: {from: [0, 0, 0], to: [0, 0, 4], stops: [[0, steel], [1, ceramic]]}}"},
    {"linear", "materials", kLinearKeys},
    {"distance", "materials", kDistanceKeys},
};

}  // namespace

const Key* Form::find(std::string_view key) const {
  const auto it = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == key; });
  return it == keys.end() ? nullptr : &*it;
}

std::vector<std::string_view> listed_keys(std::string_view list) {
  std::vector<std::string_view> keys;
  for (std::size_t end = 0; !list.empty(); list.remove_prefix(std::min(end, list.size()))) {
    end = list.find(',');
    keys.push_back(list.substr(0, end));
    if (end != std::string_view::npos) ++end;
  }
  return keys;
}

std::span<const Form> all_forms() { return kForms; }

const Form& form(std::string_view name) {
  const auto it =
      std::find_if(std::begin(kForms), std::end(kForms), [&](const Form& f) { return f.name == name; });
  require(it != std::end(kForms), "form: there is no such one");
  return *it;
}

}  // namespace cnrg
