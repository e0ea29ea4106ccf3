// A header tells how many bytes come, and a damaged one any number. So no memory is taken for bytes that cannot be
// there: raw ones must be in the file, and zlib makes at most 1032 bytes of one.
#include "csg/imports/vtk_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <vector>

#include "csg/imports/little_endian.h"

namespace cnrg {
namespace {

constexpr const char* kTruncated = "is cut off: the file is truncated, or damaged; write it again";

/// Bytes one after the other, as they are or out of base64.
class Source {
 public:
  Source(std::string_view data, bool base64) : data_(data), base64_(base64) {}

  /// The next n; a fault if there are fewer.
  std::string take(std::size_t n) {
    if (n > left()) throw VtkBytesFault(kTruncated);
    std::string bytes;
    if (!base64_) {
      bytes = data_.substr(at_, n);
      at_ += n;
      return bytes;
    }
    bytes.reserve(n);
    while (bytes.size() < n) {
      if (waiting_.empty()) read_group();
      const std::size_t some = std::min(n - bytes.size(), waiting_.size());
      bytes.append(waiting_, 0, some);
      waiting_.erase(0, some);
    }
    return bytes;
  }
  /// No fewer bytes than there are.
  std::size_t left() const {
    return base64_ ? waiting_.size() + (data_.size() - at_) / 4 * 3 + 3 : data_.size() - at_;
  }

 private:
  std::string_view data_;
  bool base64_;
  std::size_t at_ = 0;
  std::string waiting_;  ///< of the last group of letters

  static int digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
  }

  /// Four letters, up to two of which are padding.
  void read_group() {
    std::uint32_t group = 0;
    std::size_t letters = 0, padding = 0;
    for (; letters + padding < 4; ++at_) {
      if (at_ == data_.size()) throw VtkBytesFault(kTruncated);
      const char c = data_[at_];
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
      if (c == '=' && letters >= 2) {
        ++padding;
        group <<= 6;
        continue;
      }
      const int value = digit(c);
      if (value < 0 || padding > 0)
        throw VtkBytesFault("has letters that are not of base64: write the file again");
      group = group << 6 | static_cast<std::uint32_t>(value);
      ++letters;
    }
    for (std::size_t k = 0; k + 1 < letters; ++k) waiting_ += static_cast<char>(group >> (16 - 8 * k) & 0xff);
  }
};

std::uint64_t header_number(Source& source, const VtkCoding& coding) {
  return number_of_bytes(source.take(coding.header), 0, coding.header, coding.big_endian);
}

void check_size(std::uint64_t blocks, std::uint64_t size, std::uint64_t last, std::size_t most) {
  if (last <= most && (blocks < 2 || size <= (most - last) / (blocks - 1))) return;
  throw VtkBytesFault("has far more bytes than the numbers of points and cells say: correct them");
}

}  // namespace

std::string decoded(std::string_view data, bool base64, const VtkCoding& coding, std::size_t most) {
  Source source(data, base64);
  if (!coding.compressed) return source.take(header_number(source, coding));
  const std::uint64_t blocks = header_number(source, coding);
  if (blocks == 0) return {};
  const std::uint64_t size = header_number(source, coding), last = header_number(source, coding);
  if (blocks > source.left() / coding.header) throw VtkBytesFault(kTruncated);
  check_size(blocks, size, last != 0 ? last : size, most);
  std::vector<std::uint64_t> packed;
  for (std::uint64_t i = 0; i < blocks; ++i) packed.push_back(header_number(source, coding));
  std::string bytes;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t expected = i + 1 == blocks && last != 0 ? last : size;
    const std::string block = source.take(packed[i]);
    if (expected / 1100 > block.size())
      throw VtkBytesFault("has a block that zlib cannot have made: write it again");
    const std::size_t before = bytes.size();
    bytes.resize(before + expected);
    uLongf made = expected;
    const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data() + before), &made,
                                  reinterpret_cast<const Bytef*>(block.data()), block.size());
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status != Z_OK || made != expected)
      throw VtkBytesFault("has a damaged block of zlib: write the file again");
  }
  return bytes;
}

}  // namespace cnrg
