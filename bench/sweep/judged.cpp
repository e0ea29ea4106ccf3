#include "bench/sweep/judged.h"

#include <sstream>

#include "bench/sweep/process.h"

namespace cnrg::bench {
namespace {

using Judge = Judgement(const Problem&, const Model&, double);

Judged judged_by(Judge* judge, const std::function<Problem()>& make, const Limits& limits, double rounding,
                 const std::string& model) {
  const auto [reply, reason] = told(limits, [&](std::ostream&) {
    std::istringstream in(model);
    const Judgement j = judge(make(), read_model(in), rounding);
    nlohmann::json out{{"verdict", to_string(j.verdict)}, {"stage", j.stage},   {"message", j.message},
                       {"truth", to_json(j.truth)},       {"excess", j.excess}, {"missing", j.missing},
                       {"duplicates", j.duplicates}};
    if (j.facts) out["facts"] = to_json(*j.facts);
    return out;
  });
  if (!reason.empty()) return {{}, "judging: " + reason};
  const nlohmann::json& head = reply.head;
  Judgement j;
  j.verdict = parse_verdict(head.at("verdict").get<std::string>()).value();
  head.at("stage").get_to(j.stage);
  head.at("message").get_to(j.message);
  const JsonFields in(head, "the judgement");
  j.excess = in.number_or_nan("excess");
  j.missing = in.number_or_nan("missing");
  head.at("duplicates").get_to(j.duplicates);
  j.truth = facts_of_json(head.at("truth").get<std::string>());
  if (head.contains("facts")) j.facts = facts_of_json(head["facts"].get<std::string>());
  return {j, {}};
}

}  // namespace

Judged judged(const std::function<Problem()>& make, const Limits& limits, double rounding,
              const std::string& model) {
  const Judged compared = judged_by(judge, make, limits, rounding, model);
  if (compared.judgement) return compared;
  const Judged by_volume = judged_by(judge_by_volume, make, limits, rounding, model);
  return by_volume.judgement && by_volume.judgement->verdict == Verdict::wrong ? by_volume : compared;
}

}  // namespace cnrg::bench
