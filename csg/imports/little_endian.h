// Whole numbers of binary files.
#pragma once

#include <cstdint>
#include <string_view>

namespace cnrg {

/// The `size` bytes from `at` on, which are there; at most 8.
inline std::uint64_t number_of_bytes(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < size; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + (big_endian ? k : size - 1 - k)]);
  return value;
}
/// The least byte first.
inline std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  return number_of_bytes(bytes, at, size, false);
}
/// Of four bytes.
inline std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint32_t>(little_endian(bytes, at, 4));
}

}  // namespace cnrg
