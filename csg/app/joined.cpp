#include "csg/app/joined.h"

#include "csg/app/evaluation.h"
#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/result/join.h"
#include "csg/result/rounding.h"
#include "csg/text/escape.h"

namespace cnrg::app {

Result joined(const Tree& tree, NodeId node, const Result& result, const std::string& distance, bool quiet) {
  constexpr std::size_t kToldPairs = 20;
  const Rational within = *parse_rational(distance);
  JoinReport report;
  ProgressBar bar(quiet);
  bar.show("join");
  Result out = at_node(tree, node, [&] { return join(result, within, &report); });
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
  for (const std::string& region : report.lost_regions)
    tell(of + "warning: " + name + "the region " + region + ", is thinner than " + distance + " and has vanished");
  if (report.remaining > 0) {
    std::string nearest;
    append(nearest, report.nearest);
    tell(of + "warning: " + name + std::to_string(report.remaining) + " pairs are still nearer than " + distance +
         " after " + std::to_string(report.rounds) + " rounds, the nearest " + nearest +
         " apart; give another distance");
  }
  return out;
}

}  // namespace cnrg::app
