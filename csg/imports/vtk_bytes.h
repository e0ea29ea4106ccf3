// The bytes of an array in VTK's XML.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cnrg {

struct VtkCoding {
  std::size_t header = 4;   ///< bytes of a number of a header
  bool big_endian = false;  ///< such numbers
  bool compressed = false;  ///< by zlib
};

/// Why bytes are none: `is cut off: ...`, to follow the name of the array.
class VtkBytesFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of the array whose header begins `data`; more may follow. Throws VtkBytesFault, also where
/// more than `most` bytes are packed, before memory is taken for them.
std::string decoded(std::string_view data, bool base64, const VtkCoding& coding, std::size_t most);

}  // namespace cnrg
