#include "bench/sweep/keep.h"

#include <filesystem>
#include <sstream>

#include "bench/cases/face_loops.h"
#include "bench/cases/model_text.h"
#include "bench/sweep/store.h"
#include "csg/text/escape.h"

namespace cnrg::bench {
void keep_tree(const std::string& folder, const Problem& problem, const std::optional<Model>& result,
               const SweepRow& row) {
  std::filesystem::create_directories(folder);
  std::ostringstream out;
  out << "# " << shown(row.command) << "\n# " << row.system << ": " << to_string(row.verdict)
      << "\ncnrg: 1\nnodes:\n";
  std::string before;
  for (std::size_t i = 0; i < problem.operands.size(); ++i) {
    const std::string name = "operand " + std::to_string(i + 1);
    out << "  " << name << ": " << node_text(problem.operands[i]) << '\n';
    if (i == 0) {
      before = name;
      continue;
    }
    const std::string step = i + 1 == problem.operands.size() ? "exact" : "step " + std::to_string(i);
    out << "  " << step << ": {" << to_string(problem.steps[i - 1]) << ": [" << before << ", " << name << "]}\n";
    before = step;
  }
  const bool given = result && !result->empty() && row.facts;  // else it bounds nothing that a tree could say
  if (given) {
    Model model = *result;
    cut_holes(model);
    out << "  given: " << node_text(model) << "\n  missing: {difference: [exact, given]}\n"
        << "  excess: {difference: [given, exact]}\n  differs: {union: [missing, excess]}\n";
  }
  out << "result: " << (given ? "differs" : "exact") << '\n';
  write_whole(folder + "/problem.yaml", out.str());
  write_whole(folder + "/row.json", to_json(row));
}

}  // namespace cnrg::bench
