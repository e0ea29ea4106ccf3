// Short lists are lists: whatever their length, copied, moved, compared.
#include "kernel/base/short_list.h"

#include <vector>

#include "kernel/base/ids.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using List = ShortList<std::uint32_t, 2>;

std::vector<std::uint32_t> counted(std::uint32_t n) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < n; ++i) out.push_back(i * i);
  return out;
}

template <class A>
bool same(const A& a, const std::vector<std::uint32_t>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

TEST_CASE("a short list grows, is copied and moved", "[short_list]") {
  for (std::uint32_t n = 0; n < 20; ++n) {
    const std::vector<std::uint32_t> values = counted(n);
    List one_by_one;
    for (std::uint32_t v : values) one_by_one.push_back(v);
    List at_once(values.begin(), values.end());
    CHECK(one_by_one == at_once);
    for (std::uint32_t part = 0; part <= n; ++part) {
      List parts(values.begin(), values.begin() + part);
      parts.append(values.begin() + part, values.end());
      CHECK(same(parts, values));
    }
    CHECK(at_once.size() == n);
    CHECK(at_once.empty() == (n == 0));
    const List copy = at_once;
    List moved = std::move(one_by_one);
    CHECK(one_by_one.empty());
    CHECK(same(moved, values));
    moved.push_back(7);
    moved[0] = 8;
    CHECK(same(copy, values));
    CHECK(moved.back() == (n == 0 ? 8u : 7u));
    moved = copy;
    CHECK(moved == copy);
    one_by_one = List{1, 2, 3};
    CHECK(same(one_by_one, {1, 2, 3}));
  }
}

TEST_CASE("short lists are in lexicographic order", "[short_list]") {
  const std::vector<List> ascending{{}, {0}, {0, 1}, {0, 1, 0}, {0, 2}, {1}, {1, 0, 0, 5}};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    for (std::size_t j = 0; j < ascending.size(); ++j) CHECK((ascending[i] < ascending[j]) == (i < j));
  }
}

TEST_CASE("lists of lists are walked in the order given", "[short_list]") {
  ShortLists<std::uint32_t> lists;
  std::vector<std::vector<std::uint32_t>> expected;
  for (std::uint32_t n = 0; n < 6; ++n) {
    const std::vector<std::uint32_t> a = counted(n), b = counted(6 - n);
    expected.push_back(a);
    expected.back().insert(expected.back().end(), b.begin(), b.end());
    lists.push_back(a, b);
    const ShortLists<std::uint32_t> copy = lists;
    REQUIRE(copy.size() == expected.size());
    std::size_t i = 0;
    for (const auto& list : copy) CHECK(same(list, expected[i++]));
    CHECK(same(copy.front(), expected[0]));
  }
}

}  // namespace
}  // namespace cnrg
