// Systems without fork: the work runs in this process, and its output is kept in a text.
#include "csg/text/child.h"

#ifndef CNRG_FORK

#include <cstring>
#include <new>

#include "kernel/base/error.h"

namespace cnrg {

MemoryFile::MemoryFile(std::string owner) : owner_(std::move(owner)) {}
MemoryFile::~MemoryFile() = default;
void MemoryFile::rewind() const { at_ = 0; }
void MemoryFile::write(const void* data, std::size_t size) const {
  bytes_.append(static_cast<const char*>(data), size);
  at_ = bytes_.size();
}
void MemoryFile::read(void* data, std::size_t size) const {
  if (size > rest()) fail();
  std::memcpy(data, bytes_.data() + at_, size);
  at_ += size;
}
std::size_t MemoryFile::rest() const { return bytes_.size() - at_; }
std::string MemoryFile::text() const { return bytes_; }
void MemoryFile::fail() const { throw InputError(owner_ + " returned a result that is damaged"); }

SharedCount::SharedCount() : count_(new std::atomic<std::size_t>(0)) {}
SharedCount::~SharedCount() { delete count_; }

ChildEnd run_in_child(const std::string&, const ChildLimits& limits, const std::function<int()>& work,
                      const std::stop_token& stop, const std::function<void()>& meanwhile) {
  ChildEnd end;
  end.seconds = limits.seconds;
  try {
    end.number = work();
  } catch (const std::bad_alloc&) {
    end.kind = ChildEnd::Kind::memory;
  } catch (...) {
    end.kind = ChildEnd::Kind::strange;
  }
  if (stop.stop_requested()) throw Stopped();
  if (meanwhile) meanwhile();
  return end;
}

}  // namespace cnrg

#endif
