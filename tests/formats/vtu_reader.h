// A small parser of our own for the .vtu files that are written: arrays and names.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/catch.h"

namespace cnrg::test {

inline std::string decode(const std::string& text) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    const auto digit = digits.find(c);
    if (digit == std::string::npos) break;
    group = group << 6 | std::uint32_t(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += char(group >> bits & 0xff);
  }
  return bytes;
}

struct Vtu {
  std::string text;

  std::string body(const std::string& name) const {
    const auto tag = text.find("Name=\"" + name + "\"");
    REQUIRE(tag != std::string::npos);
    const auto begin = text.find(">\n", tag) + 2;
    return text.substr(begin, text.find("\n</DataArray>", begin) - begin);
  }
  template <class T>
  std::vector<T> array(const std::string& name) const {
    const std::string bytes = decode(body(name));
    std::uint64_t size;
    std::memcpy(&size, bytes.data(), 8);
    REQUIRE(bytes.size() == 8 + size);
    std::vector<T> values(size / sizeof(T));
    std::memcpy(values.data(), bytes.data() + 8, size);
    return values;
  }
  /// The names of the numbers in a cell array: field data `ARRAY NAME`.
  std::map<int, std::string> names(const std::string& array) const {
    std::map<int, std::string> result;
    const std::string begin = "Name=\"" + array + " ";
    for (std::size_t at = 0; (at = text.find(begin, at)) < text.find("</FieldData>");) {
      at += begin.size();
      std::string name = text.substr(at, text.find('"', at) - at);
      for (const auto& [escape, letter] :
           std::map<std::string, std::string>{{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}}) {
        for (std::size_t k; (k = name.find(escape)) != std::string::npos;) name.replace(k, escape.size(), letter);
      }
      for (std::size_t k = 0; (k = name.find("&amp;", k)) != std::string::npos; ++k) name.replace(k, 5, "&");
      const auto numbers = text.find(">\n", at) + 2;
      std::istringstream in(text.substr(numbers, text.find("\n</DataArray>", numbers) - numbers));
      for (int n; in >> n;) CHECK(result.emplace(n, name).second);
    }
    return result;
  }
};

}  // namespace cnrg::test
