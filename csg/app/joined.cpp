#include "csg/app/joined.h"

#include <cmath>

#include "csg/app/evaluation.h"
#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/result/join.h"
#include "csg/text/table.h"

namespace cnrg::app {
namespace {

Rational total_volume(const Result& result) {
  Rational sum = 0;
  for (Component i = 1; i <= result.component_count(); ++i) sum += result.volume(i).value_or(0);
  return sum;
}

/// `the regions have 65 % less volume`: where a distance is too large, that tells more than what met. Empty where
/// it is less than a hundredth.
std::string volume_change_text(const Result& before, const Result& after) {
  const Rational was = total_volume(before);
  if (was == 0) return {};
  const double change = to_double((total_volume(after) - was) / was);
  if (std::abs(change) < 0.01) return {};
  return "the regions have " + decimal(100 * std::abs(change), "%.2g") + " % " + (change < 0 ? "less" : "more") +
         " volume than before; give a smaller distance";
}

}  // namespace

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
  if (report.rounds == 0) return out;
  if (const std::string text = volume_change_text(result, out); !text.empty())
    tell(of + "warning: " + name + text);
  return out;
}

}  // namespace cnrg::app
