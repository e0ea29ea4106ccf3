// A file of HDF5 that is made in memory, so that it can appear whole or not at all, with the same bytes for the
// same content: no times are kept. Links of a group are found by name; paths are made as they are needed.
//
// Where memory runs out HDF5 may follow null pointers instead of saying so, and no check of ours comes before
// that. So a file is made in a process of its own (csg/text/child.h), and only whole bytes come back.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cnrg {

/// All members throw std::bad_alloc where the library fails: in memory nothing else is lacking.
class Hdf5File {
 public:
  using Sizes = std::vector<std::uint64_t>;
  enum class Kind : std::uint8_t { i8, u8, i32, i64, u64, f64 };

  virtual ~Hdf5File() = default;

  virtual void add_group(const std::string& path) = 0;
  /// Numbers of the kind, as many as the product of `sizes`. `each`: they are arrays of so many (a type of HDF5);
  /// 0: numbers.
  virtual void add(const std::string& path, std::span<const std::int32_t> numbers) = 0;
  virtual void add(const std::string& path, std::span<const std::int64_t> numbers, const Sizes& sizes = {}) = 0;
  virtual void add(const std::string& path, std::span<const std::uint64_t> numbers, const Sizes& sizes = {},
                   std::uint64_t each = 0) = 0;
  virtual void add(const std::string& path, std::span<const double> numbers, const Sizes& sizes = {}) = 0;
  /// Texts of `width` bytes each, filled up with zeros: `opaque`, or else arrays of so many numbers of eight bits.
  virtual void add(const std::string& path, const std::vector<std::string>& texts, std::size_t width,
                   bool opaque) = 0;
  /// A type by name: numbers of a kind, `each` as above, or opaque bytes, or texts by number from 1.
  virtual void add_type(const std::string& path, Kind kind, std::uint64_t each = 0) = 0;
  virtual void add_opaque_type(const std::string& path, std::size_t width) = 0;
  virtual void add_enumeration(const std::string& path, const std::vector<std::string>& names) = 0;

  virtual void set(const std::string& path, const std::string& attribute, Kind kind, std::int64_t value) = 0;
  virtual void set(const std::string& path, const std::string& attribute, double value) = 0;
  virtual void set(const std::string& path, const std::string& attribute, const std::string& value) = 0;
  /// A list of two numbers, and a number of a type that was added.
  virtual void set_pair(const std::string& path, const std::string& attribute,
                        std::array<std::uint64_t, 2> values) = 0;
  virtual void set_of_type(const std::string& path, const std::string& attribute, const std::string& type,
                           int value) = 0;

  /// The whole file; nothing may be added afterwards.
  virtual std::string bytes() = 0;
};

/// The bytes of a file that `make` makes in a child. InputError of `make` comes through. Throws std::bad_alloc
/// where memory runs out, FileError where HDF5 crashes; `format` is for the message.
std::string hdf5_bytes(const std::string& format, const std::function<std::string()>& make);

/// A file with nothing in it yet, by the plug-in `hdf5`.
std::unique_ptr<Hdf5File> new_hdf5_file();

}  // namespace cnrg

extern "C" {
cnrg::Hdf5File* cnrg_hdf5_file();
const char* cnrg_hdf5_version();
}
