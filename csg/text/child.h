// Work in a process of its own: libraries that may crash, hang, print, end the process or run out of memory do it
// there, and the caller reads what they made or learns how they ended.
//
// Catching signals instead would leave the caller's memory as the fault left it; a program of its own to start
// would have to be found by whoever links the library. A fork needs neither, and the child has its input already.
//
// Other threads of the caller do not exist in the child, and a lock that one of them held at the fork stays locked
// for ever. So work may use what no other thread can have locked: memory and stdio, which the C library puts in
// order at a fork, and a library that the caller never calls itself. Where somebody else's thread calls it all the
// same, the worst that can happen is a child that waits, and that ends with its time.
#pragma once

// Where the system has no fork the work is done in the process of the caller (child_direct.cpp): what crashes or
// hangs there takes the caller with it, and limits are not kept.
#if __has_include(<sys/wait.h>) && !defined(__EMSCRIPTEN__) && !defined(CNRG_NO_FORK)
#define CNRG_FORK
#endif

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>

namespace cnrg {

/// A nameless file in memory: what the child writes the parent reads.
class MemoryFile {
 public:
  /// `owner` is whose result it is, for messages. FileError if the system refuses.
  explicit MemoryFile(std::string owner);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  int descriptor() const { return descriptor_; }

  void rewind() const;
  /// std::bad_alloc when there is no room.
  void write(const void* data, std::size_t size) const;
  /// InputError at the end of the file: a child that lost its memory may have written anything. FileError if the
  /// system refuses, here and below.
  void read(void* data, std::size_t size) const;
  /// How many bytes follow.
  std::size_t rest() const;
  /// All of it.
  std::string text() const;

  template <class T>
  void write_value(const T& value) const {
    write(&value, sizeof value);
  }
  template <class T>
  T read_value() const {
    T value;
    read(&value, sizeof value);
    return value;
  }
  /// A list, or a text, of numbers or of structures of numbers.
  template <class T>
  void write_list(const T* data, std::size_t n) const {
    write_value(std::uint64_t(n));
    if (n > 0) write(data, n * sizeof(T));
  }
  template <class List>
  void write_list(const List& list) const {
    write_list(list.data(), list.size());
  }
  template <class List>
  void read_list(List& list) const {
    const auto n = read_value<std::uint64_t>();
    if (n > rest() / sizeof(typename List::value_type)) fail();
    list.resize(n);
    if (n > 0) read(list.data(), n * sizeof(typename List::value_type));
  }

 private:
  std::string owner_;
  int descriptor_ = -1;
  // Where there is no fork: what is in it, and where it is read.
  mutable std::string bytes_;
  [[maybe_unused]] mutable std::size_t at_ = 0;
  [[noreturn]] void fail() const;
  [[noreturn]] void fail_by_system() const;
  std::size_t seek(std::ptrdiff_t at, int whence) const;
};

/// What a child may use; 0: no bound of ours. Bounds that the process has already are never raised.
struct ChildLimits {
  std::size_t seconds = 0;  ///< of processor time, which other programs take nothing of
  std::size_t bytes = 0;    ///< of memory, besides what the caller has
};

/// How a child ended.
struct ChildEnd {
  enum class Kind : std::uint8_t {
    done,     ///< `number` is what the work returned
    memory,   ///< it ran out
    time,     ///< it was over
    signal,   ///< `number` is that of the signal
    strange,  ///< an exception, or the library ended the process: `number` is its exit status
  };
  Kind kind = Kind::done;
  int number = 0;
  std::size_t seconds = 0;  ///< of processor time that it had; 0: no bound
  std::string said{};  ///< the last line that it printed, without a program's name in front of a failed assertion
};

/// A number that a child counts up and the caller may read meanwhile.
class SharedCount {
 public:
  SharedCount();  ///< std::bad_alloc when there is no room
  ~SharedCount();
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;
  void add() const { count_->fetch_add(1, std::memory_order_relaxed); }
  std::size_t value() const { return count_->load(std::memory_order_relaxed); }

 private:
  std::atomic<std::size_t>* count_;
  static_assert(std::atomic<std::size_t>::is_always_lock_free);
};

/// Runs `work`, which returns a small number that is not negative, in a child and waits for its end. Never returns
/// in the child. Throws FileError if there is no child to be had; `owner` is for that message. Where a stop is
/// asked for, the child is killed, and Stopped is thrown. `meanwhile`, if there is one, is called now and then
/// while the child works; what it throws ends the child, too.
ChildEnd run_in_child(const std::string& owner, const ChildLimits& limits, const std::function<int()>& work,
                      const std::stop_token& stop = {}, const std::function<void()>& meanwhile = {});

}  // namespace cnrg
