// gnuplot as a child, and what becomes of its SVG.
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

#include "bench/peers/program.h"
#include "bench/report/html.h"
#include "bench/report/placeholders.h"
#include "bench/report/plot.h"

namespace cnrg::bench {
namespace {

std::string read_text(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string first_line(const std::vector<std::string>& lines) {
  for (const std::string& line : lines)
    if (const std::size_t begin = line.find_first_not_of(" \t"); begin != std::string::npos)
      return line.substr(begin);
  return "no message";
}

/// The `svg` element alone, with the page's colours and font, and ids that begin with `prefix`.
std::string for_page(std::string svg, const std::string& prefix, const std::string& title,
                     const std::string& description) {
  const std::size_t begin = svg.find("<svg");
  const std::size_t drawing = svg.find("<g id=\"gnuplot_canvas\">");
  if (begin == std::string::npos || drawing == std::string::npos) {
    throw std::runtime_error("gnuplot wrote no SVG; install the package gnuplot-nox in version 5.4 or later");
  }
  std::smatch box;
  const std::string opening = svg.substr(begin, drawing - begin);
  if (!std::regex_search(opening, box, std::regex("viewBox=\"([^\"]*)\""))) {
    throw std::runtime_error("gnuplot wrote an SVG without a viewBox");
  }
  std::string body = svg.substr(drawing);
  static const std::regex ink("rgb\\( *253, *0, *0\\)"), muted("rgb\\( *253, *0, *1\\)"),
      rule("rgb\\( *253, *0, *2\\)"), series("rgb\\( *254, *0, *([0-9]+)\\)"), font("font-family=\"PAGEFONT\""),
      empty("<g [^>]*>\\s*</g>\\s*"), id("id=(['\"])"), reference("xlink:href='#"),
      filters("<filter[^]*?</filter>\\s*"), blank("\\s*\n\\s*");
  body = std::regex_replace(body, filters, "");
  body = std::regex_replace(body, empty, "");
  body = std::regex_replace(body, ink, "var(--ink)");
  body = std::regex_replace(body, muted, "var(--muted)");
  body = std::regex_replace(body, rule, "var(--rule)");
  body = std::regex_replace(body, series, "var(--s$1)");
  body = std::regex_replace(body, font, "font-family=\"inherit\"");
  body = std::regex_replace(body, id, "id=$1" + prefix);
  body = std::regex_replace(body, reference, "href='#" + prefix);
  body = std::regex_replace(body, blank, "\n");
  const std::string name = prefix + "title";
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + box[1].str() +
         "\" role=\"img\" aria-labelledby=\"" + name + "\">\n<title id=\"" + name + "\">" +
         escaped(title.empty() ? description : title + ". " + description) + "</title>\n" + body;
}

}  // namespace

std::vector<std::string> Gallery::draw() const {
  std::vector<std::string> drawings;
  if (sheets_.empty()) return drawings;
  if (!on_path("gnuplot")) throw std::runtime_error("gnuplot was not found; install the package gnuplot-nox");
  const TemporaryFolder folder;
  const auto name_of = [](std::size_t i) { return std::to_string(i) + ".svg"; };
  {
    std::ofstream script(folder.file("script"));
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
      const std::string& text = sheets_[i].script;
      const std::size_t plot = text.rfind("\nplot ") + 1;
      script << text.substr(0, plot) << "set output '" << folder.file(name_of(i)) << "'\n"
             << text.substr(plot) << "unset output\n";
    }
    script.close();
    if (!script) throw std::runtime_error("the temporary folder has no room for plots");
  }
  const ProgramRun run = run_program({"gnuplot", folder.file("script")}, folder);
  if (!run.succeeded()) {
    throw std::runtime_error("gnuplot failed: " + first_line(run.errors) +
                             "; the package gnuplot-nox in version 5.4 or later is needed");
  }
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    drawings.push_back(for_page(read_text(folder.file(name_of(i))), "p" + std::to_string(i) + "-",
                                sheets_[i].title, sheets_[i].description));
  }
  return drawings;
}

}  // namespace cnrg::bench
