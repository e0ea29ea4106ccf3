// What memory costs where many leaves meet: twice the leaves, twice the memory, not four times. Each case here
// took memory with the square of its size once.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <functional>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

struct Peak {
  int status = -1;
  double megabytes = 0;
};

/// The program on a tree in a process of its own.
Peak peak_of(const Workshop& shop, const std::string& tree, const std::string& options) {
  shop.write("tree.yaml", tree);
  const pid_t child = fork();
  if (child == 0) {
    const std::string command = "cd '" + shop.path("").string() +
                                "' && exec '" CNRG_PROGRAM "' eval tree.yaml --quiet " + options + " >.out 2>.err";
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  REQUIRE(wait4(child, &status, 0, &usage) == child);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, static_cast<double>(usage.ru_maxrss) / 1024};
}

using Leaf = std::function<std::string(int)>;

std::string operation(const std::string& op, int count, const Leaf& leaf) {
  std::string text = "cnrg: 1\nnodes:\n", operands;
  for (int i = 0; i < count; ++i) {
    const std::string name = "n" + std::to_string(i);
    text += "  " + name + ": {" + leaf(i) + "}\n";
    operands += (i == 0 ? "" : ", ") + name;
  }
  return text + "  all: {" + op + ": [" + operands + "]}\nresult: all\n";
}

std::string box(int i) {
  return "box: {min: [" + std::to_string(i) + ", 0, 0], max: [" + std::to_string(i + 1) + ", 1, 1]}";
}

/// Memory above that of a small tree, at n and at 2n.
void expect_linear(const std::function<std::string(int)>& tree, int n, const std::string& options = "") {
  const Workshop shop;
  const Peak small = peak_of(shop, tree(2), options), one = peak_of(shop, tree(n), options),
             two = peak_of(shop, tree(2 * n), options);
  REQUIRE(small.status == 0);
  REQUIRE(one.status == 0);
  REQUIRE(two.status == 0);
  CAPTURE(small.megabytes, one.megabytes, two.megabytes);
  CHECK(two.megabytes - small.megabytes < 2.5 * (one.megabytes - small.megabytes) + 10);
}

TEST_CASE("a union of boxes in a row takes memory by their number", "[growth]") {
  expect_linear([](int n) { return operation("union", n, box); }, 4000, "-o row.json");
}

TEST_CASE("a union of one node many times takes memory by their number", "[growth]") {
  expect_linear(
      [](int n) {
        std::string operands = "a";
        for (int i = 1; i < n; ++i) operands += ", a";
        return "cnrg: 1\nnodes:\n  a: {" + box(0) + "}\n  all: {union: [" + operands + "]}\nresult: all\n";
      },
      4000);
}

TEST_CASE("many wires at one point take memory by their number", "[growth]") {
  const Leaf wire = [](int i) {
    return "polyline: [[0, 0, 0], [1, " + std::to_string(i) + ", " + std::to_string(i * i) + "]]";
  };
  for (const std::string op : {"union", "sum"}) {
    expect_linear([&](int n) { return operation(op, n, wire); }, 3000);
  }
}

TEST_CASE("a tree of doublings is refused before it takes memory", "[growth]") {
  std::string text = "cnrg: 1\nnodes:\n  n0: {" + box(0) + "}\n";
  for (int i = 1; i <= 40; ++i) {
    const std::string last = "n" + std::to_string(i - 1);
    text += "  n" + std::to_string(i) + ": {union: [" + last + ", {simplify: " + last + ", translate: [" +
            std::to_string(std::int64_t{1} << i) + ", 0, 0]}]}\n";
  }
  const Workshop shop;
  const Peak small = peak_of(shop, operation("union", 2, box), ""),
             peak = peak_of(shop, text + "result: n40\n", "");
  CHECK(peak.status == 2);
  CHECK_THAT(shop.read(".err"), Catch::Contains("unfolds to more than 1000000 instances"));
  CHECK(peak.megabytes < small.megabytes + 50);
}

}  // namespace
}  // namespace cnrg
