// The only translation unit of the tests that includes Nef polyhedra: it takes a minute to compile. Built with
// assertions, since Nef of CGAL 5.5.1 fails on some pairs of sheets and would crash without.
#include "tests/oracles/nef_oracle.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>

#include <algorithm>
#include <map>
#include <set>

#include "bench/peers/nef_algebra.h"

namespace cnrg::properties {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = bench::nef::Set;
using Surface = CGAL::Polyhedron_3<Kernel>;
using Point = Kernel::Point_3;

using Exact = Kernel::FT::Exact_type;

// CGAL's rational is a wrapper of GMP's, which one depends on how CGAL was configured.
Exact number(const Rational& value) { return Exact(value.get_mpq_t()); }

template <class Number>
Rational rational_of(const Number& value) {
  if constexpr (requires { value.backend().data(); }) return Rational(value.backend().data());
  else if constexpr (requires { value.mpq(); }) return Rational(value.mpq());
  else return Rational(value);
}

Point point_of(const RationalPoint& p) {
  return {Kernel::FT(number(p[0])), Kernel::FT(number(p[1])), Kernel::FT(number(p[2]))};
}

RationalPoint point_of(const Point& p) {
  return {rational_of(CGAL::exact(p.x())), rational_of(CGAL::exact(p.y())), rational_of(CGAL::exact(p.z()))};
}

class SolidBuilder : public CGAL::Modifier_base<Surface::HalfedgeDS> {
 public:
  explicit SolidBuilder(const scenes::Solid& facets) : facets_(facets) {}
  void operator()(Surface::HalfedgeDS& target) override {
    std::map<RationalPoint, std::size_t> numbers;
    std::vector<RationalPoint> points;
    for (const scenes::Polygon& facet : facets_)
      for (const RationalPoint& p : facet)
        if (numbers.emplace(p, points.size()).second) points.push_back(p);
    CGAL::Polyhedron_incremental_builder_3<Surface::HalfedgeDS> build(target, true);
    build.begin_surface(points.size(), facets_.size());
    for (const RationalPoint& p : points) build.add_vertex(point_of(p));
    for (const scenes::Polygon& facet : facets_) {
      build.begin_facet();
      for (const RationalPoint& p : facet) build.add_vertex_to_facet(numbers.at(p));
      build.end_facet();
    }
    build.end_surface();
    if (build.error()) throw std::logic_error("the oracle's solid is no 2-manifold");
  }

 private:
  const scenes::Solid& facets_;
};

/// Cuts a closed walk at repeated vertices into simple cycles; slits fall out.
std::vector<scenes::Polygon> simple_cycles(const scenes::Polygon& walk) {
  std::vector<scenes::Polygon> cycles;
  scenes::Polygon path;
  for (const RationalPoint& p : walk) {
    const auto seen = std::find(path.begin(), path.end(), p);
    if (seen != path.end()) {
      if (path.end() - seen > 2) cycles.emplace_back(seen, path.end());
      path.erase(seen, path.end());
    }
    path.push_back(p);
  }
  if (path.size() > 2) cycles.push_back(std::move(path));
  return cycles;
}

Nef simple_polygon(const scenes::Polygon& corners) {
  std::vector<Point> points;
  for (const RationalPoint& p : corners) points.push_back(point_of(p));
  return Nef(points.begin(), points.end());
}

/// Runs one operation of Nef; an assertion of CGAL that fails in it is a failure of the oracle.
template <class Operation>
auto guarded(Operation operation) {
  try {
    return operation();
  } catch (const CGAL::Failure_exception& error) {
    throw OracleFailure(error.what());
  } catch (const bench::nef::BrokenSet& error) {
    throw OracleFailure(error.what());
  }
}

/// Marks the volumes that it was told, and the sphere faces in them.
class Filler : public CGAL::Modifier_base<Nef::SNC_structure> {
 public:
  explicit Filler(std::set<const void*> volumes) : volumes_(std::move(volumes)) {}
  void operator()(Nef::SNC_structure& snc) override {
    using Decorator = Nef::SNC_structure::SNC_decorator;
    Decorator decorator(snc);
    CGAL::Volume_setter<Nef::SNC_structure, bool> setter(true);
    for (auto c = snc.volumes_begin(); c != snc.volumes_end(); ++c) {
      if (!volumes_.contains(&*c)) continue;
      c->mark() = true;
      for (auto shell = c->shells_begin(); shell != c->shells_end(); ++shell)
        decorator.visit_shell_objects(Nef::SFace_handle(shell), setter);
    }
  }

 private:
  std::set<const void*> volumes_;
};

}  // namespace

struct NefSet::Data {
  Nef nef;
};

NefSet::NefSet() : data_(std::make_shared<Data>()) {}
NefSet::~NefSet() = default;
NefSet::NefSet(const NefSet&) = default;
NefSet& NefSet::operator=(const NefSet&) = default;

namespace {

template <class Set>
std::shared_ptr<const Set> shared(Nef nef) {
  return std::make_shared<Set>(Set{std::move(nef)});
}

}  // namespace

NefSet NefSet::solid(const scenes::Solid& facets) {
  Surface surface;
  SolidBuilder builder(facets);
  surface.delegate(builder);
  NefSet set;
  set.data_ = shared<Data>(Nef(surface));
  return set;
}

NefSet NefSet::polygon(const std::vector<scenes::Polygon>& loops) {
  Nef result;
  bool first = true;
  for (const scenes::Polygon& loop : loops)
    for (const scenes::Polygon& cycle : simple_cycles(loop)) {
      result = guarded(
          [&] { return first ? simple_polygon(cycle) : result.symmetric_difference(simple_polygon(cycle)); });
      first = false;
    }
  NefSet set;
  set.data_ = shared<Data>(result.closure());
  return set;
}

NefSet NefSet::segment(const RationalPoint& a, const RationalPoint& b) {
  NefSet set;
  set.data_ = shared<Data>(Nef(Nef::Segment_3(point_of(a), point_of(b))));
  return set;
}

NefSet NefSet::point(const RationalPoint& p) {
  NefSet set;
  set.data_ = shared<Data>(Nef(point_of(p)));
  return set;
}

NefSet NefSet::unite_all(std::vector<NefSet> sets) {
  if (sets.empty()) return {};
  for (std::size_t step = 1; step < sets.size(); step *= 2)
    for (std::size_t i = 0; i + step < sets.size(); i += 2 * step) sets[i] = sets[i].unite(sets[i + step]);
  return sets.front();
}

NefSet NefSet::leaf(const scenes::Leaf& leaf) {
  std::vector<NefSet> sets;
  for (const scenes::Solid& s : leaf.solids) sets.push_back(solid(s));
  for (const scenes::Face& f : leaf.faces)
    if (f.sheet) sets.push_back(polygon(f.loops));
  for (const auto& [a, b] : leaf.wires) sets.push_back(segment(a, b));
  for (const RationalPoint& p : leaf.points) sets.push_back(point(p));
  return unite_all(std::move(sets));
}

template <class Make>
NefSet NefSet::of(const Make& make) {
  NefSet set;
  set.data_ = guarded([&] { return shared<Data>(make()); });
  return set;
}

NefSet NefSet::unite(const NefSet& other) const {
  return of([&] { return bench::nef::united(data_->nef, other.data_->nef); });
}
NefSet NefSet::intersect(const NefSet& other) const {
  return of([&] { return bench::nef::common(data_->nef, other.data_->nef); });
}
NefSet NefSet::subtract(const NefSet& other) const {
  return of([&] { return bench::nef::closed_difference(data_->nef, other.data_->nef); });
}
NefSet NefSet::without(const NefSet& other) const {
  return of([&] { return bench::nef::without(data_->nef, other.data_->nef); });
}
NefSet NefSet::complement() const {
  return of([&] { return data_->nef.complement(); });
}
NefSet NefSet::interior() const {
  return of([&] { return bench::nef::settled(data_->nef.interior()); });
}
NefSet NefSet::closure() const {
  return of([&] { return bench::nef::settled(data_->nef.closure()); });
}
NefSet NefSet::boundary() const {
  return of([&] { return bench::nef::settled(data_->nef.boundary()); });
}
NefSet NefSet::regularization() const {
  return of([&] { return bench::nef::settled(data_->nef.regularization()); });
}

bool NefSet::unbounded() const { return bench::nef::unbounded_mark(data_->nef); }

NefSet NefSet::fill(const std::vector<RationalPoint>& inside) const {
  Nef nef = data_->nef;
  std::set<const void*> volumes;
  // `delegate` copies a shared representation; an empty modifier makes the copy before handles are taken.
  bench::nef::Nothing nothing;
  nef.delegate(nothing, false, false);
  for (const RationalPoint& p : inside) {
    Nef::Volume_const_handle c;
    if (!CGAL::assign(c, nef.locate(point_of(p)))) throw std::logic_error("a point to fill from lies on a facet");
    volumes.insert(&*c);
  }
  Filler filler(std::move(volumes));
  nef.delegate(filler, false, true);
  NefSet set;
  set.data_ = shared<Data>(std::move(nef));
  return set;
}

bool NefSet::contains(const RationalPoint& p) const {
  const Nef::Object_handle o = guarded([&] { return data_->nef.locate(point_of(p)); });
  Nef::Vertex_const_handle v;
  Nef::Halfedge_const_handle e;
  Nef::Halffacet_const_handle f;
  Nef::Volume_const_handle c;
  if (CGAL::assign(v, o)) return v->mark();
  if (CGAL::assign(e, o)) return e->mark();
  if (CGAL::assign(f, o)) return f->mark();
  if (CGAL::assign(c, o)) return c->mark();
  throw std::logic_error("Nef located a point nowhere");
}

bool NefSet::operator==(const NefSet& other) const {
  return guarded([&] { return bench::nef::are_equal(data_->nef, other.data_->nef); });
}

bool NefSet::valid() const { return Nef(data_->nef).is_valid(); }

Skeleton NefSet::skeleton() const {
  const Nef& nef = data_->nef;
  Skeleton s;
  std::map<const void*, std::uint32_t> number;
  for (auto v = nef.vertices_begin(); v != nef.vertices_end(); ++v) {
    number[&*v] = static_cast<std::uint32_t>(s.vertices.size());
    s.vertices.push_back({point_of(v->point()), v->mark()});
  }
  const auto ends = [&](auto from, auto to) {
    return std::array<std::uint32_t, 2>{number.at(&*from), number.at(&*to)};
  };
  for (auto e = nef.halfedges_begin(); e != nef.halfedges_end(); ++e)
    if (e->is_twin()) s.edges.push_back({ends(e->source(), e->twin()->source()), e->mark()});
  for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f) {
    const auto normal = f->plane().orthogonal_vector();
    const auto x = CGAL::sign(normal.x()), y = CGAL::sign(normal.y()), z = CGAL::sign(normal.z());
    if ((x != 0 ? x : y != 0 ? y : z) < 0) continue;  // its twin is the one
    Skeleton::Facet facet;
    facet.mark = f->mark();
    // A half-facet's plane is oriented towards its incident volume.
    facet.above = f->incident_volume()->mark();
    facet.below = f->twin()->incident_volume()->mark();
    for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle) {
      if (cycle.is_shalfedge()) {
        Nef::SHalfedge_around_facet_const_circulator at(cycle), end(at);
        CGAL_For_all(at, end)
            facet.boundary.push_back(ends(at->source()->source(), at->source()->twin()->source()));
      } else if (cycle.is_shalfloop()) {
        facet.isolated.push_back(
            number.at(&*Nef::SHalfloop_const_handle(cycle)->incident_sface()->center_vertex()));
      }
    }
    s.facets.push_back(std::move(facet));
  }
  s.volumes = nef.number_of_volumes();
  s.sort();
  return s;
}

Rational NefSet::volume() const {
  // Divergence theorem over the half-facets of marked volumes: sum of p0 . (vector area) / 3.
  Rational sum = 0;
  const Nef& nef = data_->nef;
  for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f) {
    if (!f->incident_volume()->mark() || f->incident_volume() == nef.volumes_begin()) continue;
    RationalPoint area{0, 0, 0}, base;
    for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle) {
      if (!cycle.is_shalfedge()) continue;
      Nef::SHalfedge_around_facet_const_circulator at(cycle), end(at);
      CGAL_For_all(at, end) {
        const RationalPoint p = point_of(at->source()->source()->point());
        const RationalPoint q = point_of(at->source()->twin()->source()->point());
        for (int k = 0; k < 3; ++k) {
          const int i = (k + 1) % 3, j = (k + 2) % 3;
          area[k] += p[i] * q[j] - p[j] * q[i];
        }
        base = p;
      }
    }
    const Rational product = area[0] * base[0] + area[1] * base[1] + area[2] * base[2];
    // Outward is against the normal of the half-facet; its vector area is parallel to that normal.
    const auto n = f->plane().orthogonal_vector();
    const RationalPoint normal = point_of(CGAL::ORIGIN + n);
    const Rational along = area[0] * normal[0] + area[1] * normal[1] + area[2] * normal[2];
    if (along > 0) sum -= product;
    else sum += product;
  }
  return sum / 6;
}

}  // namespace cnrg::properties
