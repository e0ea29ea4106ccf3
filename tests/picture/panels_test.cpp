// Panels of `cnrg eval -o picture.svg`: their texts, and their options by place.
#include <regex>

#include "tests/app/program.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

constexpr const char* kPanelTree = R"(cnrg: 1
materials: {clay: {color: "#aa3311"}, sand: {color: "#1133aa"}}
nodes:
  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: clay}
  b: {box: {min: [4, 0, 0], max: [8, 4, 4]}, material: sand}
  both: {union: [a, b], dominance: left}
  all: {complement: both}
result: both
)";

int count_word(const std::string& text, const std::string& word) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++n;
  return n;
}

/// The picture of these arguments.
std::string svg_of_run(const Workshop& w, const std::string& arguments) {
  const Outcome o = w.run("eval t.yaml --quiet -o p.svg " + arguments);
  INFO(arguments << o.err);
  REQUIRE(o.status == 0);
  return w.read("p.svg");
}

}  // namespace

TEST_CASE("several nodes are the panels of a picture, with their names or captions below", "[picture][command]") {
  const Workshop w;
  w.write("t.yaml", kPanelTree);
  const std::string text = svg_of_run(w, "--node a --node both --caption 'the two' --node a --caption ''");
  CHECK(count_word(text, ">a<") == 1);
  CHECK(count_word(text, ">the two<") == 1);
  CHECK(count_word(text, ">both<") == 0);
  CHECK(text.find("aria-label=\"a; the two\"") != std::string::npos);
  CHECK(count_word(svg_of_run(w, ""), "aria-label") == 0);  // one panel needs no name
  CHECK(count_word(svg_of_run(w, "--caption x --node a --node b"), ">x<") == 2);
}

TEST_CASE("an option is for the panels of its place", "[picture][command]") {
  const Workshop w;
  w.write("t.yaml", kPanelTree);
  const auto names = [&](const std::string& arguments) { return count_word(svg_of_run(w, arguments), ">v0<"); };
  CHECK(names("--labels v --node a --node b") == 2);
  CHECK(names("--node a --labels v --node b") == 1);
  CHECK(names("--labels v --node a --labels e --node b") == 1);
  CHECK(names("--labels v --node a --labels '' --node b --labels ''") == 0);
  CHECK(svg_of_run(w, "--labels v,e --labels f") == svg_of_run(w, "--labels f"));
}

TEST_CASE("cameras, cuts and sizes do what they say", "[picture][command]") {
  const Workshop w;
  w.write("t.yaml", kPanelTree);
  const auto width = [&](const std::string& arguments) {
    const std::string text = svg_of_run(w, arguments);
    std::smatch match;
    REQUIRE(std::regex_search(text, match, std::regex("width=\"([0-9]+)\" height=\"([0-9]+)\"")));
    return std::stod(match[1]) / std::stod(match[2]);
  };
  const std::string front = "--camera 0,0 --size 400x400";
  CHECK(width(front) > 1.5);
  CHECK(width("--camera 90,0 --size 400x400") < 1.5);
  CHECK(svg_of_run(w, "--cut y=2") == svg_of_run(w, "--cut 0,3,0,6"));
  CHECK(svg_of_run(w, "--cut y=2") != svg_of_run(w, ""));
  CHECK(svg_of_run(w, "--cut z=1 --node both --cut y=2") == svg_of_run(w, "--node both --cut y=2"));
  CHECK(svg_of_run(w, "--explode 1/2") != svg_of_run(w, ""));
  CHECK(count_word(svg_of_run(w, ""), ">clay<") == 1);
  CHECK(count_word(svg_of_run(w, "--color-by region"), ">clay<") == 0);
}

TEST_CASE("each file has its node if there are as many", "[picture][command]") {
  const Workshop w;
  w.write("t.yaml", kPanelTree);
  const std::string a = svg_of_run(w, "--node a"), b = svg_of_run(w, "--node b");
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
