// Coordinates in columns: the decimal of so many characters that is nearest to a double.
//
// 17 digits say a double exactly, and with a sign, a point and an exponent they are up to 24 characters. Columns
// of 16 (Nastran) or 20 (Abaqus) hold fewer digits, and a program that reads only the column
// takes 1.2345678901234e-10 cut after the sign of its exponent for another number without a word. So numbers are
// written with as many digits as fit, and what that does to tetrahedra is asked of the numbers as they are read
// back.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "csg/mesh/mesh.h"

namespace cnrg {

enum class Column : std::uint8_t {
  nastran,  ///< 16 characters, always with a point; an exponent may do without its letter, zero before the point
  abaqus    ///< 20 characters
};

struct NarrowNumber {
  std::string text;
  double value = 0;  ///< of the text
};
/// For a finite number: the shortest text that reads back as the same double where it fits, else one with as many
/// digits as do.
NarrowNumber narrow_number(double number, Column column);

/// The points of a mesh as texts. Throws InputError where tetrahedra of the mesh are not proven to be turned right
/// with the numbers that the texts say; `format` begins the message.
std::vector<std::array<std::string, 3>> narrow_points(const Mesh& mesh, Column column, const std::string& format);

}  // namespace cnrg
