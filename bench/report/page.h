// The parts of the page, in its order; each function gives the HTML of one of them, or an empty text when there is
// nothing to show.
#pragma once

#include <string>
#include <vector>

#include "bench/report/html.h"
#include "bench/report/summary.h"

namespace cnrg::bench {

struct Page {
  const Experiment& experiment;
  const Summary& summary;
  const SystemInfo& system(std::size_t place) const { return experiment.systems[place]; }
  const FamilyInfo& family(std::size_t place) const { return experiment.families[place]; }
  /// The title if it is short, else the name: what tables and plots call the system.
  const std::string& label(std::size_t system) const;
  /// The label after a mark of the system's colour.
  std::string mark(std::size_t system) const;
  /// Those that have rows.
  std::vector<std::size_t> systems() const;
};

/// SVGs, in the order of the summary's lists.
struct Drawings {
  std::string all_distances;
  std::vector<std::string> distances;
  struct Growth {
    std::string time, memory;
  };
  std::vector<Growth> growth;
  std::string time_ratios, memory_ratios;
};
Drawings make_drawings(const Page& page);

// page_verdicts.cpp
std::string verdict_matrix(const Page& page);
std::string verdict_totals(const Page& page);
std::string stage_table(const Page& page);
std::string verdict_meanings();
// page_costs.cpp
std::string distance_section(const Page& page, const Drawings& drawings);
std::string growth_section(const Page& page, const Drawings& drawings);
std::string ratio_section(const Page& page, const Drawings& drawings);
std::string exact_section(const Page& page);
// page_setting.cpp
std::string truth_alarm(const Page& page);
std::string systems_section(const Page& page);
std::string machine_section(const Page& page);
std::string truth_section(const Page& page);
std::string rows_section(const Page& page);
// page_style.cpp
extern const char* const kStyle;
extern const char* const kScript;

/// A heading with its anchor, a sentence on how to read what follows, and the content.
std::string section(const std::string& id, const std::string& heading, const std::string& reading,
                    const std::string& content);
/// `<table class=...>` of a head and rows, which are HTML; the table scrolls by itself if it is too wide.
std::string table(const std::string& head, const std::string& rows, const std::string& attributes = "");
/// Cells of a head; those of numbers are aligned to the right by the class `count`.
struct Head {
  const char* name;
  const char* css = "";
};
std::string heads(const std::vector<Head>& names);
/// Marks and labels of systems in a line.
std::string legend(const Page& page, const std::vector<std::size_t>& systems);

}  // namespace cnrg::bench
