// CGAL's systems with CGAL's assertions on, as a program of their own: code with and without assertions must not
// be linked into one. A sweep calls it for verdicts, and has the same systems without assertions for times.
//
//   bench_asserted evaluate SYSTEM PROBLEM     prints a reply (sweep/answer.h)
//   bench_asserted agrees SYSTEM PROBLEM       PROBLEM ends with a model; prints {"agrees": true} or false
//   bench_asserted compare SYSTEM PROBLEM      PROBLEM is one of sets; prints a reply with `difference`
#include <CGAL/assertions.h>

#include <cstdio>
#include <fstream>
#include <iostream>

#include "bench/peers/built_in.h"
#include "bench/sweep/answer.h"

#ifdef CGAL_NO_ASSERTIONS
#error "bench_asserted has to be compiled with CGAL's assertions"
#endif

namespace cnrg::bench {
namespace {

System asserted_system(const std::string& name) {
  if (name == "nef") return nef_system();
  if (name == "corefinement") return corefinement_system();
  throw std::runtime_error("there is no system '" + name + "' with assertions; there are nef and corefinement");
}

void run(const std::string& work, const std::string& name, const char* path) {
  const System system = asserted_system(name);
  std::ifstream in(path);
  if (!in) throw std::runtime_error(std::string(path) + ": cannot be read");
  if (work == "compare" && system.compare_sets) {
    std::cout << comparison_text(read_set_problem(in), system);
    return;
  }
  const Problem problem = read_problem(in);
  if (work == "evaluate") std::cout << reply_text(problem, system, 0, 0);
  else if (work == "agrees" && system.agrees)
    std::cout << nlohmann::json{{"agrees", system.agrees(problem, read_model(in))}} << '\n';
  else throw std::runtime_error("'" + work + "' is no work of '" + name + "'");
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) try {
  if (argc != 4) throw std::runtime_error("needs evaluate or agrees, a system and a file");
  cnrg::bench::run(argv[1], argv[2], argv[3]);
  return std::cout.flush() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
