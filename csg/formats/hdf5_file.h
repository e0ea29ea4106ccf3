// A file of HDF5 that is made in memory, so that it can appear whole or not at all, with the same bytes for the
// same content: no times are kept. Links of a group are found by name; paths are made as they are needed.
//
// Where memory runs out HDF5 may follow null pointers instead of saying so, and no check of ours comes before
// that. So a file is made in a process of its own (csg/text/child.h), and only whole bytes come back.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace cnrg {

/// All members throw std::bad_alloc where the library fails: in memory nothing else is lacking.
class Hdf5File {
 public:
  using Sizes = std::vector<std::uint64_t>;
  enum class Kind : std::uint8_t { i8, u8, i32, i64, u64, f64, opaque };
  /// Numbers of a kind, or arrays of so many (a type of HDF5); or so many opaque bytes.
  struct Type {
    Kind kind;
    std::uint64_t each = 0;
  };

  virtual ~Hdf5File() = default;

  virtual void add_group(const std::string& path) = 0;
  /// Items of the type, as many as the product of `sizes`.
  virtual void add(const std::string& path, const Type& type, const Sizes& sizes, const void* items) = 0;
  /// Numbers; a list where there are no sizes.
  template <class Number>
  void add(const std::string& path, const std::vector<Number>& numbers, const Sizes& sizes = {}) {
    constexpr Kind kKind = std::is_same_v<Number, std::int32_t>    ? Kind::i32
                           : std::is_same_v<Number, std::int64_t>  ? Kind::i64
                           : std::is_same_v<Number, std::uint64_t> ? Kind::u64
                                                                   : Kind::f64;
    static_assert(kKind != Kind::f64 || std::is_same_v<Number, double>);
    add(path, {kKind}, sizes.empty() ? Sizes{numbers.size()} : sizes, numbers.data());
  }
  /// Texts as items of the type, which are bytes, filled up with zeros.
  void add(const std::string& path, const std::vector<std::string>& texts, const Type& type);
  /// A type by name: as above, or texts by number from 1.
  virtual void add_type(const std::string& path, const Type& type) = 0;
  virtual void add_enumeration(const std::string& path, const std::vector<std::string>& names) = 0;

  virtual void set(const std::string& path, const std::string& attribute, Kind kind, std::int64_t value) = 0;
  virtual void set(const std::string& path, const std::string& attribute, const Type& type, const void* value) = 0;
  virtual void set(const std::string& path, const std::string& attribute, const std::string& value) = 0;
  /// A number of a type that was added.
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
