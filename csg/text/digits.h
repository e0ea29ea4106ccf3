// Numbers as text, for files of millions of them. Pieces of a line are put together beside the text and added to
// it at once; lines are made in blocks on all threads.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace cnrg {

/// The end of a text in the making: `Line(text) << "f " << 1 << ' ' << 0.5 << '\n'`. It is added when this goes.
class Line {
 public:
  explicit Line(std::string& text) : text_(text) {}
  ~Line() noexcept(false) { flush(); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  Line& operator<<(char c) {
    *room(1) = c;
    ++end_;
    return *this;
  }
  Line& operator<<(std::string_view piece) {
    if (piece.size() > kRoom) {
      flush();
      text_ += piece;
    } else {
      end_ = std::copy(piece.begin(), piece.end(), room(piece.size()));
    }
    return *this;
  }
  Line& operator<<(const char* piece) { return *this << std::string_view(piece); }
  Line& operator<<(const std::string& piece) { return *this << std::string_view(piece); }
  Line& operator<<(bool value) { return *this << (value ? "true" : "false"); }
  /// A whole number; of a double the shortest text that reads back as the same, 0 without a sign.
  template <class Number>
  requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool> && !std::is_same_v<Number, char>) Line&
  operator<<(Number number) {
    if constexpr (std::is_floating_point_v<Number>) number = number == 0 ? 0 : number;
    char* const begin = room(kLongest);
    end_ = std::to_chars(begin, begin + kLongest, number).ptr;
    return *this;
  }
  Line& operator+=(const auto& piece) { return *this << piece; }
  Line& operator<<(const std::array<double, 3>& xyz) { return *this << xyz[0] << ' ' << xyz[1] << ' ' << xyz[2]; }

 private:
  static constexpr std::size_t kRoom = 480, kLongest = 24;
  std::string& text_;
  char buffer_[kRoom];
  char* end_ = buffer_;

  char* room(std::size_t size) {
    if (static_cast<std::size_t>(buffer_ + kRoom - end_) < size) flush();
    return end_;
  }
  void flush() {
    char* const end = std::exchange(end_, buffer_);  // nothing is left where memory runs out
    text_.append(buffer_, static_cast<std::size_t>(end - buffer_));
  }
};

inline std::string double_text(double number) {
  std::string text;
  Line(text) << number;
  return text;
}

/// Points as texts, each made once: files say the same coordinates again and again.
class PointTexts {
 public:
  explicit PointTexts(const std::vector<std::array<double, 3>>& points);
  /// `x y z`.
  std::string_view operator[](std::size_t p) const { return {of_[p].text, of_[p].ends[2]}; }
  std::string_view coordinate(std::size_t p, std::size_t k) const {
    const std::size_t begin = k == 0 ? 0 : of_[p].ends[k - 1] + std::size_t{1};
    return {of_[p].text + begin, of_[p].ends[k] - begin};
  }

 private:
  struct Point {
    char text[74];
    std::array<std::uint8_t, 3> ends;
  };
  std::vector<Point> of_;
};

/// `append(text, i)` for each i below `count` at the end of a text, in blocks, whose memory is used again.
template <class Append>
void append_lines(std::string& text, std::size_t count, const Append& append) {
  constexpr std::size_t kBlock = 1024;
  std::array<std::string, 32> blocks;
  for (std::size_t done = 0; done < count; done += blocks.size() * kBlock) {
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
      const std::size_t begin = done + b * kBlock;
      blocks[b].clear();
      for (std::size_t i = begin; i < std::min(count, begin + kBlock); ++i) append(blocks[b], i);
    });
    for (const std::string& block : blocks) text += block;
  }
}

}  // namespace cnrg
