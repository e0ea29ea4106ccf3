// Failures by distance, costs by size, ratios, the exact stage.
#include <algorithm>

#include "bench/report/format.h"
#include "bench/report/page.h"

namespace cnrg::bench {
namespace {

std::string figure(const std::string& svg, const std::string& attributes = "") {
  return element("figure", "\n" + svg + "\n", attributes) + "\n";
}

/// None: nullptr.
std::string law_text(const PowerLaw* law) {
  if (law == nullptr) return "–";
  return exponent_text(law->exponent) + " ± " + exponent_text(law->error);
}

std::string fit_title(const PowerLaw* law) {
  if (law == nullptr) return "fewer than three sizes done right";
  char text[60];
  std::snprintf(text, sizeof text, ", r² = %.4f", law->r_squared);
  return plural(law->points, "size") + text;
}

std::string exponent_table(const Page& page, const char* caption, std::optional<PowerLaw> GrowthCurve::*law) {
  std::string head = heads({{caption}});
  for (const std::size_t s : page.systems()) head += element("th", page.mark(s), "scope=\"col\"");
  std::string rows;
  for (const GrowthStudy& study : page.summary.growth) {
    std::string cells = element("th", escaped(page.family(study.family).name), "scope=\"row\"");
    for (const std::size_t s : page.systems()) {
      const auto curve = std::find_if(study.curves.begin(), study.curves.end(),
                                      [&](const GrowthCurve& c) { return c.system == s; });
      const PowerLaw* fitted = nullptr;
      if (curve != study.curves.end() && (*curve).*law) fitted = &*((*curve).*law);
      cells += element("td", law_text(fitted),
                       attribute("title", fit_title(fitted)) + (fitted != nullptr ? "" : " class=\"zero\""));
    }
    rows += element("tr", cells) + "\n";
  }
  return table(head, rows, "class=\"numbers\"");
}

std::string spread_cells(const Spread& s) {
  if (s.count == 0) return element("td", "–", "colspan=\"4\" class=\"zero\"");
  return element("td", element("b", three_digits(s.median) + " ×")) +
         element("td", three_digits(s.lower) + "–" + three_digits(s.upper)) +
         element("td", three_digits(s.least) + "–" + three_digits(s.most)) + element("td", grouped(s.count));
}

}  // namespace

std::string distance_section(const Page& page, const Drawings& drawings) {
  if (page.summary.all_distances.curves.empty()) {
    return element("p", "Not enough data: no family with a distance to degeneracy was run.");
  }
  std::vector<std::size_t> systems;
  for (const DistanceCurve& curve : page.summary.all_distances.curves) systems.push_back(curve.system);
  std::string text = figure(drawings.all_distances, "class=\"one\"");
  if (drawings.distances.size() < 2) return text;
  text += element("h3", "By family") + "\n" + legend(page, systems);
  std::string multiples;
  for (const std::string& svg : drawings.distances) multiples += figure(svg);
  return text + element("div", "\n" + multiples, "class=\"three\"");
}

std::string growth_section(const Page& page, const Drawings& drawings) {
  if (page.summary.growth.empty()) {
    return element("p", "Not enough data: no family was run in more than one size.");
  }
  std::string text = exponent_table(page, "exponent of time", &GrowthCurve::time) +
                     exponent_table(page, "exponent of memory", &GrowthCurve::memory);
  for (std::size_t i = 0; i < drawings.growth.size(); ++i) {
    const FamilyInfo& family = page.family(page.summary.growth[i].family);
    std::string heading = escaped(family.name);
    if (!family.title.empty() && family.title != family.name)
      heading += " " + element("small", escaped(family.title));
    text += "<div class=\"keep\">" + element("h3", heading);
    const Drawings::Growth& drawing = drawings.growth[i];
    if (drawing.time.empty()) text += element("p", "No system did a problem of this family right.");
    else {
      text += element("div", figure(drawing.time) + (drawing.memory.empty() ? "" : figure(drawing.memory)),
                      "class=\"two\"");
    }
    text += "</div>\n";
  }
  return text;
}

std::string ratio_section(const Page& page, const Drawings& drawings) {
  const Summary& summary = page.summary;
  if (!summary.ours) return element("p", "There are no runs of ours.");
  if (summary.ratios.empty()) {
    return element("p", "Not enough data: no problem was done right by ours and by another system.");
  }
  std::string rows;
  for (const Ratio& ratio : summary.ratios) {
    rows += element("tr", element("th", page.mark(ratio.system), "scope=\"row\"") + spread_cells(ratio.time) +
                              spread_cells(ratio.memory) +
                              element("td", escaped(page.system(ratio.system).guarantee), "class=\"text\"")) +
            "\n";
  }
  rows += element("tr",
                  element("th", page.mark(*summary.ours), "scope=\"row\"") +
                      element("td", "1, by definition", "colspan=\"8\" class=\"defined\"") +
                      element("td", escaped(page.system(*summary.ours).guarantee), "class=\"text\""),
                  "class=\"total\"");
  const std::string head = heads({{""},
                                  {"time, median"},
                                  {"quartiles"},
                                  {"least–most"},
                                  {"n"},
                                  {"memory, median"},
                                  {"quartiles"},
                                  {"least–most"},
                                  {"n"},
                                  {"guarantee", "text"}});
  std::string figures;
  for (const std::string* svg : {&drawings.time_ratios, &drawings.memory_ratios}) {
    if (!svg->empty()) figures += figure(*svg);
  }
  return element("div", figures, "class=\"two\"") + table(head, rows, "class=\"numbers ratios\"");
}

std::string exact_section(const Page& page) {
  const Summary& summary = page.summary;
  if (!summary.exact_share) return element("p", "Not enough data: no run of ours says it.");
  std::string rows;
  const auto add = [&](const std::string& name, const ExactShare& share, const char* attributes) {
    rows += element("tr",
                    element("th", escaped(name), "scope=\"row\"") + element("td", grouped(share.runs)) +
                        element("td", percent(share.median)) + element("td", percent(share.most)),
                    attributes) +
            "\n";
  };
  for (const ExactShare& share : summary.exact_shares) add(page.family(share.family).name, share, "");
  add("All", *summary.exact_share, "class=\"total\"");
  return table(heads({{"family"}, {"runs"}, {"median"}, {"most"}}), rows, "class=\"numbers narrow\"");
}

}  // namespace cnrg::bench
