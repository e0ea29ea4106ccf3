#include "bench/sweep/schedule.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <deque>
#include <map>
#include <stdexcept>

namespace cnrg::bench {
namespace {

using Clock = std::chrono::steady_clock;

pid_t start(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const pid_t parent = getpid(), pid = fork();
  if (pid < 0) throw std::runtime_error("no process can be started");
  if (pid > 0) return pid;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  execv(argv[0], argv.data());
  _exit(127);
}

class Schedule {
 public:
  Schedule(const std::vector<Unit>& units, int jobs) : jobs_(static_cast<std::size_t>(jobs)) {
    for (const Unit& unit : units)
      if (unit.system == kTruth) waiting_[unit.problem];
    for (const Unit& unit : units) {
      const auto truth = unit.system == kTruth ? waiting_.end() : waiting_.find(unit.problem);
      if (truth == waiting_.end()) ready_.push_back(unit);
      else truth->second.push_back(unit);
      ++left_of_[unit.system];
    }
    progress_.total = units.size();
  }

  bool can_start() const { return !ready_.empty() && running_.size() < jobs_; }
  bool over() const { return ready_.empty() && running_.empty(); }
  Unit next() {
    Unit unit = ready_.front();
    ready_.pop_front();
    return unit;
  }
  void started(pid_t pid, const Unit& unit) { running_[pid] = {unit, Clock::now()}; }

  void ended(pid_t pid, int status) {
    const auto it = running_.find(pid);
    if (it == running_.end()) return;
    const auto [unit, begin] = it->second;
    running_.erase(it);
    spent_[unit.system].first += std::chrono::duration<double>(Clock::now() - begin).count();
    ++spent_[unit.system].second;
    ++progress_.done;
    --left_of_[unit.system];
    if (status != 0) fail({unit, status, false});
    if (unit.system == kTruth) release(unit.problem, status);
  }

  Progress progress() const {
    Progress p = progress_;
    double all = 0;
    std::size_t count = 0;
    for (const auto& [system, spent] : spent_) {
      all += spent.first;
      count += spent.second;
    }
    if (count == 0) return p;
    for (const auto& [system, left] : left_of_) {
      const auto spent = spent_.find(system);
      const double each = spent == spent_.end() ? all / static_cast<double>(count)
                                                : spent->second.first / static_cast<double>(spent->second.second);
      p.seconds_left += each * static_cast<double>(left) / static_cast<double>(jobs_);
    }
    return p;
  }
  std::vector<FailedUnit>& failed() { return failed_; }

 private:
  struct Running {
    Unit unit;
    Clock::time_point begin;
  };
  void fail(const FailedUnit& unit) {
    failed_.push_back(unit);
    ++progress_.failed;
  }
  /// Units that waited go first, so that problems are finished one after the other.
  void release(const std::string& problem, int status) {
    std::vector<Unit>& units = waiting_.at(problem);
    for (auto unit = units.rbegin(); unit != units.rend(); ++unit) {
      if (status == 0) {
        ready_.push_front(*unit);
        continue;
      }
      ++progress_.done;
      --left_of_[unit->system];
      fail({*unit, status, true});
    }
    units.clear();
  }

  std::size_t jobs_;
  std::deque<Unit> ready_;
  std::map<std::string, std::vector<Unit>> waiting_;  // by problem
  std::map<pid_t, Running> running_;
  std::map<std::string, std::pair<double, std::size_t>> spent_;  // by system: seconds of how many units
  std::map<std::string, std::size_t> left_of_;
  std::vector<FailedUnit> failed_;
  Progress progress_;
};

}  // namespace

std::vector<FailedUnit> run_units(const std::vector<Unit>& units, int jobs,
                                  const std::function<std::vector<std::string>(const Unit&)>& arguments,
                                  const std::function<void(const Progress&)>& progress) {
  Schedule schedule(units, jobs);
  progress(schedule.progress());
  while (!schedule.over()) {
    while (schedule.can_start()) {
      const Unit unit = schedule.next();
      schedule.started(start(arguments(unit)), unit);
    }
    int status = 0;
    const pid_t pid = wait(&status);
    if (pid < 0 && errno == EINTR) continue;
    if (pid < 0) throw std::runtime_error("lost a process");
    schedule.ended(pid, WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status));
    progress(schedule.progress());
  }
  return schedule.failed();
}

}  // namespace cnrg::bench
