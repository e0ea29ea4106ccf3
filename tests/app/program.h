// Runs the built program on trees in a folder of its own.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace cnrg {

struct Outcome {
  int status = -1;
  std::string out, err;
};

inline std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Lines of errors; with each of a file its line may be shown, and a mark below it.
inline std::size_t errors_in(const std::string& text) {
  std::istringstream lines(text);
  std::size_t n = 0;
  for (std::string line; std::getline(lines, line);) n += line.find("error: ") != std::string::npos;
  return n;
}

/// A folder that lives as long as the object; the program runs in it.
class Workshop {
 public:
  Workshop() {
    std::string pattern = (std::filesystem::temp_directory_path() / "cnrg_app_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Workshop() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  std::string read(const std::string& name) const {
    std::ifstream stream(path(name));
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// `arguments` are for the shell.
  Outcome run(const std::string& arguments, const std::string& input = "") const {
    write(".in", input);
    return shell("'" CNRG_PROGRAM "' " + arguments + " <.in >.out 2>.err");
  }
  /// Runs a command of the shell that writes to the files `.out` and `.err`.
  Outcome shell(const std::string& command) const {
    const int status = std::system(("cd '" + folder_.string() + "' && " + command).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(".out"), read(".err")};
  }

 private:
  std::filesystem::path folder_;
};

/// The words of the row that begins with a name.
inline std::vector<std::string> row(const std::string& text, const std::string& name) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    if (!words.empty() && words[0] == name) return words;
  }
  return {};
}

}  // namespace cnrg
