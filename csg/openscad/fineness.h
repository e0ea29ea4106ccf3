// How OpenSCAD (2021.01) divides curves into segments, by `$fn`, `$fa` and `$fs`, and where it puts their corners.
#pragma once

namespace cnrg::openscad {

/// OpenSCAD's unit for corners of solids that take part in a Boolean.
inline constexpr double kFineGrid = 1.0 / (1 << 20);

/// Sine and cosine of degrees: exact at multiples of 30 and 45 where a double is.
double sine(double degrees);
double cosine(double degrees);

struct Fineness {
  double fn = 0, fa = 12, fs = 2;
  /// Segments of a circle.
  int segments(double radius) const;
  /// Layers of an extrusion that turns by `twist` degrees; `radius`: of the farthest corner.
  int helix_layers(double radius, double height, double twist) const;
  /// Of one that also scales alike in x and y.
  int conical_layers(double radius, double height, double twist, double scale) const;
  /// Of one that scales differently in x and y, by which the corner that moves most moves by `shift`.
  int diagonal_layers(double shift, double height) const;

 private:
  bool is_plain(double length) const;
};

}  // namespace cnrg::openscad
