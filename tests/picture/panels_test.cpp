// Panels of `cnrg eval -o picture.svg`: their texts, and their options by place.
#include <regex>

#include "tests/app/program.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

constexpr const char* kTree = R"(cnrg: 1
materials: {clay: {color: "#aa3311"}, sand: {color: "#1133aa"}}
nodes:
  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: clay}
  b: {box: {min: [4, 0, 0], max: [8, 4, 4]}, material: sand}
  both: {union: [a, b], dominance: left}
  all: {complement: both}
result: both
)";

int count(const std::string& text, const std::string& word) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++n;
  return n;
}

/// The picture of these arguments.
std::string svg(const Workshop& w, const std::string& arguments) {
  const Outcome o = w.run("eval t.yaml --quiet -o p.svg " + arguments);
  INFO(arguments << o.err);
  REQUIRE(o.status == 0);
  return w.read("p.svg");
}

}  // namespace

TEST_CASE("several nodes are the panels of a picture, with their names or captions below", "[picture][command]") {
  const Workshop w;
  w.write("t.yaml", kTree);
  const std::string text = svg(w, "--node a --node both --caption 'the two' --node a --caption ''");
  CHECK(count(text, ">a<") == 1);
  CHECK(count(text, ">the two<") == 1);
  CHECK(count(text, ">both<") == 0);
  CHECK(text.find("aria-label=\"a; the two\"") != std::string::npos);
  CHECK(count(svg(w, ""), "aria-label") == 0);  // one panel needs no name
  CHECK(count(svg(w, "--caption x --node a --node b"), ">x<") == 2);
}

TEST_CASE("an option is for the panels of its place", "[picture][command]") {
  const Workshop w;
  w.write("t.yaml", kTree);
  const auto names = [&](const std::string& arguments) { return count(svg(w, arguments), ">v0<"); };
  CHECK(names("--labels v --node a --node b") == 2);
  CHECK(names("--node a --labels v --node b") == 1);
  CHECK(names("--labels v --node a --labels e --node b") == 1);
  CHECK(names("--labels v --node a --labels '' --node b --labels ''") == 0);
  CHECK(svg(w, "--labels v,e --labels f") == svg(w, "--labels f"));
}

TEST_CASE("cameras, cuts and sizes do what they say", "[picture][command]") {
  const Workshop w;
  w.write("t.yaml", kTree);
  const auto width = [&](const std::string& arguments) {
    const std::string text = svg(w, arguments);
    std::smatch match;
    REQUIRE(std::regex_search(text, match, std::regex("width=\"([0-9]+)\" height=\"([0-9]+)\"")));
    return std::stod(match[1]) / std::stod(match[2]);
  };
  const std::string front = "--camera 0,0 --size 400x400";
  CHECK(width(front) > 1.5);
  CHECK(width("--camera 90,0 --size 400x400") < 1.5);
  CHECK(svg(w, "--cut y=2") == svg(w, "--cut 0,3,0,6"));
  CHECK(svg(w, "--cut y=2") != svg(w, ""));
  CHECK(svg(w, "--cut z=1 --node both --cut y=2") == svg(w, "--node both --cut y=2"));
  CHECK(svg(w, "--explode 1/2") != svg(w, ""));
  CHECK(count(svg(w, ""), ">clay<") == 1);
  CHECK(count(svg(w, "--color-by region"), ">clay<") == 0);
}

TEST_CASE("each file has its node if there are as many", "[picture][command]") {
  const Workshop w;
  w.write("t.yaml", kTree);
  const std::string a = svg(w, "--node a"), b = svg(w, "--node b");
  REQUIRE(w.run("eval t.yaml --quiet --node a -o 1.svg --node b -o 2.svg").status == 0);
  CHECK(w.read("1.svg") == a);
  CHECK(w.read("2.svg") == b);
  REQUIRE(w.run("eval t.yaml --quiet --node a --node b -o 3.vtu -o 4.svg").status == 0);
  CHECK(w.read("4.svg") == b);
  REQUIRE(w.run("eval t.yaml --quiet --threads 1 -o 5.pdf -o 5.png").status == 0);
  REQUIRE(w.run("eval t.yaml --quiet --threads 4 -o 6.pdf -o 6.png").status == 0);
  CHECK(w.read("5.pdf") == w.read("6.pdf"));
  CHECK(w.read("5.png") == w.read("6.png"));
}
