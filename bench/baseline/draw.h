// Drawings of what a stage found, collected by name.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/baseline/scene.h"
#include "bench/baseline/steps.h"

namespace cnrg::bench::mantyla {

/// A drawing in the making.
class Sketch {
 public:
  void point(const RationalPoint& p) { model_.isolated.push_back(add(p)); }
  void line(const RationalPoint& p, const RationalPoint& q) { model_.wires.push_back({add(p), add(q)}); }
  void triangle(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
    model_.faces.push_back({{{add(p), add(q), add(r)}}, false});
  }
  Model& model() { return model_; }

 private:
  std::uint32_t add(const RationalPoint& p) {
    const auto [found, fresh] = numbers_.emplace(p, static_cast<std::uint32_t>(model_.points.size()));
    if (fresh) model_.points.push_back(p);
    return found->second;
  }

  Model model_;
  std::map<RationalPoint, std::uint32_t> numbers_;
};

/// By name, in the order of names.
class Drawings {
 public:
  Sketch& of(const std::string& name) { return sketches_[name]; }
  std::vector<Drawing> take() {
    std::vector<Drawing> drawings;
    for (auto& [name, sketch] : sketches_) drawings.push_back({name, std::move(sketch.model())});
    return drawings;
  }

 private:
  std::map<std::string, Sketch> sketches_;
};

template <class N>
double distance(const Vec<N>& p, const Vec<N>& q) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += std::pow(approximate(N(p[k] - q[k])), 2);
  return std::sqrt(sum);
}

/// The point in a direction of any length, about so far away, exactly on the line.
template <class N>
RationalPoint along(const Vec<N>& p, const Vec<N>& direction, double far) {
  RationalPoint way = exact(direction);
  Rational longest = 0;
  for (const Rational& x : way) longest = std::max<Rational>(longest, abs(x));
  for (Rational& x : way) x /= longest;
  const double length = std::hypot(to_double(way[0]), to_double(way[1]), to_double(way[2]));
  int exponent = 0;
  const auto few_digits = static_cast<float>(std::frexp(far / length, &exponent));
  RationalPoint at = exact(p);
  for (int k = 0; k < 3; ++k) at[k] += way[k] * from_double(std::ldexp(few_digits, exponent));
  return at;
}

/// The neighbourhoods of all contacts, by solid; after classification, or as far as it came.
template <class N>
std::array<std::vector<Drawing>, 2> draw_sectors(const Scene<N>& scene);

}  // namespace cnrg::bench::mantyla
