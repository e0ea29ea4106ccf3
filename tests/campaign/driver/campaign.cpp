#include "tests/campaign/driver/campaign.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <deque>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <system_error>

#include "csg/text/file.h"

namespace cnrg::campaign {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t asked_to_end = 0;
void ask_to_end(int) { asked_to_end = 1; }

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

double processor_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A child at work on seeds of one family, or on making one failure smaller.
struct Worker {
  pid_t pid = -1;
  int from = -1;  ///< its end of the pipe
  const Family* family = nullptr;
  bool shrinks = false;
  std::uint64_t seed = 0;   ///< begun and not ended
  bool at_work = false;     ///< on `seed`
  Clock::time_point since;  ///< of the last sign of life
  std::string unread;
};

/// Lines that a batch says: `begin SEED`, then `end VERDICT MESSAGE`; at last `time SECONDS`.
void say(int to, const std::string& line) {
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t n = ::write(to, line.data() + done, line.size() - done);
    if (n <= 0) ::_exit(3);
    done += static_cast<std::size_t>(n);
  }
}

[[noreturn]] void work(int to, const Family& family, std::uint64_t first, std::uint64_t count, double seconds) {
  const double begin = processor_seconds();
  double told = begin;
  for (std::uint64_t seed = first; seed - first < count; ++seed) {
    say(to, "begin " + std::to_string(seed) + "\n");
    const Outcome outcome = family.trial(seed);
    const double now = processor_seconds();
    say(to, "end " + std::to_string(static_cast<int>(outcome.verdict)) + " " + std::to_string(now - told) + " " +
                one_line(outcome.message) + "\n");
    told = now;
    if (now - begin >= seconds) break;
  }
  ::_exit(0);
}

class Campaign {
 public:
  Campaign(const Families& families, const Options& options, State& state, std::ostream& log)
      : families_(families), options_(options), state_(state), log_(log) {
    for (const auto& family : families_) state_.tallies.try_emplace(family->name());
    for (const Failure& f : state_.failures) ++failures_[f.family];
  }

  bool run() {
    save();
    while (!over()) {
      while (workers_.size() < static_cast<std::size_t>(options_.jobs) && start()) {
      }
      listen();
      if (seconds_since(saved_) > 2) save();
    }
    for (Worker& w : workers_) ::kill(w.pid, SIGKILL);
    for (Worker& w : workers_) {
      int status = 0;
      ::waitpid(w.pid, &status, 0);
      ::close(w.from);
    }
    save();
    return asked_to_end == 0;
  }

 private:
  bool over() const {
    if (asked_to_end) return true;
    if (options_.hours && seconds_since(began_) >= *options_.hours * 3600) return true;
    // What fails is made smaller before the end.
    return options_.trials && state_.trials() >= *options_.trials && to_shrink_.empty() && workers_.empty();
  }

  bool busy(const Family& family) const {
    return std::any_of(workers_.begin(), workers_.end(),
                       [&](const Worker& w) { return w.family == &family && !w.shrinks; });
  }

  /// Starts a child, if there is something to do.
  bool start() {
    if (!to_shrink_.empty()) {
      const Failure failure = to_shrink_.front();
      to_shrink_.pop_front();
      spawn(family(failure.family), true, failure.seed, [&](int) {
        ::alarm(static_cast<unsigned>(options_.shrink_seconds));
        write_failure(family(failure.family), failure.seed, failure.outcome, options_, true);
        ::_exit(0);
      });
      return true;
    }
    std::uint64_t left = ~std::uint64_t{0};
    if (options_.trials) {
      const std::uint64_t done = state_.trials();
      if (done >= *options_.trials) return false;
      // Batches that run may end all that is left; one at a time keeps the count.
      left = *options_.trials - done;
      if (!workers_.empty() && left < 10000) return false;
    }
    const Family* next = nullptr;
    const auto had = [&](const Family& f) { return state_.tallies.at(f.name()).seconds / f.share(); };
    for (const auto& f : families_)
      if (!busy(*f) && (next == nullptr || had(*f) < had(*next))) next = f.get();
    if (next == nullptr) return false;
    const std::uint64_t first = state_.tallies.at(next->name()).next;
    spawn(*next, false, first, [&](int to) { work(to, *next, first, left, options_.batch_seconds); });
    return true;
  }

  template <class Body>
  void spawn(const Family& family, bool shrinks, std::uint64_t seed, Body body) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) fail("pipe");
    log_.flush();
    const pid_t child = ::fork();
    if (child < 0) fail("fork");
    if (child == 0) {
      ::close(ends[0]);
      try {
        enter_child(options_.limits);
        body(ends[1]);
      } catch (...) {
      }
      ::_exit(4);
    }
    ::close(ends[1]);
    workers_.push_back({child, ends[0], &family, shrinks, seed, shrinks, Clock::now(), {}});
  }

  /// Waits a moment for what the children say, and for their ends.
  void listen() {
    std::vector<pollfd> polled;
    for (const Worker& w : workers_) polled.push_back({w.from, POLLIN, 0});
    if (::poll(polled.data(), polled.size(), 200) < 0 && errno != EINTR) fail("poll");
    for (std::size_t i = workers_.size(); i-- > 0;) {
      Worker& w = workers_[i];
      bool ended = false;
      if (polled[i].revents != 0) {
        char buffer[65536];
        const ssize_t n = ::read(w.from, buffer, sizeof buffer);
        if (n > 0) {
          w.unread.append(buffer, static_cast<std::size_t>(n));
          hear(w);
        } else if (n == 0) {
          ended = true;
        }
      }
      const int limit = w.shrinks ? options_.shrink_seconds + 5 : options_.limits.seconds;
      const bool late = !ended && seconds_since(w.since) > limit;
      if (late) ::kill(w.pid, SIGKILL);
      if (!ended && !late) continue;
      int status = 0;
      while (::waitpid(w.pid, &status, 0) < 0 && errno == EINTR) {
      }
      ::close(w.from);
      if (!w.shrinks && w.at_work) {
        Tally& tally = state_.tallies.at(w.family->name());
        tally.seconds += seconds_since(w.since);
        const std::string words =
            late ? "no answer in " + std::to_string(limit) + " seconds" : words_of_end(status, options_.limits);
        judged(w, {Verdict::wrong, words});
      }
      workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  void hear(Worker& w) {
    std::size_t begin = 0;
    for (std::size_t end; (end = w.unread.find('\n', begin)) != std::string::npos; begin = end + 1) {
      std::istringstream line(w.unread.substr(begin, end - begin));
      std::string word;
      line >> word;
      w.since = Clock::now();
      if (word == "begin") {
        line >> w.seed;
        w.at_work = true;
      } else {
        int verdict = 0;
        double seconds = 0;
        Outcome outcome;
        line >> verdict >> seconds;
        outcome.verdict = static_cast<Verdict>(verdict);
        std::getline(line >> std::ws, outcome.message);
        outcome.message = from_one_line(outcome.message);
        state_.tallies.at(w.family->name()).seconds += seconds;
        judged(w, outcome);
      }
    }
    w.unread.erase(0, begin);
  }

  void judged(Worker& w, const Outcome& outcome) {
    w.at_work = false;
    Tally& tally = state_.tallies.at(w.family->name());
    tally.add(outcome.verdict);
    tally.next = w.seed + 1;
    if (outcome.verdict != Verdict::wrong && outcome.verdict != Verdict::declined) return;
    const Failure failure{w.family->name(), w.seed, outcome};
    state_.failures.push_back(failure);
    const std::size_t before = failures_[failure.family]++;
    if (before < options_.most_told)
      log_ << failure.family << " " << failure.seed << ": " << name(outcome.verdict) << ": "
           << one_line(outcome.message) << std::endl;
    else if (before == options_.most_told)
      log_ << failure.family << ": more fail; " << options_.state << " lists them" << std::endl;
    if (before < options_.most_shrunk) to_shrink_.push_back(failure);
    save();
  }

  const Family& family(const std::string& name) const {
    for (const auto& f : families_)
      if (f->name() == name) return *f;
    throw std::logic_error("no family " + name);
  }

  void save() {
    replace_file(options_.state, to_text(state_));
    saved_ = Clock::now();
  }

  const Families& families_;
  const Options& options_;
  State& state_;
  std::ostream& log_;
  const Clock::time_point began_ = Clock::now();
  Clock::time_point saved_ = began_;
  std::vector<Worker> workers_;
  std::deque<Failure> to_shrink_;
  std::map<std::string, std::size_t> failures_;  ///< how many there were, by family
};

std::string comment(const std::string& text) {
  std::string out = "# ";
  for (const char c : text) {
    out += c;
    if (c == '\n') out += "# ";
  }
  return out + "\n";
}

}  // namespace

bool run(const Families& families, const Options& options, State& state, std::ostream& log) {
  asked_to_end = 0;
  struct sigaction action {};
  action.sa_handler = ask_to_end;
  struct sigaction old_interrupt {
  }, old_terminate{};
  ::sigaction(SIGINT, &action, &old_interrupt);
  ::sigaction(SIGTERM, &action, &old_terminate);
  const bool whole = Campaign(families, options, state, log).run();
  ::sigaction(SIGINT, &old_interrupt, nullptr);
  ::sigaction(SIGTERM, &old_terminate, nullptr);
  return whole;
}

std::string write_failure(const Family& family, std::uint64_t seed, const Outcome& outcome, const Options& options,
                          bool shrink) {
  std::filesystem::create_directories(options.failures);
  const std::string path = options.failures + "/" + family.name() + "-" + std::to_string(seed) + ".yaml";
  const std::string repeat = "tests/campaign/run --family " + family.name() + " --seed " + std::to_string(seed);
  const auto keep = [&](const Shrunk& least) {
    std::string text = comment(std::string(name(outcome.verdict)) + ": " + outcome.message);
    text += comment("repeat: " + repeat);
    text += comment("what is left of it: " + least.outcome.message);
    replace_file(path, text + least.text);
  };
  // Making the case may be what fails.
  std::string whole;
  judge_isolated([&] { return family.text(seed), std::string(); }, options.limits).verdict == Verdict::right
      ? whole = family.text(seed)
      : whole = "# the case could not be made\n";
  keep({outcome, whole});
  if (shrink) {
    family.shrink(
        seed, [&](const auto& compare) { return judge_isolated(compare, options.limits); }, keep);
  }
  return path;
}

}  // namespace cnrg::campaign
