// Typed 4-byte ids and the arrays that they index.
//
// Every cell, leaf and input face of the project is named by an Id: a 32-bit number that knows what it counts, so
// that an edge cannot be used where a face is meant. Half-edges pack their direction and half-faces their side
// into the lowest bit; the opposite one is an XOR away.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "kernel/base/counts.h"

namespace cnrg {

/// A 32-bit number of one kind (`Tag`). The default is `none()`, which names nothing.
template <class Tag>
class Id {
 public:
  using Value = std::uint32_t;
  constexpr Id() = default;
  constexpr explicit Id(std::size_t value) : value_(static_cast<Value>(value)) {}
  static constexpr Id none() { return {}; }
  constexpr bool valid() const { return value_ != kNone; }
  constexpr Value value() const { return value_; }
  constexpr std::size_t index() const { return value_; }
  friend constexpr auto operator<=>(Id, Id) = default;
  constexpr Id& operator++() {
    ++value_;
    return *this;
  }

 private:
  static constexpr Value kNone = std::numeric_limits<Value>::max();
  Value value_ = kNone;
};

using PointId = Id<struct PointTag>;          ///< a point of the soup, before identity is decided
using VertexId = Id<struct VertexTag>;        ///< a 0-cell
using EdgeId = Id<struct EdgeTag>;            ///< a 1-cell
using FaceId = Id<struct FaceTag>;            ///< a 2-cell
using RegionId = Id<struct RegionTag>;        ///< a 3-cell; RegionId(0) is the unbounded one
using LoopId = Id<struct LoopTag>;            ///< a closed walk of half-edges
using SheetId = Id<struct SheetTag>;          ///< coplanar faces that touch, and their one 2D subdivision
using SegmentId = Id<struct SegmentTag>;      ///< an input edge, a wire or a trace of two sheets
using PlaneId = Id<struct PlaneTag>;          ///< the plane of an input face
using LeafId = Id<struct LeafTag>;            ///< one leaf instance of a tree
using SourceId = Id<struct SourceTag>;        ///< one face of the soup
using WireId = Id<struct WireTag>;            ///< one segment of the soup
using SourceSetId = Id<struct SourceSetTag>;  ///< an interned set of soup faces with orientation
using LabelSetId = Id<struct LabelSetTag>;    ///< an interned set of (leaf, leaf region)
using ShellId = Id<struct ShellTag>;          ///< a connected set of half-faces

constexpr int dimension_of(VertexId) { return 0; }
constexpr int dimension_of(EdgeId) { return 1; }
constexpr int dimension_of(FaceId) { return 2; }
constexpr int dimension_of(RegionId) { return 3; }

/// What an id counts, for messages.
template <class IdT>
inline constexpr const char* kPlural = "things of one kind";
template <>
inline constexpr const char* kPlural<PointId> = "points";
template <>
inline constexpr const char* kPlural<VertexId> = "vertices";
template <>
inline constexpr const char* kPlural<EdgeId> = "edges";
template <>
inline constexpr const char* kPlural<FaceId> = "faces";
template <>
inline constexpr const char* kPlural<RegionId> = "regions";
template <>
inline constexpr const char* kPlural<LoopId> = "loops of faces";
template <>
inline constexpr const char* kPlural<SegmentId> = "segments";
template <>
inline constexpr const char* kPlural<LeafId> = "leaves";
template <>
inline constexpr const char* kPlural<SourceId> = "faces of leaves";

/// An edge with a direction: side 0 runs from the edge's first vertex to its second.
class HalfEdge {
 public:
  constexpr HalfEdge() = default;
  constexpr HalfEdge(EdgeId edge, unsigned direction) : code_(edge.value() * 2 + direction) {}
  constexpr EdgeId edge() const { return EdgeId(code_ >> 1); }
  constexpr unsigned direction() const { return code_ & 1; }
  constexpr HalfEdge twin() const {
    HalfEdge t;
    t.code_ = code_ ^ 1;
    return t;
  }
  constexpr std::uint32_t code() const { return code_; }
  friend constexpr auto operator<=>(HalfEdge, HalfEdge) = default;

 private:
  std::uint32_t code_ = std::numeric_limits<std::uint32_t>::max();
};

/// A side of a face: side 0 is the front, to which the normal of its sheet points.
class HalfFace {
 public:
  constexpr HalfFace() = default;
  constexpr HalfFace(FaceId face, unsigned side) : code_(face.value() * 2 + side) {}
  constexpr FaceId face() const { return FaceId(code_ >> 1); }
  constexpr unsigned side() const { return code_ & 1; }
  constexpr HalfFace opposite() const {
    HalfFace t;
    t.code_ = code_ ^ 1;
    return t;
  }
  constexpr std::uint32_t code() const { return code_; }
  constexpr std::size_t index() const { return code_; }
  friend constexpr auto operator<=>(HalfFace, HalfFace) = default;

 private:
  std::uint32_t code_ = std::numeric_limits<std::uint32_t>::max();
};

/// A vector indexed by one kind of id only.
template <class IdT, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t n, T value = T()) : data_(checked(n), value) {}
  explicit IdVector(std::vector<T> data) : data_(std::move(data)) { checked(data_.size()); }
  decltype(auto) operator[](IdT id) { return data_[id.index()]; }
  decltype(auto) operator[](IdT id) const { return data_[id.index()]; }
  std::size_t size() const { return data_.size(); }
  bool empty() const { return data_.empty(); }
  IdT end_id() const { return IdT(data_.size()); }
  IdT push_back(T value) {
    const IdT id(checked(data_.size() + 1) - 1);
    data_.push_back(std::move(value));
    return id;
  }
  void resize(std::size_t n, T value = T()) { data_.resize(checked(n), value); }
  void assign(std::size_t n, T value) { data_.assign(checked(n), value); }
  void reserve(std::size_t n) { data_.reserve(n); }
  void clear() { data_.clear(); }
  auto begin() { return data_.begin(); }
  auto end() { return data_.end(); }
  auto begin() const { return data_.begin(); }
  auto end() const { return data_.end(); }
  const std::vector<T>& raw() const { return data_; }

 private:
  static std::size_t checked(std::size_t n) {
    check_count(n, kPlural<IdT>);
    return n;
  }
  std::vector<T> data_;
};

/// All ids from 0 to n-1, for range loops.
template <class IdT>
class IdRange {
 public:
  struct Iterator {
    IdT id;
    IdT operator*() const { return id; }
    Iterator& operator++() {
      ++id;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return id != other.id; }
  };
  explicit IdRange(std::size_t n) : n_(n) {}
  Iterator begin() const { return {IdT(0)}; }
  Iterator end() const { return {IdT(n_)}; }

 private:
  std::size_t n_;
};

/// A list of T for every id, packed: `list[id]` is a span.
template <class IdT, class T>
class Csr {
 public:
  Csr() = default;
  std::span<const T> operator[](IdT id) const {
    return {values_.data() + offsets_[id.index()], values_.data() + offsets_[id.index() + 1]};
  }
  std::span<T> operator[](IdT id) {
    return {values_.data() + offsets_[id.index()], values_.data() + offsets_[id.index() + 1]};
  }
  std::size_t size() const { return offsets_.size() - 1; }
  std::size_t value_count() const { return values_.size(); }
  /// Appends one list at the end and returns its id.
  template <class Range>
  IdT push_back(const Range& list) {
    values_.insert(values_.end(), std::begin(list), std::end(list));
    check_count(offsets_.size(), kPlural<IdT>);
    offsets_.push_back(place32(values_.size(), kEntries));
    return IdT(offsets_.size() - 2);
  }
  void reserve(std::size_t lists, std::size_t values) {
    offsets_.reserve(lists + 1);
    values_.reserve(values);
  }
  /// Builds from offsets (n + 1 numbers) and values.
  static Csr from_parts(std::vector<std::uint32_t> offsets, std::vector<T> values) {
    check_count(offsets.size() - 1, kPlural<IdT>);
    check_count(values.size(), kEntries, kMostPlaces);
    Csr csr;
    csr.offsets_ = std::move(offsets);
    csr.values_ = std::move(values);
    return csr;
  }
  /// Builds from pairs in any order: `visit(take)` calls take(id, value) for each pair; it runs twice and must
  /// give the same ones. Values of an id stay in the order in which they come.
  template <class Visit>
  static Csr counted(std::size_t n, const Visit& visit) {
    check_count(n, kPlural<IdT>);
    Csr csr;
    std::vector<std::uint32_t>& next = csr.offsets_;
    next.assign(n + 2, 0);
    visit([&](IdT id, const T&) { ++next[id.index() + 2]; });
    sum_up(next, kEntries);
    csr.values_.resize(next[n + 1]);
    // Place i + 1 holds where list i goes on, and in the end where it ends: where list i + 1 begins.
    visit([&](IdT id, const T& value) { csr.values_[next[id.index() + 1]++] = value; });
    next.pop_back();
    return csr;
  }
  /// The same lists under ids of another kind.
  template <class Other>
  static Csr renamed(Csr<Other, T> lists) {
    return from_parts(std::move(lists.offsets_), std::move(lists.values_));
  }
  /// Drops the lists for whose ids `keep` is false; it is asked once for each id, ascending.
  template <class Keep>
  void keep_if(Keep keep) {
    std::uint32_t lists = 0, size = 0, begin = 0;
    for (std::size_t i = 0; i < this->size(); ++i) {
      const std::uint32_t end = offsets_[i + 1];
      if (keep(IdT(i))) {
        for (std::uint32_t k = begin; k < end; ++k) values_[size++] = std::move(values_[k]);
        offsets_[++lists] = size;
      }
      begin = end;
    }
    offsets_.resize(lists + 1);
    values_.resize(size);
  }
  const std::vector<std::uint32_t>& offsets() const { return offsets_; }
  const std::vector<T>& values() const { return values_; }
  std::vector<T>& values() { return values_; }

 private:
  template <class, class>
  friend class Csr;
  static constexpr const char* kEntries = "entries of lists";
  std::vector<std::uint32_t> offsets_{0};
  std::vector<T> values_;
};

}  // namespace cnrg

template <class Tag>
struct std::hash<cnrg::Id<Tag>> {
  std::size_t operator()(cnrg::Id<Tag> id) const noexcept { return std::hash<std::uint32_t>{}(id.value()); }
};
