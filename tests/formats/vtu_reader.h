// A small parser of our own for the .vtu files that are written: arrays and tables of names.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

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
  std::vector<std::string> names(const std::string& name) const {
    std::istringstream in(body(name));
    std::vector<std::string> result(1);
    for (int code; in >> code;) {
      if (code == 0) result.emplace_back();
      else result.back() += char(code);
    }
    result.pop_back();
    return result;
  }
};

}  // namespace cnrg::test
