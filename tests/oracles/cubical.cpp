#include "tests/oracles/cubical.h"

#include <algorithm>
#include <numeric>

namespace cubical {

Grid::Grid(int n) : n_(n), m_(2 * n + 1) {
  const int total = m_ * m_ * m_;
  dimension_.resize(total);
  boundary_.resize(total);
  around_.resize(total);
  cubes_.resize(total);
  for (Cell c = 0; c < total; ++c) {
    const auto p = position(c);
    dimension_[c] = (p[0] & 1) + (p[1] & 1) + (p[2] & 1);
    for (int axis = 0; axis < 3; ++axis) {
      for (int step : {-1, 1}) {
        auto q = p;
        q[axis] += step;
        if (q[axis] < 0 || q[axis] >= m_) continue;
        ((p[axis] & 1) ? boundary_[c] : around_[c]).push_back(at(q[0], q[1], q[2]));
      }
    }
  }
  for (Cell c = 0; c < total; ++c) {
    std::vector<Cell> up{c};
    while (dimension_[up[0]] < 3) {
      std::vector<Cell> higher;
      for (Cell d : up) higher.insert(higher.end(), around_[d].begin(), around_[d].end());
      std::sort(higher.begin(), higher.end());
      higher.erase(std::unique(higher.begin(), higher.end()), higher.end());
      up = higher;
    }
    cubes_[c] = up;
  }
}

bool Grid::on_rim(Cell c) const {
  const auto p = position(c);
  return std::any_of(p.begin(), p.end(), [&](int x) { return x <= 1 || x >= m_ - 2; });
}

void complete(const Grid& grid, Group& g) {
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) != 2 || grid.around(c).size() != 2) continue;
    if (g.inside[grid.around(c)[0]] != g.inside[grid.around(c)[1]]) g.entity[c] = 1;
  }
  for (int d : {2, 1}) {
    for (Cell c = 0; c < grid.cells(); ++c) {
      if (grid.dimension(c) != d || !g.entity[c]) continue;
      for (Cell b : grid.boundary(c)) g.entity[b] = 1;
    }
  }
  g.region.assign(grid.cells(), 0);
  g.region_count = 0;
  for (Cell seed = 0; seed < grid.cells(); ++seed) {
    if (grid.dimension(seed) != 3 || !g.inside[seed] || g.region[seed] != 0) continue;
    g.region[seed] = ++g.region_count;
    std::vector<Cell> stack{seed};
    while (!stack.empty()) {
      const Cell c = stack.back();
      stack.pop_back();
      for (Cell f : grid.boundary(c)) {
        if (g.entity[f]) continue;
        for (Cell d : grid.around(f)) {
          if (!g.inside[d] || g.region[d] != 0) continue;
          g.region[d] = g.region_count;
          stack.push_back(d);
        }
      }
    }
  }
}

namespace {

Group empty_group(const Grid& grid) {
  Group g;
  g.inside.assign(grid.cells(), 0);
  g.entity.assign(grid.cells(), 0);
  return g;
}

int num_reg(const Grid& grid, const Group& g, Cell f) {
  const int p = g.region[grid.around(f)[0]], q = g.region[grid.around(f)[1]];
  return p == q ? 0 : (p == 0 || q == 0 ? 1 : 2);
}

bool is_free(const Grid& grid, const Group& g, Cell c) {
  return g.entity[c] &&
         std::none_of(grid.around(c).begin(), grid.around(c).end(), [&](Cell d) { return g.entity[d] != 0; });
}

enum class Class { a_in_b, a_out_b, b_in_a, b_out_a, both };

Class classify(const Grid& grid, const Group& a, const Group& b, Cell c) {
  if (a.entity[c] && b.entity[c]) return Class::both;
  if (a.entity[c]) return region_around(grid, b, c) > 0 ? Class::a_in_b : Class::a_out_b;
  return region_around(grid, a, c) > 0 ? Class::b_in_a : Class::b_out_a;
}

bool face_goes(const Grid& grid, Op op, bool dominant, const Group& a, const Group& b, Cell f) {
  const Class k = classify(grid, a, b, f);
  const int na = num_reg(grid, a, f), nb = num_reg(grid, b, f);
  const Cell p = grid.around(f)[0], q = grid.around(f)[1];
  if (op == Op::unite) {
    if (k == Class::a_in_b) return !dominant && na == 1;
    if (k == Class::b_in_a) return dominant || nb == 1;
    if (k == Class::both) return !dominant && na == 1 && nb == 1 && (a.region[p] > 0) != (b.region[p] > 0);
    return false;
  }
  if (op == Op::intersect) {
    if (k == Class::a_out_b || k == Class::b_out_a) return true;
    return k == Class::b_in_a && dominant && (nb == 2 || (nb == 0 && b.region[p] > 0));
  }
  if (k == Class::a_in_b || k == Class::b_out_a) return true;
  if (k == Class::a_out_b) return false;
  if (k == Class::b_in_a) return nb != 1;
  const bool survives = (a.region[p] > 0 && b.region[p] == 0) || (a.region[q] > 0 && b.region[q] == 0);
  return !survives || (na == 0 && nb == 0);
}

bool lower_goes(const Grid& grid, Op op, bool dominant, const Group& a, const Group& b, Cell c) {
  const Class k = classify(grid, a, b, c);
  const bool free_a = is_free(grid, a, c), free_b = is_free(grid, b, c);
  if (op == Op::unite) {
    if (k == Class::a_in_b) return !dominant && !free_a;
    if (k == Class::b_in_a) return dominant || !free_b;
    return k == Class::both && !dominant && !free_a && !free_b;
  }
  if (op == Op::intersect) {
    if (k == Class::a_out_b || k == Class::b_out_a) return true;
    if (k != Class::b_in_a || !dominant) return false;
    if (region_around(grid, b, c) > 0) return true;
    // Of a wall between two regions: it stays if it is a feature, a mere cut goes.
    const auto& cubes = grid.cubes(c);
    return !b.cut.empty() && b.cut[c] &&
           std::all_of(cubes.begin(), cubes.end(), [&](Cell d) { return b.inside[d] != 0; });
  }
  return k != Class::a_out_b;
}

}  // namespace

int region_around(const Grid& grid, const Group& g, Cell c) {
  const int r = g.region[grid.cubes(c)[0]];
  for (Cell d : grid.cubes(c)) {
    if (g.region[d] != r) return -1;
  }
  return r;
}

Group random_group(const Grid& grid, std::mt19937_64& random, bool noise, double loose) {
  Group g = empty_group(grid);
  std::vector<int> label(grid.cells(), 0);
  const auto pick = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  const auto chance = [&](double p) { return static_cast<double>(random() >> 11) * 0x1p-53 < p; };
  const int n = grid.n() - 2;
  const int regions = pick(4);
  for (int r = 1; r <= regions; ++r) {
    int low[3], high[3];
    for (int k = 0; k < 3; ++k) {
      low[k] = pick(n);
      high[k] = low[k] + 1 + pick(n - low[k]);
    }
    for (Cell c = 0; c < grid.cells(); ++c) {
      if (grid.dimension(c) != 3) continue;
      const auto p = grid.position(c);
      bool in = true;
      for (int k = 0; k < 3; ++k) in = in && low[k] <= p[k] / 2 - 1 && p[k] / 2 - 1 < high[k];
      if (in) label[c] = r;
    }
  }
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) == 3 && !grid.on_rim(c) && noise && chance(.3)) label[c] = pick(3);
  }
  const double share[3] = {.02, .03, .04};
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) == 3) {
      g.inside[c] = label[c] != 0;
    } else if (!grid.on_rim(c)) {
      g.entity[c] = chance((grid.dimension(c) < 2 ? loose : 1) * share[grid.dimension(c)]);
      if (grid.dimension(c) == 2) {
        const auto& side = grid.around(c);
        if (label[side[0]] != label[side[1]]) g.entity[c] = 1;
      }
    }
  }
  complete(grid, g);
  return g;
}

Group boolean_operation(const Grid& grid, Op op, bool dominant, const Group& a, const Group& b) {
  Group g = empty_group(grid);
  for (int d : {2, 1, 0}) {
    for (Cell c = 0; c < grid.cells(); ++c) {
      if (grid.dimension(c) != d || !(a.entity[c] || b.entity[c])) continue;
      if (d == 2) {
        g.entity[c] = !face_goes(grid, op, dominant, a, b, c);
        continue;
      }
      const auto& up = grid.around(c);
      const bool bounds = std::any_of(up.begin(), up.end(), [&](Cell u) { return g.entity[u] != 0; });
      g.entity[c] = bounds || !lower_goes(grid, op, dominant, a, b, c);
    }
  }
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) != 3) continue;
    const bool in_a = a.inside[c], in_b = b.inside[c];
    g.inside[c] = op == Op::unite ? in_a || in_b : (op == Op::intersect ? in_a && in_b : in_a && !in_b);
  }
  const auto entity = g.entity;
  complete(grid, g);
  if (g.entity != entity) g.region_count = -1;  // the tables left a group that is not valid
  return g;
}

Group complement(const Grid& grid, const Group& g) {
  Group out = empty_group(grid);
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) == 3) out.inside[c] = !g.inside[c];
  }
  complete(grid, out);
  return out;
}

Group regularize(const Grid& grid, const Group& g) {
  Group out = empty_group(grid);
  out.inside = g.inside;
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) == 2 && grid.around(c).size() == 2) out.entity[c] = num_reg(grid, g, c) != 0;
  }
  complete(grid, out);
  return out;
}

namespace {

class Sets {
 public:
  explicit Sets(int n) : up_(n) { std::iota(up_.begin(), up_.end(), 0); }
  int find(int x) { return up_[x] == x ? x : up_[x] = find(up_[x]); }
  void unite(int a, int b) { up_[find(a)] = find(b); }

 private:
  std::vector<int> up_;
};

int normal_axis(const Grid& grid, Cell c, bool odd) {
  const auto p = grid.position(c);
  for (int k = 0; k < 3; ++k) {
    if (((p[k] & 1) != 0) == odd) return k;
  }
  return -1;
}

}  // namespace

std::array<std::size_t, 4> canonical_counts(const Grid& grid, const std::vector<int>& s) {
  std::vector<char> stays(grid.cells(), 0);
  Sets sets(grid.cells());
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) == 3) stays[c] = 1;
  }
  const auto remaining = [&](const std::vector<Cell>& cells) {
    std::vector<Cell> out;
    for (Cell c : cells) {
      if (stays[c]) out.push_back(c);
    }
    return out;
  };
  for (int d : {2, 1, 0}) {
    for (Cell c = 0; c < grid.cells(); ++c) {
      if (grid.dimension(c) != d) continue;
      const Cell cube = grid.cubes(c)[0];
      if (d == 2) {
        const auto& side = grid.around(c);
        stays[c] = s[c] != s[side[0]] || s[c] != s[side.back()];
        if (!stays[c]) sets.unite(side[0], side.back());
        continue;
      }
      const auto up = remaining(grid.around(c));
      if (d == 1) {
        if (up.empty()) {
          stays[c] = s[c] != s[cube];
        } else {
          const bool flat = up.size() == 2 && normal_axis(grid, up[0], false) == normal_axis(grid, up[1], false);
          stays[c] = !(flat && s[c] == s[up[0]] && s[c] == s[up[1]]);
          if (!stays[c]) sets.unite(up[0], up[1]);
        }
        continue;
      }
      // All faces around the vertex that stay.
      std::vector<Cell> faces;
      for (Cell e : grid.around(c)) {
        for (Cell f : remaining(grid.around(e))) faces.push_back(f);
      }
      if (up.empty()) {
        stays[c] = s[c] != (faces.empty() ? s[cube] : s[faces[0]]);
        continue;
      }
      stays[c] = 1;
      if (up.size() != 2 || s[c] != s[up[0]] || s[c] != s[up[1]]) continue;
      const int axis = normal_axis(grid, up[0], true);
      if (axis != normal_axis(grid, up[1], true)) continue;
      const auto across = [&](Cell f) { return normal_axis(grid, f, false) == axis; };
      if (std::any_of(faces.begin(), faces.end(), across)) continue;
      stays[c] = 0;
      sets.unite(up[0], up[1]);
    }
  }
  std::array<std::size_t, 4> out{};
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (stays[c] && s[c] != 0 && sets.find(c) == c) ++out[grid.dimension(c)];
  }
  return out;
}

std::vector<Rectangle> rectangles(const Grid& grid, const Group& g, bool large) {
  std::vector<Rectangle> out;
  std::vector<char> done(grid.cells(), 0);
  const auto kind = [&](Cell f) {
    const auto& side = grid.around(f);  // negative side first
    return std::pair(g.region[side[1]], g.region[side[0]]);
  };
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) != 2 || !g.entity[c] || done[c]) continue;
    const int axis = normal_axis(grid, c, false), u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto p = grid.position(c);
    const auto cell = [&](int i, int j) {
      auto q = p;
      q[u] += 2 * i;
      q[v] += 2 * j;
      return grid.at(q[0], q[1], q[2]);
    };
    const auto same = [&](Cell d) { return g.entity[d] && !done[d] && kind(d) == kind(c); };
    int width = 1, height = 1;
    if (large) {
      while (p[u] + 2 * width < 2 * grid.n() && same(cell(width, 0))) ++width;
      for (bool grows = true; grows;) {
        grows = p[v] + 2 * height < 2 * grid.n();
        for (int i = 0; grows && i < width; ++i) grows = same(cell(i, height));
        if (grows) ++height;
      }
    }
    for (int i = 0; i < width; ++i) {
      for (int j = 0; j < height; ++j) done[cell(i, j)] = 1;
    }
    Rectangle r;
    r.low = {p[0] / 2, p[1] / 2, p[2] / 2};
    r.extent[axis] = 0;
    r.extent[u] = width;
    r.extent[v] = height;
    r.axis = axis;
    std::tie(r.front, r.back) = kind(c);
    out.push_back(r);
  }
  return out;
}

void mark_cuts(const Grid& grid, Group& g) {
  std::vector<char> feature(grid.cells(), 0);
  for (const Rectangle& r : rectangles(grid, g, true)) {
    const int u = (r.axis + 1) % 3, v = (r.axis + 2) % 3;
    for (int i = 0; i <= 2 * r.extent[u]; ++i) {
      for (int j = 0; j <= 2 * r.extent[v]; ++j) {
        if (i != 0 && j != 0 && i != 2 * r.extent[u] && j != 2 * r.extent[v]) continue;
        std::array<int, 3> p{2 * r.low[0], 2 * r.low[1], 2 * r.low[2]};
        p[u] += i;
        p[v] += j;
        feature[grid.at(p[0], p[1], p[2])] = 1;
      }
    }
  }
  g.cut.assign(grid.cells(), 0);
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) > 1 || !g.entity[c] || feature[c] || is_free(grid, g, c)) continue;
    // The end of a wire is named too.
    const auto& up = grid.around(c);
    g.cut[c] = grid.dimension(c) == 1 ||
               std::none_of(up.begin(), up.end(), [&](Cell e) { return is_free(grid, g, e) || feature[e]; });
  }
}

std::vector<Segment> wires(const Grid& grid, const Group& g, bool large) {
  std::vector<Segment> out;
  std::vector<char> done(grid.cells(), 0);
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) != 1 || done[c] || !is_free(grid, g, c)) continue;
    const int axis = normal_axis(grid, c, true);
    const auto p = grid.position(c);
    int length = 0;
    for (auto q = p; q[axis] < 2 * grid.n(); q[axis] += 2) {
      const Cell d = grid.at(q[0], q[1], q[2]);
      if (!is_free(grid, g, d) || (length == 1 && !large)) break;
      done[d] = 1;
      ++length;
    }
    out.push_back({{p[0] / 2, p[1] / 2, p[2] / 2}, axis, length});
  }
  return out;
}

std::vector<std::array<int, 3>> points(const Grid& grid, const Group& g) {
  std::vector<std::array<int, 3>> out;
  for (Cell c = 0; c < grid.cells(); ++c) {
    if (grid.dimension(c) != 0 || !is_free(grid, g, c)) continue;
    const auto p = grid.position(c);
    out.push_back({p[0] / 2, p[1] / 2, p[2] / 2});
  }
  return out;
}

}  // namespace cubical
