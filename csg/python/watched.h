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
/// signal raises (KeyboardInterrupt), stops the work and comes out here when that has ended.
void run_watched(const py::object& progress, const std::function<void(const Watch&)>& work);

/// The same, but Ctrl-C does not wait for the work to end: between two looks at its Watch it may take seconds. So
/// it must own all that it uses, nothing of Python among that; it is waited for when Python ends.
void run_apart(const py::object& progress, std::function<void(const Watch&)> work);

/// `run_watched` for work with a value.
template <class Work>
auto watched(const py::object& progress, const Work& work) {
  std::optional<decltype(work(std::declval<const Watch&>()))> value;
  run_watched(progress, [&](const Watch& watch) { value.emplace(work(watch)); });
  return std::move(*value);
}

/// `run_apart` for work with a value.
template <class Work>
auto apart(const py::object& progress, Work work) {
  const auto value = std::make_shared<std::optional<decltype(work(std::declval<const Watch&>()))>>();
  run_apart(progress, [value, work](const Watch& watch) mutable { value->emplace(work(watch)); });
  return std::move(**value);
}

/// Python waits for work that was left to end by itself, when it ends.
void bind_watched(py::module_& module);

}  // namespace cnrg::python
