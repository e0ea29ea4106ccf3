#include "tests/campaign/driver/isolated.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace cnrg::campaign {

void enter_child(const Limits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit memory{limits.bytes, limits.bytes};
  ::setrlimit(RLIMIT_AS, &memory);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  std::signal(SIGINT, SIG_IGN);  // of a terminal: the parent decides
  // A crash is for the parent to tell, whatever handlers this process had.
  for (const int number : {SIGTERM, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL}) std::signal(number, SIG_DFL);
}

std::string words_of_end(int status, const Limits& limits) {
  if (WIFEXITED(status)) return "ended with status " + std::to_string(WEXITSTATUS(status));
  const int number = WTERMSIG(status);
  if (number == SIGALRM) return "no answer in " + std::to_string(limits.seconds) + " seconds";
  return "signal " + std::to_string(number) + " (" + strsignal(number) + ")";
}

Outcome judge_isolated(const std::function<std::string()>& compare, const Limits& limits) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    ::close(ends[0]);
    enter_child(limits);
    ::alarm(static_cast<unsigned>(limits.seconds));
    const Outcome outcome = judge(compare);
    std::string record(1, static_cast<char>('0' + static_cast<int>(outcome.verdict)));
    record += outcome.message;
    for (std::size_t done = 0; done < record.size();) {
      const ssize_t n = ::write(ends[1], record.data() + done, record.size() - done);
      if (n <= 0) ::_exit(3);
      done += static_cast<std::size_t>(n);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  std::string record;
  char buffer[4096];
  for (;;) {
    const ssize_t n = ::read(ends[0], buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    record.append(buffer, static_cast<std::size_t>(n));
  }
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || record.empty())
    return {Verdict::wrong, words_of_end(status, limits)};
  return {static_cast<Verdict>(record[0] - '0'), record.substr(1)};
}

}  // namespace cnrg::campaign
