#include "csg/text/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "kernel/base/error.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

namespace fs = std::filesystem;

/// A folder that goes at the end.
struct Folder {
  fs::path path;
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "cnrg_file_XXXXXX").string();
    path = mkdtemp(pattern.data());
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path / name).string(); }
  std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(path)) result.insert(entry.path().filename().string());
    return result;
  }
};

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

std::string read(const std::string& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

unsigned mode_of(const std::string& path) {
  struct stat status;
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777 : 0;
}

}  // namespace

TEST_CASE("a file appears whole, in place of an old one or anew", "[file]") {
  const Folder folder;
  const std::string path = folder / "x.json";
  const mode_t before = umask(027);
  replace_file(path, "first");
  CHECK(read(path) == "first");
  CHECK(mode_of(path) == 0640);
  umask(before);
  chmod(path.c_str(), 0604);
  replace_file(path, "second");
  CHECK(read(path) == "second");
  CHECK(mode_of(path) == 0604);
  fs::create_symlink("x.json", folder / "link");
  replace_file(folder / "link", "third");
  CHECK(read(path) == "third");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(folder.names() == std::set<std::string>{"x.json", "link"});
}

TEST_CASE("a file whose writing is stopped is the old one", "[file][stop]") {
  const Folder folder;
  const std::string path = folder / "x.json";
  std::stop_source stop;
  replace_file(path, "old", stop.get_token());
  stop.request_stop();
  CHECK_THROWS_AS(replace_file(path, "new", stop.get_token()), Stopped);
  CHECK(read(path) == "old");
  CHECK_THROWS_AS(replace_file(folder / "other", "", stop.get_token()), Stopped);
  CHECK(folder.names() == std::set<std::string>{"x.json"});
}

TEST_CASE("a draft that does not appear leaves nothing, of either kind", "[file]") {
  for (const Draft::Kind kind : {Draft::Kind::unnamed_if_possible, Draft::Kind::named}) {
    const Folder folder;
    const std::string path = folder / "x.json";
    {
      Draft draft(path, kind);
      draft.write("half");
    }
    CHECK(folder.names().empty());
    {
      Draft draft(path, kind);
      draft.write("whole");
      draft.appear(nullptr);
    }
    CHECK(read(path) == "whole");
    struct stat old;
    REQUIRE(stat(path.c_str(), &old) == 0);
    {
      Draft draft(path, kind);
      draft.write("again");
      draft.appear(&old);
    }
    CHECK(read(path) == "again");
    CHECK(folder.names() == std::set<std::string>{"x.json"});
  }
}

TEST_CASE("a process that is killed while it writes leaves the old file", "[file]") {
  for (const Draft::Kind kind : {Draft::Kind::unnamed_if_possible, Draft::Kind::named}) {
    const Folder folder;
    const std::string path = folder / "x.json";
    write(path, "old");
    const pid_t child = fork();
    if (child == 0) {
      Draft draft(path, kind);
      draft.write("half");
      kill(getpid(), SIGKILL);
    }
    waitpid(child, nullptr, 0);
    if (kind == Draft::Kind::named) CHECK(folder.names().size() == 2);
    CHECK(read(path) == "old");
    replace_file(path, "new");
    CHECK(read(path) == "new");
    if (kind == Draft::Kind::unnamed_if_possible) CHECK(folder.names() == std::set<std::string>{"x.json"});
  }
}

TEST_CASE("a process that is killed at any moment leaves an old file or a new one", "[file]") {
  const Folder folder;
  const std::string path = folder / "x.json";
  const std::string a(300'000, 'a'), b(300'000, 'b');
  replace_file(path, a);
  for (int i = 0; i < 40; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      for (;;) replace_file(path, b), replace_file(path, a);
    }
    usleep(useconds_t(300 * i));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::string content = read(path);
    CHECK((content == a || content == b));
  }
}

TEST_CASE("writers of one file at the same time each write it whole", "[file]") {
  const Folder folder;
  const std::string path = folder / "x.json";
  std::vector<pid_t> children;
  for (const char letter : {'a', 'b', 'c', 'd'}) {
    const pid_t child = fork();
    if (child == 0) {
      try {
        for (int i = 0; i < 50; ++i) {
          const std::string text(20'000, letter);
          replace_file(path, text);
          struct stat old;
          if (stat(path.c_str(), &old) != 0) _exit(2);
          Draft draft(path, Draft::Kind::named);
          draft.write(text);
          draft.appear(&old);
        }
      } catch (const std::exception&) {
        _exit(1);
      }
      _exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = -1;
    waitpid(child, &status, 0);
    CHECK(status == 0);
  }
  const std::string content = read(path);
  CHECK(content == std::string(20'000, content.at(0)));
  CHECK(folder.names() == std::set<std::string>{"x.json"});
}

TEST_CASE("what is no regular file is not replaced", "[file]") {
  const Folder folder;
  CHECK_THROWS_WITH(replace_file(folder.path.string(), ""), Catch::Contains("it is a directory; give the name"));
  CHECK_THROWS_WITH(replace_file(folder / "gone/", ""), Catch::Contains("it is a directory"));
  CHECK_THROWS_AS(replace_file(folder / "gone/x", ""), FileError);
  mkfifo((folder / "pipe").c_str(), 0600);
  CHECK_THROWS_WITH(replace_file(folder / "pipe", ""), Catch::Contains("no regular file"));
}

TEST_CASE("a link to nothing is replaced, and what it names stays nothing", "[file]") {
  const Folder folder;
  fs::create_symlink("nowhere.json", folder / "x.json");
  replace_file(folder / "x.json", "whole");
  CHECK_FALSE(fs::is_symlink(folder / "x.json"));
  CHECK(read(folder / "x.json") == "whole");
  CHECK(folder.names() == std::set<std::string>{"x.json"});
}

TEST_CASE("a link whose end the system does not tell stays a link", "[file]") {
  const Folder folder;
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  CHECK_THROWS_WITH(replace_file(folder / "a", "text"), Catch::Contains("cannot be written: "));
  CHECK(fs::is_symlink(folder / "a"));
  CHECK(folder.names() == std::set<std::string>{"a", "b"});
}
