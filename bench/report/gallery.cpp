// gnuplot as a child, and what becomes of its SVG.
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

#include "bench/report/html.h"
#include "bench/report/placeholders.h"
#include "bench/report/plot.h"

extern char** environ;

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

/// A folder that is removed again.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "bench_report_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("no temporary folder for plots: " + std::string(std::strerror(errno)));
    }
    path_ = pattern;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path path(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs gnuplot on a script; its messages go to `messages`.
int run_gnuplot(const fs::path& script, const fs::path& messages) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  std::string program = "gnuplot", file = script.string();
  char* const arguments[] = {program.data(), file.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) throw std::runtime_error("gnuplot was not found; install the package gnuplot-nox");
  if (error != 0) throw std::runtime_error("gnuplot can not be started: " + std::string(std::strerror(error)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error("gnuplot was lost: " + std::string(std::strerror(errno)));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string first_line(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n\t");
  return begin == std::string::npos ? "no message" : text.substr(begin, text.find('\n', begin) - begin);
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
  const Folder folder;
  const auto name_of = [](std::size_t i) { return std::to_string(i) + ".svg"; };
  {
    std::ofstream script(folder.path("script"));
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
      const std::string& text = sheets_[i].script;
      const std::size_t plot = text.rfind("\nplot ") + 1;
      script << text.substr(0, plot) << "set output '" << folder.path(name_of(i)).string() << "'\n"
             << text.substr(plot) << "unset output\n";
    }
    script.close();
    if (!script) throw std::runtime_error("the temporary folder has no room for plots");
  }
  const int status = run_gnuplot(folder.path("script"), folder.path("messages"));
  if (status != 0) {
    throw std::runtime_error("gnuplot failed: " + first_line(read_text(folder.path("messages"))) +
                             "; the package gnuplot-nox in version 5.4 or later is needed");
  }
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    drawings.push_back(for_page(read_text(folder.path(name_of(i))), "p" + std::to_string(i) + "-",
                                sheets_[i].title, sheets_[i].description));
  }
  return drawings;
}

}  // namespace cnrg::bench
