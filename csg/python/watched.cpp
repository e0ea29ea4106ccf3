#include "watched.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace cnrg::python {
namespace {

/// What the two threads share.
class Shared {
 public:
  void tell(std::string_view stage, std::size_t done, std::size_t total) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    done_ = done;
    total_ = total;
    news_ = true;
  }
  void end(std::exception_ptr thrown) {
    const std::lock_guard lock(mutex_);
    thrown_ = std::move(thrown);
    ended_ = true;
    wake_.notify_one();
  }
  /// True at the end, false after some time.
  bool wait() {
    std::unique_lock lock(mutex_);
    return wake_.wait_for(lock, std::chrono::milliseconds(50), [&] { return ended_; });
  }
  /// Calls progress(stage, done, total) if there is news.
  void show(const py::object& progress) {
    std::unique_lock lock(mutex_);
    if (!news_) return;
    news_ = false;
    const std::string stage = stage_;
    const std::size_t done = done_, total = total_;
    lock.unlock();  // Python may take its time
    progress(stage, done, total);
  }
  const std::exception_ptr& thrown() const { return thrown_; }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  std::string stage_;
  std::size_t done_ = 0, total_ = 0;
  bool news_ = false, ended_ = false;
  std::exception_ptr thrown_;
};

/// Work that was left: stopped, but not ended yet.
class Left {
 public:
  void add(std::thread worker) {
    const std::lock_guard lock(mutex_);
    workers_.push_back(std::move(worker));
  }
  void join() {
    const py::gil_scoped_release others_run;
    const std::lock_guard lock(mutex_);
    for (std::thread& worker : workers_) worker.join();
    workers_.clear();
  }

 private:
  std::mutex mutex_;
  std::vector<std::thread> workers_;
};

Left& left() {
  static Left* const all = new Left;  // threads may not end before the process does
  return *all;
}

void run(const py::object& progress, std::function<void(const Watch&)> work, bool may_be_left) {
  const auto shared = std::make_shared<Shared>();
  std::stop_source stop;
  Watch watch{.stop = stop.get_token()};
  if (!progress.is_none()) {
    watch.progress = [shared](std::string_view stage, std::size_t done, std::size_t total) {
      shared->tell(stage, done, total);
    };
  }
  std::thread worker;
  try {
    worker = std::thread([shared, watch, work = std::move(work)]() mutable {
      std::exception_ptr thrown;
      try {
        work(watch);
      } catch (...) {
        thrown = std::current_exception();
      }
      work = nullptr;  // frees what it owns before anybody hears of the end
      shared->end(std::move(thrown));
    });
  } catch (const std::system_error& e) {
    throw FileError(std::string("the system gave no thread: ") + e.what() + "; end others, or raise `ulimit -u`");
  }
  std::exception_ptr raised;  // by Python, while it waited
  const auto look = [&] {
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!progress.is_none()) shared->show(progress);
    } catch (...) {
      raised = std::current_exception();
      stop.request_stop();
    }
  };
  constexpr int kPatience = 4;  // looks after a stop
  int looks = 0;
  for (bool ended = false; !ended;) {
    {
      const py::gil_scoped_release others_run;
      ended = shared->wait();
    }
    if (!raised) look();
    if (raised && !ended && may_be_left && ++looks == kPatience) {
      left().add(std::move(worker));
      std::rethrow_exception(raised);
    }
  }
  worker.join();
  if (raised) std::rethrow_exception(raised);
  if (shared->thrown()) std::rethrow_exception(shared->thrown());
}

}  // namespace

void run_watched(const py::object& progress, const std::function<void(const Watch&)>& work) {
  run(progress, work, false);
}

void run_apart(const py::object& progress, std::function<void(const Watch&)> work) {
  run(progress, std::move(work), true);
}

void bind_watched(py::module_&) {
  py::module_::import("atexit").attr("register")(py::cpp_function([] { left().join(); }));
}

}  // namespace cnrg::python
