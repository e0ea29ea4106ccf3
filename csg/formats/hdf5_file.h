// A file of HDF5 that is made in memory, so that it can appear whole or not at all, with the same bytes for the
// same content: no times are kept. Links of a group are found by name; paths are made as they are needed.
//
// Where memory runs out HDF5 may follow null pointers instead of saying so, and no check of ours comes before
// that. So a file is made in a process of its own (csg/text/child.h), and only whole bytes come back.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cnrg {

/// All members throw std::bad_alloc where the library fails: in memory nothing else is lacking.
class Hdf5File {
 public:
  using Sizes = std::vector<std::uint64_t>;
  enum class Kind : std::uint8_t { i8, u8, i32, i64, u64, f64 };

  Hdf5File();
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  void add_group(const std::string& path);
  /// Numbers of the kind, as many as the product of `sizes`. `each`: they are arrays of so many (a type of HDF5);
  /// 0: numbers.
  void add(const std::string& path, std::span<const std::int32_t> numbers);
  void add(const std::string& path, std::span<const std::int64_t> numbers, const Sizes& sizes = {});
  void add(const std::string& path, std::span<const std::uint64_t> numbers, const Sizes& sizes = {},
           std::uint64_t each = 0);
  void add(const std::string& path, std::span<const double> numbers, const Sizes& sizes = {});
  /// Texts of `width` bytes each, filled up with zeros: `opaque`, or else arrays of so many numbers of eight bits.
  void add(const std::string& path, const std::vector<std::string>& texts, std::size_t width, bool opaque);
  /// A type by name: numbers of a kind, `each` as above, or opaque bytes, or texts by number from 1.
  void add_type(const std::string& path, Kind kind, std::uint64_t each = 0);
  void add_opaque_type(const std::string& path, std::size_t width);
  void add_enumeration(const std::string& path, const std::vector<std::string>& names);

  void set(const std::string& path, const std::string& attribute, Kind kind, std::int64_t value);
  void set(const std::string& path, const std::string& attribute, double value);
  void set(const std::string& path, const std::string& attribute, const std::string& value);
  /// A list of two numbers, and a number of a type that was added.
  void set_pair(const std::string& path, const std::string& attribute, std::array<std::uint64_t, 2> values);
  void set_of_type(const std::string& path, const std::string& attribute, const std::string& type, int value);

  /// The whole file; nothing may be added afterwards.
  std::string bytes();

 private:
  std::int64_t file_ = -1;

  void write(const std::string& path, std::int64_t type, const Sizes& sizes, const void* data);
  void set(const std::string& path, const std::string& attribute, std::int64_t type, const void* data);
};

/// The bytes of a file that `make` makes in a child. InputError of `make` comes through. Throws std::bad_alloc
/// where memory runs out, FileError where HDF5 crashes; `format` is for the message.
std::string hdf5_bytes(const std::string& format, const std::function<std::string()>& make);

}  // namespace cnrg
