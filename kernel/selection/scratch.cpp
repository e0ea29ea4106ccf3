// Blocks from a size on are mapped, which costs some microseconds, the others cleared.
#include "kernel/selection/scratch.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace cnrg {
namespace {

constexpr std::size_t kMapped = std::size_t(1) << 17;

}  // namespace

ZeroedBlock::ZeroedBlock(std::size_t bytes) : bytes_(bytes == 0 ? 1 : bytes) {
  if (bytes_ < kMapped) {
    data_ = std::calloc(bytes_, 1);
    if (!data_) throw std::bad_alloc();
  } else {
    data_ = ::mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (data_ == MAP_FAILED) throw std::bad_alloc();
  }
}

ZeroedBlock::~ZeroedBlock() {
  if (!data_) return;
  if (bytes_ < kMapped) std::free(data_);
  else ::munmap(data_, bytes_);
}

}  // namespace cnrg
