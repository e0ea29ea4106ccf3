// Patches: faces joined side to side through edges that have two of them. Private to this room.
//
// Where two half-faces meet, their opposites meet too; so one union-find over faces does for both sides. It keeps
// for the front of each face a half-face that it is joined to, of a smaller face. Threads join at the same time
// (Anderson, Woll 1991): only a root is given a parent, by one atomic exchange; what a find writes was an ancestor
// and stays one. In the end the root is the smallest face of its patch, whatever the order.
#pragma once

#include <atomic>
#include <vector>

#include "kernel/base/ids.h"

namespace cnrg {

class Patches {
 public:
  explicit Patches(std::size_t faces) : parent_(faces) {
    for (const FaceId f : IdRange<FaceId>(faces)) set(f, HalfFace(f, 0).code());
  }

  /// Joins a with b and their opposites. False if a was joined with the opposite of b: the patch has one side.
  bool unite(HalfFace a, HalfFace b);

  /// Numbers the patches by their first faces. Side 0 of a patch is the front of its first face: result[f] is
  /// 2 * patch + side for the front of f. No join may follow.
  IdVector<FaceId, std::uint32_t> number(std::size_t& count) const;

 private:
  HalfFace parent(HalfFace h) const { return half_face(get(h.face()) ^ h.side()); }
  std::uint32_t get(FaceId f) const { return parent_[f.index()].load(std::memory_order_relaxed); }
  void set(FaceId f, std::uint32_t code) { parent_[f.index()].store(code, std::memory_order_relaxed); }
  static HalfFace half_face(std::uint32_t code) { return HalfFace(FaceId(code >> 1), code & 1); }
  HalfFace root(HalfFace h);

  std::vector<std::atomic<std::uint32_t>> parent_;  // of the front of each face: the code of a half-face
};

inline HalfFace Patches::root(HalfFace h) {
  for (;;) {
    const HalfFace up = parent(h);
    if (up == h) return h;
    const HalfFace next = parent(up);
    if (next != up) set(h.face(), next.code() ^ h.side());
    h = next;
  }
}

inline bool Patches::unite(HalfFace a, HalfFace b) {
  for (;;) {
    a = root(a);
    b = root(b);
    if (a.face() == b.face()) return a == b;
    if (a.face() < b.face()) std::swap(a, b);
    std::uint32_t alone = HalfFace(a.face(), 0).code();
    if (parent_[a.face().index()].compare_exchange_strong(alone, b.code() ^ a.side(), std::memory_order_relaxed)) {
      return true;
    }
  }
}

inline IdVector<FaceId, std::uint32_t> Patches::number(std::size_t& count) const {
  IdVector<FaceId, std::uint32_t> sides(parent_.size());
  count = 0;
  for (const FaceId f : IdRange<FaceId>(parent_.size())) {
    const HalfFace up = half_face(get(f));
    sides[f] = up.face() == f ? static_cast<std::uint32_t>(2 * count++) : sides[up.face()] ^ up.side();
  }
  return sides;
}

}  // namespace cnrg
