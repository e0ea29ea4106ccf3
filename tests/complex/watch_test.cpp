// Refinement that is watched: it tells its stages on the thread that asked, and ends where it is told to.
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "kernel/complex/complex.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

/// n triangles that cross one another.
Soup crossing_triangles(int n) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  for (int i = 0; i < n; ++i) {
    const double s = i * 0.03125, t = 3 - s;
    soup.add_triangle(leaf, soup.add_point(0, s, t), soup.add_point(4, s, t + 0.5), soup.add_point(s, s + 3, s), 0,
                      0);
  }
  return soup;
}

TEST_CASE("the stages of a refinement are told in their order, by the thread that asked", "[watch]") {
  const Soup soup = crossing_triangles(60);
  std::vector<std::string> stages;
  std::map<std::string, std::size_t> last;
  const std::thread::id here = std::this_thread::get_id();
  RefineOptions options;
  options.watch.progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
    CHECK(std::this_thread::get_id() == here);
    CHECK((done <= total || total == 0));
    const std::string name(stage);
    if (stages.empty() || stages.back() != name) stages.push_back(name);
    CHECK(done >= last[name]);
    last[name] = done;
  };
  const auto watched = build_complex(soup, options);
  CHECK(stages == std::vector<std::string>{"refine: input", "refine: contacts", "refine: crossings",
                                           "refine: faces", "refine: cells", "refine: regions"});
  const auto alone = build_complex(soup);
  CHECK(watched->face_count() == alone->face_count());
  CHECK(watched->vertices.size() == alone->vertices.size());
}

TEST_CASE("a refinement can be stopped at each stage", "[watch]") {
  const Soup soup = crossing_triangles(60);
  std::size_t told = 0;
  RefineOptions count;
  count.watch.progress = [&](std::string_view, std::size_t, std::size_t) { ++told; };
  build_complex(soup, count);
  REQUIRE(told >= 6);
  for (std::size_t at = 1; at <= told; ++at) {
    std::stop_source stop;
    std::size_t calls = 0;
    RefineOptions options;
    options.watch.stop = stop.get_token();
    options.watch.progress = [&](std::string_view, std::size_t, std::size_t) {
      if (++calls == at) stop.request_stop();
    };
    // After the last call nothing is left that looks.
    try {
      build_complex(soup, options);
      CHECK(calls < told + 1);
    } catch (const Stopped&) {
      CHECK(calls >= at);
    }
  }
  std::stop_source stop;
  stop.request_stop();
  RefineOptions options;
  options.watch.stop = stop.get_token();
  CHECK_THROWS_AS(build_complex(soup, options), Stopped);
}

TEST_CASE("what a progress throws ends the refinement", "[watch]") {
  const Soup soup = crossing_triangles(20);
  RefineOptions options;
  options.watch.progress = [](std::string_view stage, std::size_t, std::size_t) {
    if (stage == "refine: faces") throw InputError("enough");
  };
  CHECK_THROWS_WITH(build_complex(soup, options), "enough");
}

}  // namespace
}  // namespace cnrg
