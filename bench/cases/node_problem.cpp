// The text of a set problem, for programs that compute it.
#include "bench/cases/node_problem.h"

#include <sstream>
#include <stdexcept>

namespace cnrg::bench {
namespace {

void write_set(std::ostream& out, const MarkedSet& set) {
  out << "set " << set.layers.size() << ' ' << set.complement << '\n';
  for (const Model& layer : set.layers) write_model(out, layer);
}

/// The rest of a line that starts with `word`.
std::istringstream words_after(std::istream& in, const std::string& word) {
  std::string line, first;
  std::getline(in, line);
  std::istringstream words(line);
  if (!(words >> first) || first != word) throw std::runtime_error("a line does not start with `" + word + "`");
  return words;
}

MarkedSet read_set(std::istream& in) {
  std::size_t layers = 0;
  MarkedSet set;
  if (!(words_after(in, "set") >> layers >> set.complement)) throw std::runtime_error("a set has no layers");
  for (std::size_t i = 0; i < layers; ++i) set.layers.push_back(read_model(in));
  return set;
}

}  // namespace

void write_set_problem(std::ostream& out, const SetProblem& problem) {
  out << "words";
  for (const std::string& word : problem.words) out << ' ' << word;
  out << "\noperands " << problem.operands.size() << '\n';
  for (const MarkedSet& operand : problem.operands) write_set(out, operand);
  write_set(out, problem.value);
}

SetProblem read_set_problem(std::istream& in) {
  SetProblem problem;
  std::istringstream words = words_after(in, "words");
  for (std::string word; words >> word;) problem.words.push_back(word);
  std::size_t operands = 0;
  if (!(words_after(in, "operands") >> operands)) throw std::runtime_error("operands have no number");
  for (std::size_t i = 0; i < operands; ++i) problem.operands.push_back(read_set(in));
  problem.value = read_set(in);
  return problem;
}

}  // namespace cnrg::bench
