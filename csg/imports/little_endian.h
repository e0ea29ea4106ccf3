// Whole numbers of binary files, the least byte first.
#pragma once

#include <cstdint>
#include <string_view>

namespace cnrg {

/// The `size` bytes from `at` on, which are there; at most 8.
inline std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t k = size; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}
/// Of four bytes.
inline std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint32_t>(little_endian(bytes, at, 4));
}

}  // namespace cnrg
