// One object per thread, made when a thread first asks for its own, and kept until the process ends.
//
// A `thread_local` object with a destructor would do, but for one thing: the C library notes the destructor in
// memory of its own, and where there is none left it ends the process. Here that is a std::bad_alloc like any
// other. Threads are those of a pool, so few objects outlive their threads.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

namespace cnrg {

template <class T>
class PerThread {
 public:
  static T& own() {
    thread_local T* mine = nullptr;
    if (mine == nullptr) {
      auto made = std::make_unique<T>();
      std::lock_guard lock(all().mutex);
      all().objects.push_back(std::move(made));
      mine = all().objects.back().get();
    }
    return *mine;
  }

  /// visit(object) for the objects of all threads that have asked, in the order in which they did.
  template <class Visit>
  static void each(const Visit& visit) {
    std::lock_guard lock(all().mutex);
    for (const std::unique_ptr<T>& object : all().objects) visit(*object);
  }

 private:
  struct All {
    std::mutex mutex;
    std::vector<std::unique_ptr<T>> objects;
  };
  static All& all() {
    static All* const instance = new All;  // outlives every thread
    return *instance;
  }
};

}  // namespace cnrg
