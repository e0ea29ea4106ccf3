// Who may stop the making of leaves.
//
// A leaf is made by functions that call each other through forms (leaf.h) and functions that are kept; nearly all
// of them end in microseconds and have nothing to do with anybody who waits. What takes long are loops over points
// and facets, and readers of files, at the bottom. So the token is one of the thread, for as long as it makes
// leaves for somebody, and those loops look at it.
#pragma once

#include <stop_token>

namespace cnrg {

class LeafStop {
 public:
  /// Until it ends, leaves that this thread makes are made for the owner of the token.
  explicit LeafStop(const std::stop_token& stop);
  ~LeafStop();
  LeafStop(const LeafStop&) = delete;
  LeafStop& operator=(const LeafStop&) = delete;

  /// Of this thread; nobody's where nobody waits.
  static std::stop_token token();
  /// After each point or facet: throws Stopped, if that was asked for.
  static void check();

 private:
  const std::stop_token stop_;
  const LeafStop* const before_;
};

}  // namespace cnrg
