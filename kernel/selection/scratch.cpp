// A few blocks per thread are kept, the oldest go first. A block of which much was touched is freed: clearing it
// costs about as much as a new one, and it would hold memory that others need.
#include "kernel/selection/scratch.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#include "kernel/base/per_thread.h"

namespace cnrg {
namespace {

constexpr std::size_t kKept = 48;       // blocks; an operator has about twenty at a time
constexpr std::size_t kFewPages = 128;  // blocks up to here are kept in any case

struct FreeBlocks {
  struct Entry {
    std::size_t pages;
    std::byte* data;
  };
  std::vector<Entry> entries;  // oldest first
  FreeBlocks() { entries.reserve(kKept); }
  ~FreeBlocks() {
    for (const Entry& entry : entries) std::free(entry.data);
  }
};

FreeBlocks& free_blocks() { return PerThread<FreeBlocks>::own(); }

}  // namespace

ZeroedBlock::ZeroedBlock(std::size_t bytes) : pages_((bytes + kPage - 1) / kPage) {
  auto& entries = free_blocks().entries;
  const auto it = std::find_if(entries.rbegin(), entries.rend(), [&](const auto& e) { return e.pages == pages_; });
  if (it != entries.rend()) {
    data_ = it->data;
    entries.erase(std::next(it).base());
    return;
  }
  data_ = static_cast<std::byte*>(std::calloc(pages_ * (kPage + 1) + 1, 1));
  if (!data_) throw std::bad_alloc();
}

ZeroedBlock::~ZeroedBlock() {
  if (!data_) return;
  std::byte* touched = data_ + pages_ * kPage;
  const auto count = static_cast<std::size_t>(std::count(touched, touched + pages_, std::byte{1}));
  if (pages_ > kFewPages && count > pages_ / 4) {
    std::free(data_);
    return;
  }
  for (std::size_t i = 0, left = count; left > 0; ++i) {
    if (touched[i] == std::byte{0}) continue;
    std::memset(data_ + i * kPage, 0, kPage);
    touched[i] = std::byte{0};
    --left;
  }
  auto& entries = free_blocks().entries;
  if (entries.size() == kKept) {
    std::free(entries.front().data);
    entries.erase(entries.begin());
  }
  entries.push_back({pages_, data_});
}

}  // namespace cnrg
