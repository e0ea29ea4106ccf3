// The page from its parts.
#include "bench/report/page.h"

#include <algorithm>

#include "bench/report/format.h"
#include "bench/report/plot.h"
#include "bench/report/report.h"

namespace cnrg::bench {
namespace {

constexpr std::size_t kShortTitle = 20;  // characters that fit a column's head and beside a plot

/// How many of the exact results an independent system has, too.
std::string confirmed_text(const Summary& summary) {
  for (const TruthCount& truth : summary.truths)
    if (truth.confirmed == "Nef" && truth.problems > 0)
      return ", which Nef polyhedra have, too, in " + grouped(truth.problems) + " problems";
  return "";
}

std::string introduction(const Page& page, const std::string& title) {
  const Summary& summary = page.summary;
  const std::size_t systems = page.systems().size();
  std::string sentence = plural(systems, "system") + (systems == 1 ? " was" : " were") + " given " +
                         plural(summary.problems, "Boolean problem") + " of " + grouped(summary.families.size()) +
                         (summary.families.size() == 1 ? " family" : " families") +
                         ", each in a process of its own, and each result was judged against the exact one" +
                         confirmed_text(summary) + ": " + plural(page.experiment.rows.size(), "run") + ".";
  std::string facts;
  if (page.experiment.machine && !page.experiment.machine->date.empty()) {
    facts = page.experiment.machine->date + ". ";
  }
  return element("h1", escaped(title)) + "\n" + element("p", escaped(facts + sentence), "class=\"lead\"") + "\n";
}

std::string fact_card(const Page& page, const MainFact& fact) {
  std::string card = element("h2", escaped(fact.question)) +
                     element("p", escaped(fact.headline), "class=\"big\"") +
                     element("p", escaped(fact.sentence), "class=\"said\"");
  if (!fact.lines.empty()) {
    std::string head = element("th", "", "scope=\"col\""), rows;
    for (const std::string& column : fact.columns) head += element("th", escaped(column), "scope=\"col\"");
    for (const FactLine& line : fact.lines) {
      std::string cells = element("th", page.mark(line.system), "scope=\"row\"");
      for (const std::string& cell : line.cells) cells += element("td", escaped(cell));
      rows += element("tr", cells, page.summary.ours == line.system ? "class=\"ours\"" : "");
    }
    card += table(head, rows, "class=\"fact\"");
  }
  if (!fact.note.empty()) card += element("p", escaped(fact.note), "class=\"note\"");
  return element("article", card) + "\n";
}

std::string facts(const Page& page) {
  std::string cards;
  for (const MainFact& fact : main_facts(page.experiment, page.summary)) cards += fact_card(page, fact);
  return element("div", "\n" + cards, "class=\"facts\" id=\"facts\"") + "\n";
}

std::string contents(const std::vector<std::pair<std::string, std::string>>& sections) {
  std::string links;
  for (const auto& [id, heading] : sections) {
    links += element("a", escaped(heading), attribute("href", "#" + id)) + "\n";
  }
  return element("nav", "\n" + links, "aria-label=\"Contents\"") + "\n";
}

}  // namespace

const std::string& Page::label(std::size_t place) const {
  const SystemInfo& info = system(place);
  return info.title.empty() || characters(info.title) > kShortTitle ? info.name : info.title;
}

std::string Page::mark(std::size_t place) const {
  const std::string colour = std::to_string(place % kSeriesColours);
  return element("span",
                 "<i class=\"dot\" style=\"background:var(--s" + colour + ")\"></i>" +
                     element("span", escaped(label(place)), attribute("title", system(place).title)),
                 "class=\"mark\"");
}

std::vector<std::size_t> Page::systems() const {
  std::vector<std::size_t> places;
  for (std::size_t s = 0; s < summary.totals.size(); ++s) {
    if (summary.totals[s].runs() > 0) places.push_back(s);
  }
  return places;
}

std::string section(const std::string& id, const std::string& heading, const std::string& reading,
                    const std::string& content) {
  return "<section " + attribute("id", id) + ">\n" + element("h2", escaped(heading)) + "\n" +
         (reading.empty() ? "" : element("p", reading, "class=\"reading\"") + "\n") + content + "\n</section>\n";
}

std::string table(const std::string& head, const std::string& rows, const std::string& attributes) {
  return "<div class=\"wide\">" +
         element("table", element("thead", element("tr", head)) + "\n" + element("tbody", rows) + "\n",
                 attributes) +
         "</div>\n";
}

std::string heads(const std::vector<Head>& names) {
  std::string text;
  for (const Head& head : names) {
    const std::string css = *head.css == '\0' ? "" : " " + attribute("class", head.css);
    text += element("th", escaped(head.name), "scope=\"col\"" + css);
  }
  return text;
}

std::string legend(const Page& page, const std::vector<std::size_t>& systems) {
  std::string marks;
  for (const std::size_t s : systems) marks += element("span", page.mark(s)) + "\n";
  return element("p", marks, "class=\"legend\"") + "\n";
}

std::string report_html(const Experiment& experiment, const Summary& summary, const std::string& title) {
  const Page page{experiment, summary};
  const Drawings drawings = make_drawings(page);
  struct Part {
    const char *id, *heading, *reading;
    std::string content;
  };
  const Part parts[] = {
      {"verdicts", "Verdicts by family",
       "A bar is all runs of a system on a family. Below it: same / right by another contract / failed, and "
       "with a question mark what could not be judged.",
       verdict_matrix(page)},
      {"totals", "Verdicts in numbers", "Runs of each system by verdict, over all families.",
       verdict_totals(page)},
      {"stages", "Where failures happen", "Failures by system and stage, with the first problem of each.",
       stage_table(page)},
      {"distance", "Failures near degeneracy",
       "The part of the runs that fail, against the distance of the operands from the degenerate position: "
       "10<sup>−<i>k</i></sup> of their size, and <em>exact</em> for operands that are in it. Lines along 0 % are "
       "drawn beside each other, so that all are seen. Systems that refuse all operands of a family at the input "
       "have no line there.",
       distance_section(page, drawings)},
      {"growth", "Time and memory against size",
       "Medians over the right runs of each size, on logarithmic axes. Exponents are fitted by least squares to "
       "the "
       "logarithms of the medians, ± their standard error, where a system is right in three sizes or more; "
       "they are also beside the names in the plots.",
       growth_section(page, drawings)},
      {"ratios", "Time and memory beside ours",
       "What a system takes as a multiple of what ours takes, on the n problems that both did right; each counts "
       "once, whatever its size. Boxes are quartiles, lines reach from the least to the most. "
       "<strong>The guarantees are not equal</strong>: they are named beside the numbers.",
       ratio_section(page, drawings)},
      {"exact", "Exact stage of ours", "The part of the predicate calls that went to exact arithmetic.",
       exact_section(page)},
      {"truth", "Truth",
       "The exact results that the verdicts are made with come from the kernel of this project. Independent "
       "systems "
       "computed them, too; where none could, ours is judged by itself.",
       truth_section(page)},
      {"meanings", "What verdicts mean", "", verdict_meanings()},
      {"systems", "Systems", "", systems_section(page)},
      {"machine", "Machine and limits", "", machine_section(page)},
      {"rows-section", "All runs", "", rows_section(page)},
  };
  std::vector<std::pair<std::string, std::string>> headings;
  std::string body;
  for (const Part& part : parts) {
    if (part.content.empty()) continue;
    headings.emplace_back(part.id, part.heading);
    body += section(part.id, part.heading, part.reading, part.content);
  }
  return "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta "
         "charset=\"utf-8\" />\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n"
         "<meta name=\"color-scheme\" content=\"light dark\" />\n" +
         element("title", escaped(title)) + "\n<style>" + kStyle + "</style>\n</head>\n<body>\n<main>\n" +
         introduction(page, title) + truth_alarm(page) + facts(page) + contents(headings) + body +
         "</main>\n<script>//<![CDATA[\n" + kScript + "//]]></script>\n</body>\n</html>\n";
}

}  // namespace cnrg::bench
