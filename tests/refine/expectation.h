// What a fixture must become, however its numbers, its order and its threads are.
#pragma once

#include <string>
#include <vector>

#include "kernel/complex/complex.h"
#include "tests/scenes/scene.h"

namespace cnrg::scenes {

struct Expected {
  std::size_t vertices = 0, edges = 0, faces = 0, regions = 0;  ///< of the complex; regions with the unbounded one
  std::vector<Rational> volumes{};                              ///< of the bounded regions, ascending
};

/// Builds the complex and requires that it is valid.
std::shared_ptr<const Complex> valid_complex(const std::vector<Leaf>& leaves, const SoupOptions& options = {},
                                             RefineReport* report = nullptr, int threads = 0);
std::shared_ptr<const Complex> valid_complex(const std::string& fixture);

/// Requires counts, volumes and validity of the leaves as they are; with points not shared; faces and leaves in
/// reverse order; scaled by 2^900 and 2^-900; turned by a rational rotation and moved; with one thread.
void expect(const std::vector<Leaf>& leaves, const Expected& expected);
void expect(const std::string& fixture, const Expected& expected);

}  // namespace cnrg::scenes
