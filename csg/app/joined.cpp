#include "csg/app/joined.h"

#include "csg/app/evaluation.h"
#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/result/join.h"

namespace cnrg::app {

Result joined(const Tree& tree, NodeId node, const Result& result, const std::string& distance, bool quiet) {
  constexpr std::size_t kToldPairs = 20;
  const Rational within = *parse_rational(distance);
  JoinReport report;
  ProgressBar bar(quiet);
  Result out = at_node(tree, node, [&] { return join(result, within, &report, {bar.progress(), {}}); });
  bar.clear();
  const std::string of = tree.file + ": ", name = "`" + tree.nodes[node].name + "`: ";
  if (!quiet) {
    tell(of + "notice: " + name + report.text(within));
    for (std::size_t i = 0; i < std::min(report.merged.size(), kToldPairs); ++i)
      tell(of + "notice: " + name + report.merged[i]);
    if (report.merged.size() > kToldPairs) {
      tell(of + "notice: " + name + std::to_string(report.merged.size() - kToldPairs) +
           " more pairs; `cnrg check --features " + distance + "` lists what is near");
    }
  }
  for (const std::string& warning : report.warnings(within)) tell(of + "warning: " + name + warning);
  return out;
}

}  // namespace cnrg::app
