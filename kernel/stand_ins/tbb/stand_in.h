// What we use of oneTBB, made of std::thread, for the build with the thread sanitizer; with one thread for
// WebAssembly.
//
// The sanitizer knows that two accesses are in order only if it has seen what orders them. Debian's oneTBB is not
// compiled with it, so that handing a task over and waiting for it look like nothing, and each value that a loop
// writes and its caller reads like a race. Here all that orders threads is compiled with the sanitizer: beginning
// and joining a thread, and nothing else. Steps are dealt to the threads in turn,
// whichever is first, so two neighbours that touch the same value are always reported.
//
// A loop inside of a loop runs in its thread, so there are never more than kThreads times the callers.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace tbb {
namespace stand_in {

#ifndef CNRG_STAND_IN_THREADS
#define CNRG_STAND_IN_THREADS 4
#endif
inline constexpr std::size_t kThreads = CNRG_STAND_IN_THREADS;
inline constexpr std::size_t kPieces = 4 * kThreads;  ///< of a loop
inline std::atomic<std::size_t> allowed{kThreads};
inline thread_local bool inside = false;

/// work(i) for each i below n, in threads that take turns. Throws what the first that failed has thrown.
template <class Work>
void run(std::size_t n, const Work& work) {
  const std::size_t threads = inside ? 1 : std::min(n, allowed.load(std::memory_order_relaxed));
  if (threads <= 1) {
    for (std::size_t i = 0; i < n; ++i) work(i);
    return;
  }
  std::mutex failing;
  std::exception_ptr failure;
  const auto take = [&](std::size_t own) {
    inside = true;
    try {
      for (std::size_t i = own; i < n; i += threads) work(i);
    } catch (...) {
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
    }
    inside = false;
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < threads; ++t) others.emplace_back(take, t);
  take(0);
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

/// A number of this thread that no other has ever had.
inline std::uint64_t own_number() {
  static std::atomic<std::uint64_t> next{0};
  thread_local const std::uint64_t number = next.fetch_add(1, std::memory_order_relaxed);
  return number;
}

}  // namespace stand_in

template <class Value>
class blocked_range {
 public:
  blocked_range(Value begin, Value end, std::size_t /*grain*/ = 1) : begin_(begin), end_(end) {}
  Value begin() const { return begin_; }
  Value end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  bool is_divisible() const { return size() > 1; }

  /// Into how many pieces it falls, whatever is worth a thread, and piece i of n.
  std::size_t pieces() const { return std::clamp<std::size_t>(size(), 1, stand_in::kPieces); }
  blocked_range piece(std::size_t i, std::size_t n) const {
    const auto at = [&](std::size_t k) { return static_cast<Value>(begin_ + static_cast<Value>(size() * k / n)); };
    return {at(i), at(i + 1)};
  }

 private:
  Value begin_, end_;
};

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
  if (range.size() == 0) return;
  const std::size_t n = range.pieces();
  stand_in::run(n, [&](std::size_t i) { body(range.piece(i, n)); });
}

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
  if (!(first < last)) return;
  parallel_for(blocked_range<Index>(first, last), [&](const blocked_range<Index>& piece) {
    for (Index i = piece.begin(); i != piece.end(); ++i) body(i);
  });
}

template <class Range, class Value, class Body, class Join>
Value parallel_reduce(const Range& range, const Value& identity, const Body& body, const Join& join) {
  if (range.size() == 0) return identity;
  const std::size_t n = range.pieces();
  std::vector<Value> values(n, identity);
  stand_in::run(n, [&](std::size_t i) { values[i] = body(range.piece(i, n), identity); });
  Value all = std::move(values[0]);
  for (std::size_t i = 1; i < n; ++i) all = join(all, values[i]);
  return all;
}

template <class... Bodies>
void parallel_invoke(const Bodies&... bodies) {
  const std::function<void()> all[] = {std::function<void()>(std::cref(bodies))...};
  stand_in::run(sizeof...(bodies), [&](std::size_t i) { all[i](); });
}

template <class Iterator, class... Before>
void parallel_sort(Iterator begin, Iterator end, const Before&... before) {
  std::sort(begin, end, before...);
}

/// One value per thread that asks for it. A lock in local() would order the threads that meet there and so hide
/// races: the values are a list that only grows, and each thread reads its own.
template <class Value>
class enumerable_thread_specific {
  struct Node {
    std::uint64_t owner;
    Node* next;
    Value value;
  };

 public:
  enumerable_thread_specific() : make_([] { return Value(); }) {}
  template <class Make>
  requires std::is_invocable_r_v<Value, const Make&>
  explicit enumerable_thread_specific(Make make) : make_(std::move(make)) {}
  enumerable_thread_specific(const enumerable_thread_specific&) = delete;
  enumerable_thread_specific& operator=(const enumerable_thread_specific&) = delete;
  ~enumerable_thread_specific() {
    for (Node* node = first_.load(); node;) delete std::exchange(node, node->next);
  }

  Value& local() {
    const std::uint64_t me = stand_in::own_number();
    for (Node* node = first_.load(std::memory_order_acquire); node; node = node->next)
      if (node->owner == me) return node->value;
    Node* mine = new Node{me, first_.load(std::memory_order_relaxed), make_()};
    while (!first_.compare_exchange_weak(mine->next, mine, std::memory_order_release, std::memory_order_relaxed)) {
    }
    return mine->value;
  }

  class iterator {
   public:
    explicit iterator(Node* node) : node_(node) {}
    Value& operator*() const { return node_->value; }
    iterator& operator++() {
      node_ = node_->next;
      return *this;
    }
    bool operator==(const iterator&) const = default;

   private:
    Node* node_;
  };
  iterator begin() { return iterator(first_.load()); }
  iterator end() { return iterator(nullptr); }

 private:
  std::function<Value()> make_;
  std::atomic<Node*> first_{nullptr};
};

class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t threads)
      : before_(stand_in::allowed.exchange(std::min(threads, stand_in::kThreads))) {}
  ~global_control() { stand_in::allowed.store(before_); }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;

 private:
  std::size_t before_;
};

namespace this_task_arena {
template <class Body>
decltype(auto) isolate(const Body& body) {
  return body();
}
}  // namespace this_task_arena

}  // namespace tbb

inline const char* TBB_runtime_version() { return "a stand-in"; }
