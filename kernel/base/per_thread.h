// One object per thread, made when a thread first asks for its own; who comes after a thread that has ended gets
// its object, so that there are as many as there ever were threads at a time.
//
// A `thread_local` object with a destructor would do, but for one thing: the C library notes the destructor in
// memory of its own, and where there is none left it ends the process. Here that is a std::bad_alloc like any
// other.
#pragma once

#include <pthread.h>

#include <memory>
#include <mutex>
#include <new>
#include <vector>

namespace cnrg {

template <class T>
class PerThread {
 public:
  static T& own() {
    if (mine_ == nullptr) mine_ = take();
    return *mine_;
  }

  /// visit(object) for all objects, also those that no thread has at the moment, in the order in which they were
  /// made.
  template <class Visit>
  static void each(const Visit& visit) {
    std::lock_guard lock(all().mutex);
    for (const std::unique_ptr<T>& object : all().objects) visit(*object);
  }

 private:
  struct All {
    std::mutex mutex;
    std::vector<std::unique_ptr<T>> objects;
    std::vector<T*> free;  // with room for all of them: a thread that ends needs no memory
    pthread_key_t key{};
    bool has_key = false;
  };
  static All& all() {
    static All* const instance = new All;  // outlives every thread
    return *instance;
  }

  static T* take() {
    All& a = all();
    std::lock_guard lock(a.mutex);
    if (!a.has_key) {
      if (pthread_key_create(&a.key, give_back) != 0) throw std::bad_alloc();
      a.has_key = true;
    }
    if (a.free.empty()) {
      a.free.reserve(a.objects.size() + 1);
      a.objects.push_back(std::make_unique<T>());
      a.free.push_back(a.objects.back().get());
    }
    T* const object = a.free.back();
    if (pthread_setspecific(a.key, object) != 0) throw std::bad_alloc();
    a.free.pop_back();
    return object;
  }

  /// At the end of a thread. Should it ask once more after this, it gets another object.
  static void give_back(void* object) {
    mine_ = nullptr;
    std::lock_guard lock(all().mutex);
    all().free.push_back(static_cast<T*>(object));
  }

  inline static thread_local T* mine_ = nullptr;
};

}  // namespace cnrg
