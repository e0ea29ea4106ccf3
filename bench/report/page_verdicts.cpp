// Verdicts: by family, in all, by stage, and what they mean.
#include <algorithm>

#include "bench/report/format.h"
#include "bench/report/page.h"

namespace cnrg::bench {
namespace {

/// `same-regularized` for people.
std::string verdict_name(std::size_t verdict) {
  std::string name = to_string(static_cast<Verdict>(verdict));
  std::replace(name.begin(), name.end(), '-', ' ');
  return name;
}

std::string verdict_class(std::size_t verdict) {
  return std::string("v-") + to_string(static_cast<Verdict>(verdict));
}

std::string spoken(const Tally& tally) {
  std::string text;
  for (std::size_t v = 0; v < kVerdicts; ++v) {
    if (tally.counts[v] == 0) continue;
    text += (text.empty() ? "" : ", ") + grouped(tally.counts[v]) + " " + verdict_name(v);
  }
  return text;
}

std::string count_part(std::size_t count, const char* name) {
  return element("span", grouped(count), count == 0 ? "class=\"zero\"" : "class=\"" + std::string(name) + "\"");
}

std::string tally_cell(const Tally& tally) {
  if (tally.runs() == 0) return element("td", "–", "class=\"tally none\"");
  std::string bar;
  for (std::size_t v = 0; v < kVerdicts; ++v) {
    if (tally.counts[v] == 0) continue;
    bar +=
        "<i class=\"" + verdict_class(v) + "\" style=\"flex-grow:" + std::to_string(tally.counts[v]) + "\"></i>";
  }
  const std::size_t unjudged = tally.of(Class::unjudged);
  const std::string counts = count_part(tally.of(Class::exact), "exact") + " / " +
                             count_part(tally.of(Class::right), "right") + " / " +
                             count_part(tally.failures(), "failed") +
                             (unjudged == 0 ? "" : " " + element("span", "/ " + grouped(unjudged) + " ?"));
  return element("td",
                 element("span", bar, "class=\"bar\" role=\"img\" " + attribute("aria-label", spoken(tally))) +
                     element("span", counts, "class=\"counts\""),
                 "class=\"tally\" " + attribute("title", spoken(tally)));
}

std::string system_heads(const Page& page) {
  std::string head;
  for (const std::size_t s : page.systems()) head += element("th", page.mark(s), "scope=\"col\"");
  return head;
}

std::string family_row(const Page& page, const FamilyTally& family) {
  const FamilyInfo& info = page.family(family.family);
  std::string name = element("b", escaped(info.name));
  if (!info.title.empty() && info.title != info.name) name += element("small", escaped(info.title));
  std::string cells =
      element("th", name, "scope=\"row\"") + element("td", grouped(family.problems), "class=\"count\"");
  for (const std::size_t s : page.systems()) cells += tally_cell(family.systems[s]);
  return element("tr", cells) + "\n";
}

std::string verdict_legend(const Tally& used) {
  std::string text;
  for (std::size_t v = 0; v < kVerdicts; ++v) {
    if (used.counts[v] == 0) continue;
    text += element("span", "<i class=\"box " + verdict_class(v) + "\"></i>" + verdict_name(v)) + "\n";
  }
  return element("p", text, "class=\"legend\"") + "\n";
}

Tally sum_of(const std::vector<Tally>& tallies) {
  Tally sum;
  for (const Tally& tally : tallies) sum.add(tally);
  return sum;
}

}  // namespace

std::string verdict_matrix(const Page& page) {
  const Summary& summary = page.summary;
  const std::string span = std::to_string(page.systems().size() + 2);
  std::string rows;
  const FamilyTally* before = nullptr;
  for (const FamilyTally& family : summary.families) {
    if (before == nullptr || before->has_distance != family.has_distance) {
      const char* group = family.has_distance ? "At distances from a degenerate position" : "Without distances";
      rows +=
          element("tr", element("th", group, "scope=\"rowgroup\" colspan=\"" + span + "\""), "class=\"group\"");
    }
    before = &family;
    rows += family_row(page, family);
  }
  std::string total =
      element("th", "All", "scope=\"row\"") + element("td", grouped(summary.problems), "class=\"count\"");
  for (const std::size_t s : page.systems()) total += tally_cell(summary.totals[s]);
  rows += element("tr", total, "class=\"total\"");
  const std::string head = heads({{"family"}, {"problems", "count"}}) + system_heads(page);
  return verdict_legend(sum_of(summary.totals)) + table(head, rows, "class=\"matrix\"");
}

std::string verdict_totals(const Page& page) {
  const Summary& summary = page.summary;
  std::string rows;
  for (std::size_t v = 0; v < kVerdicts; ++v) {
    std::string cells =
        element("th", "<i class=\"box " + verdict_class(v) + "\"></i>" + verdict_name(v), "scope=\"row\"");
    for (const std::size_t s : page.systems()) {
      const std::size_t count = summary.totals[s].counts[v];
      cells += element("td", grouped(count), count == 0 ? "class=\"zero\"" : "");
    }
    rows += element("tr", cells, v == static_cast<std::size_t>(Verdict::wrong) ? "class=\"first-failure\"" : "") +
            "\n";
  }
  const auto line = [&](const char* name, const auto& cell) {
    std::string cells = element("th", name, "scope=\"row\"");
    for (const std::size_t s : page.systems()) cells += element("td", cell(summary.totals[s]));
    rows += element("tr", cells, "class=\"total\"") + "\n";
  };
  line("runs", [](const Tally& t) { return grouped(t.runs()); });
  line("failure rate of the judged",
       [](const Tally& t) { return t.judged() == 0 ? std::string("–") : percent(t.failure_rate()); });
  return table(heads({{"verdict"}}) + system_heads(page), rows, "class=\"numbers\"");
}

std::string stage_table(const Page& page) {
  if (page.summary.stages.empty()) return element("p", "No run failed.");
  const std::string head = heads({{"system"}, {"stage"}, {"failures", "count"}, {"as"}, {"such as"}});
  std::string rows;
  for (std::size_t i = 0; i < page.summary.stages.size(); ++i) {
    const StageTally& stage = page.summary.stages[i];
    const bool first = i == 0 || page.summary.stages[i - 1].system != stage.system;
    std::string example = element("code", escaped(stage.problem));
    if (!stage.message.empty()) example += " " + element("small", escaped(stage.message));
    rows += element("tr",
                    element("th", first ? page.mark(stage.system) : "", "scope=\"row\"") +
                        element("td", escaped(stage.stage)) +
                        element("td", grouped(stage.tally.runs()), "class=\"count\"") +
                        element("td", spoken(stage.tally)) + element("td", example, "class=\"example\""),
                    first ? "class=\"first\"" : "") +
            "\n";
  }
  return table(head, rows, "class=\"list\"");
}

std::string verdict_meanings() {
  constexpr const char* kMeanings[] = {
      "The exact point set, of a system that rounds up to the rounding that it states, each contact once.",
      "The closure of the interior: what the operation makes of lower dimension is missing.",
      "The point set, but edges or vertices at a non-manifold contact are there twice or more. A contact in the "
      "interior of a face is not told apart.",
      "Parts that touch in the exact result do not, or the other way round, for coordinates were rounded.",
      "A surface, wire or point of an operand that the exact result has is missing.",
      "Anything else: volume or surface too much or too little, or no solid at all, and no word of it.",
      "The system says that it can not.",
      "The process ended by itself without a result, by a signal or otherwise.",
      "No result within the limit of time.",
      "No result within the limit of memory.",
      "There is a result, but the exact one could not be had within the limits. No rate counts it."};
  static_assert(std::size(kMeanings) == kVerdicts);
  std::string rows;
  for (std::size_t v = 0; v < kVerdicts; ++v) {
    constexpr const char* kClassNames[] = {
        "same",   "right by another contract", "failed: wrong, unsaid", "failed: says so", "failed: no result",
        "nothing"};
    const auto group = static_cast<std::size_t>(class_of(static_cast<Verdict>(v)));
    rows += element("tr", element("th", "<i class=\"box " + verdict_class(v) + "\"></i>" + verdict_name(v),
                                  "scope=\"row\"") +
                              element("td", kClassNames[group]) + element("td", kMeanings[v])) +
            "\n";
  }
  const std::string head = heads({{"verdict"}, {"counts as"}, {"meaning"}});
  return table(head, rows, "class=\"list\"");
}

}  // namespace cnrg::bench
