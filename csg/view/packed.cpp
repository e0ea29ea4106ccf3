#include "csg/view/packed.h"

#include <zlib.h>

#include <algorithm>
#include <new>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

/// The lowest `size` bytes of each number, whatever the order of bytes of this machine.
template <class Bits>
std::string bytes_of(const std::vector<Bits>& numbers, std::size_t size) {
  std::string bytes;
  bytes.reserve(numbers.size() * size);
  for (const Bits number : numbers) {
    for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(number >> (8 * k) & 0xff);
  }
  return bytes;
}

template <class Bits, class Number>
std::vector<Bits> bits_of(const std::vector<Number>& numbers) {
  std::vector<Bits> bits;
  bits.reserve(numbers.size());
  for (const Number number : numbers) bits.push_back(std::bit_cast<Bits>(number));
  return bits;
}

}  // namespace

std::string base64(std::string_view bytes) {
  static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) : 0u;
  };
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= bytes.size() - i ? kDigits[three >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

std::string packed(const std::vector<std::uint32_t>& numbers) {
  std::vector<std::uint32_t> steps;
  steps.reserve(numbers.size());
  std::uint32_t before = 0, most = 0;
  for (const std::uint32_t number : numbers) {
    const std::uint32_t step = number - before;
    steps.push_back(step >> 31 ? ~(step << 1) : step << 1);
    most = std::max(most, steps.back());
    before = number;
  }
  const std::size_t size = most <= 0xff ? 1 : most <= 0xffff ? 2 : 4;
  return std::to_string(size) + ":" + base64(bytes_of(steps, size));
}

std::string packed(const std::vector<float>& numbers) {
  return "f:" + base64(bytes_of(bits_of<std::uint32_t>(numbers), 4));
}

std::string packed(const std::vector<double>& numbers) {
  return "d:" + base64(bytes_of(bits_of<std::uint64_t>(numbers), 8));
}

std::string compressed(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  const int done = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                             reinterpret_cast<const Bytef*>(text.data()), text.size(), Z_BEST_COMPRESSION);
  if (done == Z_MEM_ERROR) throw std::bad_alloc();
  require(done == Z_OK, "compressed: zlib failed");
  bytes.resize(size);
  return base64(bytes);
}

}  // namespace cnrg
