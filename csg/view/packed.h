// Lists of numbers as text: bytes in base64, as few per number as the largest one needs.
//
// A page of a model holds hundreds of thousands of small numbers. Written in digits and commas they are twice as
// long, and a browser takes longer to read them than to draw what they say.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace cnrg {

/// Bytes in base64 (RFC 4648), padded.
std::string base64(std::string_view bytes);

/// `1:`, `2:` or `4:`, then the numbers in base64, so many bytes each, the lowest first.
std::string packed(const std::vector<std::uint32_t>& numbers);
/// `f:` and floats, `d:` and doubles.
std::string packed(const std::vector<float>& numbers);
std::string packed(const std::vector<double>& numbers);

/// The number of each of different values, from 0 in the order in which they come.
template <class Map>
std::uint32_t number_in(Map& known, const typename Map::key_type& value) {
  return known.try_emplace(value, static_cast<std::uint32_t>(known.size())).first->second;
}

}  // namespace cnrg
