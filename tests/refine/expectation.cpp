#include "tests/refine/expectation.h"

#include <algorithm>

#include "tests/catch.h"
#include "tests/scenes/fixture.h"
#include "tests/scenes/measure.h"
#include "tests/scenes/same_arrays.h"

namespace cnrg::scenes {
namespace {

Rational power_of_two(int exponent) {
  Rational p = 1;
  if (exponent >= 0) mpq_mul_2exp(p.get_mpq_t(), p.get_mpq_t(), static_cast<unsigned>(exponent));
  else mpq_div_2exp(p.get_mpq_t(), p.get_mpq_t(), static_cast<unsigned>(-exponent));
  return p;
}

void check(const Complex& c, const Expected& expected, const Rational& volume_factor) {
  CHECK(c.vertex_count() == expected.vertices);
  CHECK(c.edge_count() == expected.edges);
  CHECK(c.face_count() == expected.faces);
  CHECK(c.region_count == expected.regions);
  std::vector<Rational> scaled = expected.volumes;
  for (Rational& v : scaled) v *= volume_factor;
  CHECK((volumes(c) == scaled));
}

std::vector<Leaf> moved(std::vector<Leaf> leaves, const Motion& motion) {
  for (Leaf& leaf : leaves) apply(motion, leaf);
  return leaves;
}

}  // namespace

std::shared_ptr<const Complex> valid_complex(const std::vector<Leaf>& leaves, const SoupOptions& options,
                                             RefineReport* report, int threads) {
  const auto complex = build_complex(make_soup(leaves, options), {.threads = threads}, report);
  REQUIRE(validate(*complex) == "");
  return complex;
}

std::shared_ptr<const Complex> valid_complex(const std::string& fixture) {
  return valid_complex(parse_fixture(fixture));
}

void expect(const std::vector<Leaf>& leaves, const Expected& expected) {
  const auto built_plain = valid_complex(leaves);
  const Complex& plain = *built_plain;
  {
    INFO("as it is");
    check(plain, expected, 1);
  }
  {
    INFO("points not shared");
    SoupOptions options;
    options.share_points = false;
    check(*valid_complex(leaves, options), expected, 1);
  }
  {
    INFO("in reverse order");
    SoupOptions options;
    options.reverse_faces = true;
    for (std::size_t i = leaves.size(); i > 0; --i) options.order.push_back(i - 1);
    check(*valid_complex(leaves, options), expected, 1);
  }
  for (const int exponent : {900, -900}) {
    INFO("scaled by 2^" << exponent);
    const Rational factor = power_of_two(exponent);
    check(*valid_complex(moved(leaves, Motion::scaling(factor))), expected, factor * factor * factor);
  }
  {
    INFO("turned and moved");
    Motion motion = Motion::rotation(3, 1, -2, 1);
    motion.offset = {Rational(1, 3), -7, Rational(22, 7)};
    check(*valid_complex(moved(leaves, motion)), expected, 1);
  }
  {
    INFO("one thread");
    const auto built_single = valid_complex(leaves, {}, nullptr, 1);
    const Complex& single = *built_single;
    check(single, expected, 1);
    CHECK(same_arrays(plain, single));
  }
}

void expect(const std::string& fixture, const Expected& expected) {
  INFO(fixture);
  expect(parse_fixture(fixture), expected);
}

}  // namespace cnrg::scenes
