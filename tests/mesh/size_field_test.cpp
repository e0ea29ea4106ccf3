// The field of sizes against brute force with distances of another kind.
#include "csg/mesh/size_field.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <thread>

#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

using Vector = SizeField::Vector;

double far(const Vector& p, const Vector& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

/// The distance to a triangle, a convex function of two parameters, by nested ternary search.
double far_from(const Vector& p, const std::array<Vector, 3>& t) {
  const auto least = [](const auto& f) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
    }
    return f((low + high) / 2);
  };
  return least([&](double u) {
    return least([&](double v) {
      Vector q;
      for (std::size_t k = 0; k < 3; ++k)
        q[k] = t[0][k] + u * ((t[1][k] - t[0][k]) * (1 - v) + (t[2][k] - t[0][k]) * v);
      return far(p, q);
    });
  });
}

}  // namespace

TEST_CASE("a field of sizes without sources is the overall size", "[size]") {
  CHECK(SizeField().at({1, 2, 3}) == kInfinity);
  CHECK(SizeField().empty());
  const SizeField plain({}, 0.3, 0.25);
  CHECK(plain.at({1e9, 0, 0}) == 0.25);
  CHECK_FALSE(plain.empty());
  CHECK(plain.overall() == 0.25);
  CHECK(plain.growth() == 0.3);
  CHECK(SizeField({}, 0.3, kInfinity).empty());
}

TEST_CASE("a field of sizes grows from points, segments and triangles", "[size]") {
  const Vector o{0, 0, 0}, x{4, 0, 0}, y{0, 4, 0};
  for (const auto& corners : {std::array{o, o, o}, std::array{o, x, x}, std::array{o, o, x}, std::array{o, x, o},
                              std::array{o, x, y}, std::array{o, Vector{1, 0, 0}, x}}) {
    const SizeField field({{corners, 0.5}}, 0.25, 2);
    CHECK(field.at(o) == 0.5);
    CHECK(field.at({0, 0, 3}) == Approx(0.5 + 0.25 * 3));
    CHECK(field.at({0, 0, -7}) == 2);  // 0.5 + 7/4 is above the overall size
    const bool long_one = std::find(corners.begin(), corners.end(), x) != corners.end();
    CHECK(field.at({3, 0, 1}) == Approx(0.5 + 0.25 * (long_one ? 1 : std::sqrt(10.0))));
  }
  const SizeField triangle({{{o, x, y}, 0.5}}, 0.25, kInfinity);
  CHECK(triangle.at({1, 1, -2}) == Approx(1));
  CHECK(triangle.at({4, 4, 0}) == Approx(0.5 + 0.25 * std::sqrt(8.0)));  // from the middle of its long side
}

TEST_CASE("a field of sizes is the least bid of all sources, and as steep as they may grow", "[size]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1), length(0.01, 0.2), small(-0.1, 0.1);
  for (const std::size_t count : {1u, 3u, 5u, 40u}) {
    std::vector<SizeField::Source> sources(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Vector a{place(random), place(random), place(random)};
      sources[i] = {{a, a, a}, length(random)};
      for (std::size_t k = 0; k < 3; ++k) {
        if (i % 3 > 0) sources[i].corners[1][k] += small(random);
        if (i % 3 > 1) sources[i].corners[2][k] += small(random);
      }
    }
    const SizeField field(sources, 0.3, 0.6);
    Vector last{};
    for (int n = 0; n < 60; ++n) {
      const Vector p{2 * place(random), 2 * place(random), 2 * place(random)};
      double wanted = 0.6;
      for (const auto& s : sources) wanted = std::min(wanted, s.size + 0.3 * far_from(p, s.corners));
      CHECK(field.at(p) == Approx(wanted).margin(1e-6));
      CHECK(std::abs(field.at(p) - field.at(last)) <= 0.3 * far(p, last) + 1e-12);
      last = p;
    }
  }
}

TEST_CASE("threads may ask one field of sizes", "[size]") {
  std::vector<SizeField::Source> sources;
  for (int i = 0; i < 1000; ++i) {
    const Vector a{double(i % 10), double(i / 10 % 10), double(i / 100)};
    sources.push_back({{a, a, a}, 0.1});
  }
  const SizeField field(sources, 0.5, kInfinity);
  std::array<double, 4> sums{};
  std::vector<std::thread> threads;
  for (double& sum : sums) {
    threads.emplace_back([&field, &sum] {
      for (int i = 0; i < 5000; ++i) sum += field.at({i % 97 * 0.1, i % 89 * 0.1, i % 83 * 0.1});
    });
  }
  for (auto& thread : threads) thread.join();
  double alone = 0;
  for (int i = 0; i < 5000; ++i) alone += field.at({i % 97 * 0.1, i % 89 * 0.1, i % 83 * 0.1});
  for (const double sum : sums) CHECK(sum == alone);
}

TEST_CASE("a field of sizes refuses what is no length", "[size]") {
  const Vector o{0, 0, 0};
  CHECK_THROWS_AS(SizeField({}, 0, 1), InputError);
  CHECK_THROWS_AS(SizeField({}, kInfinity, 1), InputError);
  CHECK_THROWS_AS(SizeField({}, 0.3, 0), InputError);
  CHECK_THROWS_AS(SizeField({{{o, o, o}, 0}}, 0.3, 1), InputError);
  CHECK_THROWS_AS(SizeField({{{o, o, o}, kInfinity}}, 0.3, 1), InputError);
  CHECK_THROWS_AS(SizeField({{{o, o, {0, 0, std::nan("")}}, 1}}, 0.3, 1), InputError);
}
