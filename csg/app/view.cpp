// `cnrg view`: a page of the tree, shown in a browser if asked for, made again when the tree changes.
#include "csg/text/child.h"

#ifdef CNRG_FORK
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <set>
#include <thread>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/text/escape.h"
#include "csg/text/file.h"
#include "csg/text/input_file.h"
#include "csg/text/table.h"
#include "csg/tree/dag.h"
#include "csg/view/page.h"

namespace cnrg::app {
namespace {

namespace fs = std::filesystem;

/// The bundled page: beside the program, as it is built, or where it is installed.
std::string read_template() {
  std::error_code code;
  const fs::path program = fs::read_symlink("/proc/self/exe", code);
  const fs::path folder = program.parent_path();
  for (const fs::path& place : {folder / "view.html", folder.parent_path() / "share" / "cnrg" / "view.html"}) {
    if (fs::is_regular_file(place, code)) return read_file(place.string());
  }
  throw FileError(
      "`cnrg view` has no page to fill in: it is bundled when cnrg is built where Node.js, npm and the network "
      "are "
      "there; run kernel/install-deps, then `cmake --preset release` and `cmake --build --preset release`, whose "
      "output says what is missing");
}

/// `model.html` for `trees/model.yaml`.
std::string page_of(const ViewArguments& arguments) {
  return arguments.file.empty() ? fs::path(arguments.tree).stem().string() + ".html" : arguments.file;
}

/// What the tree is made of: its file and those that its leaves read, with the times at which they were written.
using Times = std::set<std::pair<std::string, fs::file_time_type>>;
Times times_of(const std::set<std::string>& files) {
  Times out;
  for (const std::string& file : files) {
    std::error_code code;  // of a file that an editor is about to replace
    const fs::file_time_type time = fs::last_write_time(file, code);
    if (!code) out.emplace(file, time);
  }
  return out;
}

/// Makes the page; `files` becomes what it was made of.
void make_page(const ViewArguments& arguments, std::set<std::string>& files) {
  const Tree tree = tree_of(arguments);
  for (const Node& node : tree.nodes) {
    const std::string* const file = node.shape ? file_of(*node.shape) : nullptr;
    if (file != nullptr) files.insert(*file);
  }
  const std::string path = page_of(arguments);
  require_writable({path}, tree);
  const std::string page = read_template();
  EvaluateOptions options;
  options.threads = arguments.threads;
  options.keep_all = true;
  options.proof = asked_proof(arguments.certify, false);
  std::vector<NodeId> roots;
  for (const std::string& name : arguments.nodes) roots.push_back(node_of(tree, name));
  if (roots.empty()) {
    for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) roots.push_back(id);
  } else {
    options.result = roots.front();
  }
  const std::vector<char> below = tree.dag->reachable(roots);
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
    if (below[id.index()]) options.nodes.push_back(id);
  }
  const Evaluation evaluation = evaluate_in_view(tree, options, arguments.quiet);
  if (arguments.certify) require_certain(tree, evaluation, arguments.quiet);
  else tell_uncertain(tree, evaluation, arguments.quiet);
  std::string text;
  {
    ProgressBar bar(arguments.quiet);
    bar.show("page " + path);
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    text = page_text(page, fs::path(tree.file).filename().string(), page_data(tree, evaluation),
                     arguments.watch ? std::to_string(now) : "");
    replace_file(path, text);
  }
  if (arguments.quiet) return;
  std::cout << shown(path) << ": " << options.nodes.size() << (options.nodes.size() == 1 ? " node, " : " nodes, ")
            << grouped((text.size() + 1023) / 1024) << " KB\n"
            << std::flush;
}

#ifdef CNRG_FORK
/// Opens the page as the desktop opens files of its kind.
void open_page(const std::string& path) {
  std::string file = fs::absolute(path).string();
  std::string name = "xdg-open";
  char* const command[] = {name.data(), file.data(), nullptr};
  pid_t child = 0;
  // The opener may speak of its own; only how it ends is of interest.
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  const int refused = posix_spawnp(&child, name.c_str(), &actions, nullptr, command, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  pid_t ended = -1;
  if (refused == 0) {
    do ended = waitpid(child, &status, 0);
    while (ended < 0 && errno == EINTR);
  }
  if (refused == 0 && ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  throw FileError(path + ": was written, but `xdg-open` " + (refused == 0 ? "found no browser" : "is not there") +
                  "; open the file in a browser");
}
#else
void open_page(const std::string& path) {
  throw FileError(path + ": was written, but this system starts no other program; open the file in a browser");
}
#endif

/// Makes the page again whenever a file that it is made of changes, until somebody ends the program.
[[noreturn]] void follow(const ViewArguments& arguments, std::set<std::string> files) {
  tell(arguments.tree + ": notice: watched; end with Ctrl-C");
  for (Times made = times_of(files);;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    Times now = times_of(files);
    if (now == made || now.empty()) continue;
    made = std::move(now);
    try {
      make_page(arguments, files);
    } catch (const InputError& e) {  // somebody is writing; the page stays as it is
      tell_error(e);
    } catch (const FileError& e) {
      tell_error(e);
    }
    for (const auto& [file, time] : times_of(files)) {
      const auto known = [&, &name = file](const auto& entry) { return entry.first == name; };
      if (std::none_of(made.begin(), made.end(), known)) made.emplace(file, time);
    }
  }
}

}  // namespace

int run_view(const ViewArguments& arguments) {
  if (arguments.tree == kStandardInputWord) {
    if (arguments.file.empty())
      throw InputError("cnrg: error: a tree on standard input gives the page no name; add -o FILE.html");
    if (arguments.watch)
      throw InputError("cnrg: error: --watch reads the tree again and again, which standard input cannot be");
  }
  const std::string path = page_of(arguments);
  const std::string extension = extension_of(path);
  if (extension != ".html" && extension != ".htm") {
    throw InputError("cnrg: error: " + path + ": `cnrg view` writes .html; give -o a name that ends so");
  }
  require_no_directory(path);
  std::set<std::string> files{arguments.tree};
  make_page(arguments, files);
  if (arguments.open) open_page(path);
  if (arguments.watch) follow(arguments, files);
  return kDone;
}

}  // namespace cnrg::app
