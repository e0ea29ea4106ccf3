// Staged predicates: each returns the exact sign of its expression (-1, 0, 1), whatever stage decided.
//
// Stages: semi-static filter on doubles (a proven forward error bound), interval arithmetic, exact integers.
// Antisymmetry and invariance under cyclic exchange hold exactly, since each result is exact.
#pragma once

#include <array>
#include <cstdint>

#include "kernel/exact/points.h"

namespace cnrg {

class PlaneFilter;

/// Sign of det(b-a, c-a, d-a): positive when d lies on the side to which the normal of (a, b, c) points.
int orient3d(const PointView& a, const PointView& b, const PointView& c, const PointView& d);
int orient3d(const PointTable& t, VertexId a, VertexId b, VertexId c, VertexId d);
/// The same of points in no table, of three finite doubles each.
int orient3d(const double* a, const double* b, const double* c, const double* d);
/// Sign of the plane's equation at p: positive on the side to which the normal points.
int side_of_plane(const PointTable& t, PlaneId plane, const PointView& p);
int side_of_plane(const PointTable& t, PlaneId plane, VertexId p);
/// Orientation of three points projected to (u, v): positive for a left turn.
int orient2d(Projection axes, const PointView& a, const PointView& b, const PointView& c);
int orient2d(const PointTable& t, Projection axes, VertexId a, VertexId b, VertexId c);
/// Sign of the cross product of the projected vectors b - a and d - c: positive if the second is to the left.
int orient2d_vectors(const PointTable& t, Projection axes, VertexId a, VertexId b, VertexId c, VertexId d);
/// Sign of a[axis] - b[axis].
int compare(int axis, const PointView& a, const PointView& b);
int compare(const PointTable& t, int axis, VertexId a, VertexId b);
/// Lexicographic order of the coordinates.
int compare_lex(const PointView& a, const PointView& b);
int compare_lex(const PointTable& t, VertexId a, VertexId b);
bool collinear(const PointTable& t, VertexId a, VertexId b, VertexId c);
/// Sign of the k-th component of the cross product of the normals of two planes.
int cross_normal_sign(const PointTable& t, PlaneId p, PlaneId q, int k);
/// Sign of the k-th component of the plane's normal.
int normal_sign(const PointTable& t, PlaneId p, int k);
/// Sign of the scalar product of the plane's normal with an exact direction (doubles are taken as they are).
int normal_dot_sign(const PointTable& t, PlaneId p, const std::array<double, 3>& direction);
/// A projection along an axis on which the normal of the plane is certainly not zero.
Projection projection_of(const PointTable& t, PlaneId plane);
/// Along the largest component of the normal, of equal ones the last: the same for every plane that is this one.
Projection projection_of(const ExactPlane& plane);
/// The first one with a filter of the plane, which decides nearly always.
Projection projection_of(const PointTable& t, PlaneId plane, const PlaneFilter& filter);

/// Calls per deciding stage, summed over all threads since the last reset.
StageCounts stage_counts();
/// Adds `n` signs that a filter outside of this file decided.
void count_filtered(std::uint64_t n);
void reset_stage_counts();

}  // namespace cnrg
