// Checks of control nets, and B-splines cut at their knots: first along u, then along v.
#include "csg/curves/control_nets.h"

#include <utility>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

std::string number(std::size_t n) { return std::to_string(n); }

void check_weight(const Rational& weight, const std::string& what) {
  if (weight > 0) return;
  throw InputError(what + ": a weight is " + to_decimal(weight) + ": give positive weights");
}

void check_degree(int degree, std::size_t points, const std::string& what) {
  if (points < 2) throw InputError(what + ": " + number(points) + " control points are too few: give at least 2");
  const std::size_t d = degree > 0 ? static_cast<std::size_t>(degree) : points - 1;
  if (d > static_cast<std::size_t>(kMostDegree)) {
    throw InputError(what + ": its degree is " + number(d) + ": give at most " + std::to_string(kMostDegree) +
                     (degree > 0 ? "" : ", by several pieces or a `bspline`"));
  }
  if (points < d + 1) {
    throw InputError(what + ": degree " + number(d) + " takes at least " + number(d + 1) +
                     " control points, there are " + number(points) + ": add points or lower the degree");
  }
}

/// The knots to use; the given ones are checked.
std::vector<Rational> knots_of(const std::vector<Rational>& knots, std::size_t points, std::size_t degree,
                               const std::string& what) {
  if (knots.empty()) return clamped_knots(points, degree);
  if (knots.size() != points + degree + 1) {
    throw InputError(what + ": " + number(points) + " control points of degree " + number(degree) + " take " +
                     number(points + degree + 1) + " knots, there are " + number(knots.size()) +
                     ": give points + degree + 1 knots");
  }
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i - 1] <= knots[i]) continue;
    throw InputError(what + ": knot " + number(i + 1) + " is " + to_decimal(knots[i]) +
                     ", less than the one before it, " + to_decimal(knots[i - 1]) + ": give knots that ascend");
  }
  const Rational &low = knots[degree], &high = knots[points];
  if (low == high) throw InputError(what + ": all spans between the knots are empty: give different knots");
  for (std::size_t i = degree + 1; i < points; ++i) {
    if (low < knots[i] && knots[i] < high && knots[i - 1] < knots[i] && knots[i + degree] == knots[i]) {
      throw InputError(what + ": the knot " + to_decimal(knots[i]) + " is there more than " + number(degree) +
                       " times, it would tear the spline: repeat an inner knot at most degree times");
    }
  }
  return knots;
}

std::vector<ControlRow> pieces(ControlRow row, int degree, const std::vector<Rational>& knots,
                               const std::string& what) {
  if (degree == 0) return {std::move(row)};
  const std::size_t d = static_cast<std::size_t>(degree);
  return bezier_pieces(row, d, knots_of(knots, row.size(), d, what));
}

std::vector<Span> spans(int degree, const std::vector<Rational>& given, std::size_t points) {
  if (degree == 0) return {{0, 1}};
  const std::size_t d = static_cast<std::size_t>(degree);
  const std::vector<Rational> knots = given.empty() ? clamped_knots(points, d) : given;
  std::vector<Span> result;
  for (std::size_t i = d; i < points; ++i) {
    if (knots[i] != knots[i + 1]) result.push_back({knots[i], knots[i + 1]});
  }
  return result;
}

}  // namespace

std::vector<Span> curve_spans(const CurveNet& net) { return spans(net.degree, net.knots, net.points.size()); }

std::vector<std::array<Span, 2>> patch_spans(const PatchNet& net) {
  const std::vector<Span> along_u = spans(net.degree[0], net.knots[0], net.points[0].size());
  std::vector<std::array<Span, 2>> result;
  for (const Span& v : spans(net.degree[1], net.knots[1], net.points.size())) {
    for (const Span& u : along_u) result.push_back({u, v});
  }
  return result;
}

std::vector<BezierCurve> curve_pieces(const CurveNet& net, const std::string& what) {
  check_degree(net.degree, net.points.size(), what);
  if (!net.weights.empty() && net.weights.size() != net.points.size()) {
    throw InputError(what + ": " + number(net.points.size()) + " control points have " +
                     number(net.weights.size()) + " weights: give one for each");
  }
  ControlRow row;
  for (std::size_t i = 0; i < net.points.size(); ++i) {
    const Rational weight = net.weights.empty() ? Rational(1) : net.weights[i];
    check_weight(weight, what);
    row.push_back(homogeneous(net.points[i], weight));
  }
  std::vector<BezierCurve> result;
  for (ControlRow& piece : pieces(std::move(row), net.degree, net.knots, what))
    result.push_back({std::move(piece)});
  return result;
}

std::vector<BezierPatch> patch_pieces(const PatchNet& net, const std::string& what) {
  const std::size_t rows = net.points.size(), columns = rows == 0 ? 0 : net.points[0].size();
  check_degree(net.degree[0], columns, what + ", along u");
  check_degree(net.degree[1], rows, what + ", along v");
  if (!net.weights.empty() && net.weights.size() != rows) {
    throw InputError(what + ": " + number(rows) + " rows of control points have " + number(net.weights.size()) +
                     " rows of weights: give one weight for each point");
  }
  std::vector<ControlRow> grid;
  for (std::size_t j = 0; j < rows; ++j) {
    if (net.points[j].size() != columns) {
      throw InputError(what + ": row " + number(j + 1) + " has " + number(net.points[j].size()) +
                       " control points, row 1 has " + number(columns) + ": give rows of equal length");
    }
    if (!net.weights.empty() && net.weights[j].size() != columns) {
      throw InputError(what + ": row " + number(j + 1) + " has " + number(net.weights[j].size()) +
                       " weights and " + number(columns) + " control points: give one weight for each point");
    }
    grid.emplace_back();
    for (std::size_t i = 0; i < columns; ++i) {
      const Rational weight = net.weights.empty() ? Rational(1) : net.weights[j][i];
      check_weight(weight, what);
      grid.back().push_back(homogeneous(net.points[j][i], weight));
    }
  }
  std::vector<std::vector<ControlRow>> strips;  // [span of u][row]
  for (std::size_t j = 0; j < rows; ++j) {
    const std::vector<ControlRow> cut = pieces(grid[j], net.degree[0], net.knots[0], what + ", along u");
    strips.resize(cut.size());
    for (std::size_t s = 0; s < cut.size(); ++s) strips[s].push_back(cut[s]);
  }
  std::vector<std::vector<BezierPatch>> table;  // [span of v][span of u]
  for (std::size_t s = 0; s < strips.size(); ++s) {
    for (std::size_t i = 0; i < strips[s][0].size(); ++i) {
      ControlRow column;
      for (const ControlRow& row : strips[s]) column.push_back(row[i]);
      const std::vector<ControlRow> cut =
          pieces(std::move(column), net.degree[1], net.knots[1], what + ", along v");
      table.resize(cut.size());
      for (std::size_t t = 0; t < cut.size(); ++t) {
        table[t].resize(strips.size());
        table[t][s].net.resize(cut[t].size());
        for (std::size_t j = 0; j < cut[t].size(); ++j) table[t][s].net[j].push_back(cut[t][j]);
      }
    }
  }
  std::vector<BezierPatch> result;
  for (auto& row : table) {
    for (BezierPatch& patch : row) result.push_back(std::move(patch));
  }
  return result;
}

}  // namespace cnrg
