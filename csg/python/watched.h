// Long work that Python waits for: others may run Python meanwhile, a progress is told, Ctrl-C ends it.
//
// Python's handlers of signals run on its main thread only, and only while that holds the interpreter's lock. Work
// that kept this thread would be deaf until its end, and work that called Python from its loops would be slow. So
// the work has a thread of its own, without the lock; the thread that called waits, and twenty times a second
// takes the lock, asks for signals, and tells of the progress.
#pragma once

#include <functional>
#include <optional>

#include "bind.h"

namespace cnrg::python {

/// Runs `work` with a Watch that it must obey, and rethrows what it throws. `progress` is None or is called as
/// progress(stage: str, done: int, total: int), total 0 if not known; what it raises, and what a handler of a
/// signal raises (KeyboardInterrupt), stops the work and comes out here.
void run_watched(const py::object& progress, const std::function<void(const Watch&)>& work);

/// The same for work with a value.
template <class Work>
auto watched(const py::object& progress, const Work& work) {
  std::optional<decltype(work(std::declval<const Watch&>()))> value;
  run_watched(progress, [&](const Watch& watch) { value.emplace(work(watch)); });
  return std::move(*value);
}

}  // namespace cnrg::python
