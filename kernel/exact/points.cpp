// Points and planes: arrays of enclosures and definitions, and exact values that are computed on first use.
//
// All exact work is on homogeneous integers: no fraction is ever reduced but at the end.
#include "kernel/exact/points.h"

#include <atomic>
#include <bit>
#include <cstdlib>

#include "kernel/base/error.h"
#include "kernel/exact/enclosure.h"
#include "kernel/exact/integers.h"

namespace cnrg {

using namespace enclosure;

namespace {

/// Divides by the gcd and makes w positive.
void canonicalize(ExactPoint& p) {
  Integer g = gcd(gcd(p.x, p.y), gcd(p.z, p.w));
  if (sgn(p.w) < 0) g = -g;
  if (g == 1) return;
  for (Integer* const c : {&p.x, &p.y, &p.z, &p.w}) mpz_divexact(c->get_mpz_t(), c->get_mpz_t(), g.get_mpz_t());
}

/// The point of three doubles over a common power of two.
ExactPoint from_doubles(const double* c) {
  int exponents[3];
  std::int64_t mantissas[3];
  int lowest = 0;
  for (int k = 0; k < 3; ++k) {
    const double fraction = std::frexp(c[k], &exponents[k]);
    mantissas[k] = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    exponents[k] -= 53;
    while (mantissas[k] != 0 && mantissas[k] % 2 == 0) {
      mantissas[k] /= 2;
      ++exponents[k];
    }
    if (mantissas[k] == 0) exponents[k] = 0;
    lowest = std::min(lowest, exponents[k]);
  }
  ExactPoint p;
  Integer* out[3] = {&p.x, &p.y, &p.z};
  for (int k = 0; k < 3; ++k) {
    *out[k] = to_integer(mantissas[k]);
    mpz_mul_2exp(out[k]->get_mpz_t(), out[k]->get_mpz_t(), static_cast<mp_bitcnt_t>(exponents[k] - lowest));
  }
  mpz_mul_2exp(p.w.get_mpz_t(), p.w.get_mpz_t(), static_cast<mp_bitcnt_t>(-lowest));
  return p;
}

Integer at(const ExactPlane& e, const ExactPoint& p) { return e.a * p.x + e.b * p.y + e.c * p.z + e.d * p.w; }

/// A positive multiple of b - a, where w of both is positive.
std::array<Integer, 3> way_between(const ExactPoint& a, const ExactPoint& b) {
  return {b.x * a.w - a.x * b.w, b.y * a.w - a.y * b.w, b.z * a.w - a.z * b.w};
}
/// The plane through a with a normal.
ExactPlane plane_at(const ExactPoint& a, const std::array<Integer, 3>& n) {
  return {n[0] * a.w, n[1] * a.w, n[2] * a.w, -(n[0] * a.x + n[1] * a.y + n[2] * a.z)};
}

/// The plane through three points, w of each positive: normal (b-a) x (c-a).
ExactPlane plane_through(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  ExactPlane e = plane_at(a, cross(way_between(a, b), way_between(a, c)));
  const Integer g = gcd(gcd(e.a, e.b), gcd(e.c, e.d));
  if (sgn(g) != 0 && g != 1) {
    e.a /= g;
    e.b /= g;
    e.c /= g;
    e.d /= g;
  }
  return e;
}

ExactPoint line_plane(const ExactPoint& a, const ExactPoint& b, const ExactPlane& e) {
  const Integer sa = at(e, a), sb = at(e, b);
  return {sb * a.x - sa * b.x, sb * a.y - sa * b.y, sb * a.z - sa * b.z, sb * a.w - sa * b.w};
}

/// Minor of the columns i, j, k of three planes.
Integer minor(const std::array<const Integer*, 4>& r0, const std::array<const Integer*, 4>& r1,
              const std::array<const Integer*, 4>& r2, int i, int j, int k) {
  return *r0[i] * (*r1[j] * *r2[k] - *r1[k] * *r2[j]) - *r0[j] * (*r1[i] * *r2[k] - *r1[k] * *r2[i]) +
         *r0[k] * (*r1[i] * *r2[j] - *r1[j] * *r2[i]);
}

ExactPoint three_planes(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r) {
  const std::array<const Integer*, 4> rows[3] = {
      {&p.a, &p.b, &p.c, &p.d}, {&q.a, &q.b, &q.c, &q.d}, {&r.a, &r.b, &r.c, &r.d}};
  const auto of = [&](int i, int j, int k) { return minor(rows[0], rows[1], rows[2], i, j, k); };
  return {of(1, 2, 3), -of(0, 2, 3), of(0, 1, 3), -of(0, 1, 2)};
}

/// The plane that holds the line cd and the direction of axis k.
ExactPlane plane_along_axis(const ExactPoint& c, const ExactPoint& d, int k) {
  std::array<Integer, 3> axis{0, 0, 0};
  axis[static_cast<std::size_t>(k)] = 1;
  return plane_at(c, cross(way_between(c, d), axis));
}

/// The nearest doubles that are not above a number, and not below it.
std::array<double, 2> bounds_of(const Rational& x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double d = to_double(x);
  if (d == kInfinity) return {std::numeric_limits<double>::max(), kInfinity};
  if (d == -kInfinity) return {-kInfinity, std::numeric_limits<double>::lowest()};
  const int order = cmp(from_double(d), x);
  return {order > 0 ? std::nextafter(d, -kInfinity) : d, order < 0 ? std::nextafter(d, kInfinity) : d};
}

/// Values by key, each made on first use and never moved; threads may ask at any time.
///
/// A map behind locks spends more on its nodes and locks than most values cost to look at. Here the slots of keys
/// stand in blocks, each as long as all before it, which are made when first touched and never grow: a slot that
/// was filled is read without a lock. Slots that nobody asks for stay pages of zeros, which take no memory.
template <class Value>
class Cache {
 public:
  Cache() = default;
  Cache(const Cache&) = delete;
  Cache& operator=(const Cache&) = delete;
  ~Cache() {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      Value** const slots = blocks_[b].load();
      if (slots == nullptr) continue;
      for (std::size_t i = 0; i < length(b); ++i) delete slots[i];
      std::free(slots);
    }
  }

  template <class Make>
  const Value& get(std::uint32_t key, Make&& make) {
    const std::atomic_ref<Value*> slot(slot_of(key));
    if (const Value* known = slot.load(std::memory_order_acquire)) return *known;
    auto made = std::make_unique<Value>(make());
    Value* other = nullptr;
    if (!slot.compare_exchange_strong(other, made.get(), std::memory_order_acq_rel)) return *other;
    size_.fetch_add(1, std::memory_order_relaxed);
    return *made.release();
  }
  std::size_t size() const { return size_.load(); }

 private:
  static constexpr int kFirst = 10;  // the first block has 2^10 slots, and so has the second
  static std::size_t length(std::size_t b) { return std::size_t{1} << (b == 0 ? kFirst : kFirst + b - 1); }

  Value*& slot_of(std::uint32_t key) {
    const auto b = static_cast<std::size_t>(std::bit_width(key >> kFirst));
    Value** slots = blocks_[b].load(std::memory_order_acquire);
    if (slots == nullptr) {
      auto* const made = static_cast<Value**>(std::calloc(length(b), sizeof(Value*)));
      if (made == nullptr) throw std::bad_alloc();
      if (blocks_[b].compare_exchange_strong(slots, made, std::memory_order_acq_rel)) {
        slots = made;
      } else {
        std::free(made);
      }
    }
    return slots[b == 0 ? key : key - length(b)];
  }

  std::array<std::atomic<Value**>, 33 - kFirst> blocks_{};
  std::atomic<std::size_t> size_ = 0;
};

}  // namespace

RationalPoint ExactPoint::rational() const {
  RationalPoint r{Rational(x, w), Rational(y, w), Rational(z, w)};
  for (Rational& c : r) c.canonicalize();
  return r;
}

ExactPoint ExactPoint::from(const RationalPoint& p) {
  ExactPoint e;
  e.w = lcm(lcm(p[0].get_den(), p[1].get_den()), p[2].get_den());
  e.x = p[0].get_num() * (e.w / p[0].get_den());
  e.y = p[1].get_num() * (e.w / p[1].get_den());
  e.z = p[2].get_num() * (e.w / p[2].get_den());
  return e;
}

struct PointTable::Caches {
  Cache<ExactPoint> points;
  Cache<ExactPlane> planes;
};

PointTable::PointTable() : caches_(std::make_unique<Caches>()) {}
PointTable::~PointTable() = default;
PointTable::PointTable(PointTable&&) noexcept = default;
PointTable& PointTable::operator=(PointTable&&) noexcept = default;

void PointTable::reserve(std::size_t n) {
  lo_.reserve(3 * n);
  row_.reserve(n);
}

void PointTable::add(std::span<const double> xyz) {
  lo_.insert(lo_.end(), xyz.begin(), xyz.end());
  row_.resize(lo_.size() / 3, kDouble);
  check_count(row_.size(), kPlural<VertexId>);
}

VertexId PointTable::last() const {
  check_count(row_.size(), kPlural<VertexId>);
  return VertexId(row_.size() - 1);
}

VertexId PointTable::add(double x, double y, double z) {
  lo_.insert(lo_.end(), {x + 0.0, y + 0.0, z + 0.0});  // no zero keeps a sign: it would say how the point was made
  row_.push_back(kDouble);
  return last();
}

VertexId PointTable::add(const RationalPoint& p) {
  std::array<double, 3> lo, hi;
  bool doubles = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = bounds_of(p[k]);
    lo[k] = low, hi[k] = high;
    doubles = doubles && lo[k] == hi[k];
  }
  if (doubles) return add(lo[0], lo[1], lo[2]);
  const VertexId v = add(Definition{Definition::Kind::line_plane, {}, {}}, lo, hi);
  caches_->points.get(v.value(), [&] { return ExactPoint::from(p); });
  return v;
}

VertexId PointTable::add(const Definition& definition) {
  std::array<double, 3> lo, hi;
  enclose(definition, lo, hi);
  return add(definition, lo, hi);
}

VertexId PointTable::add(const Definition& definition, const std::array<double, 3>& lo,
                         const std::array<double, 3>& hi) {
  lo_.insert(lo_.end(), lo.begin(), lo.end());
  row_.push_back(static_cast<std::uint32_t>(upper_.size()));
  upper_.push_back(hi);
  definitions_.push_back(definition);
  return last();
}

PlaneId PointTable::add_plane(VertexId a, VertexId b, VertexId c) {
  check_count(planes_.size() + 1, "planes");
  planes_.push_back({a, b, c});
  return PlaneId(planes_.size() - 1);
}

void PointTable::normal(PlaneId plane, std::array<double, 3>& lo, std::array<double, 3>& hi) const {
  const auto& [a, b, c] = planes_[plane.index()];
  RoundOutward round;
  const Interval3 n = enclosure::normal(view(a), view(b), view(c));
  for (int k = 0; k < 3; ++k) {
    lo[k] = n[k].inf();
    hi[k] = n[k].sup();
  }
}

bool PointTable::is_constructed(VertexId v) const {
  const std::uint32_t row = row_[v.index()];
  if (row == kDouble) return false;
  const Definition& d = definitions_[row];
  return d.points[0].valid() || d.planes[0].valid();
}

std::array<double, 3> PointTable::approx(VertexId v) const {
  const double* lo = lo_.data() + 3 * v.index();
  const std::uint32_t row = row_[v.index()];
  if (row == kDouble) return {lo[0], lo[1], lo[2]};
  const auto& hi = upper_[row];
  std::array<double, 3> c;
  for (int k = 0; k < 3; ++k) c[k] = lo[k] == hi[k] ? lo[k] : lo[k] / 2 + hi[k] / 2;
  if (std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2])) return c;
  return nearest(v);
}

const ExactPoint& PointTable::exact(VertexId v) const {
  return caches_->points.get(v.value(), [&] {
    const std::uint32_t row = row_[v.index()];
    if (row != kDouble) return exact_value(definitions_[row]);
    ExactPoint p = from_doubles(lo_.data() + 3 * v.index());
    canonicalize(p);
    return p;
  });
}

ExactPoint PointTable::exact_value(const Definition& d) const {
  ExactPoint p;
  switch (d.kind) {
    case Definition::Kind::line_plane:
      p = line_plane(exact(d.points[0]), exact(d.points[1]), exact_plane(d.planes[0]));
      break;
    case Definition::Kind::three_planes:
      p = three_planes(exact_plane(d.planes[0]), exact_plane(d.planes[1]), exact_plane(d.planes[2]));
      break;
    case Definition::Kind::line_line:
      for (int k = 0; k < 3 && (k == 0 || sgn(p.w) == 0); ++k) {
        p = line_plane(exact(d.points[0]), exact(d.points[1]),
                       plane_along_axis(exact(d.points[2]), exact(d.points[3]), k));
      }
      break;
  }
  require(sgn(p.w) != 0, "a constructed point is at infinity");
  canonicalize(p);
  return p;
}

const ExactPlane& PointTable::exact_plane(PlaneId plane) const {
  return caches_->planes.get(plane.value(), [&] {
    const auto& [a, b, c] = planes_[plane.index()];
    return plane_through(exact(a), exact(b), exact(c));
  });
}

std::array<double, 3> PointTable::nearest(VertexId v) const {
  if (is_double(v)) {
    const double* lo = lo_.data() + 3 * v.index();
    return {lo[0], lo[1], lo[2]};
  }
  const PointView p = view(v);
  if (p.lo == p.hi) return p.lo;
  const RationalPoint r = rational(v);
  return {to_double(r[0]), to_double(r[1]), to_double(r[2])};
}

void PointTable::enclose(const Definition& d, std::array<double, 3>& lo, std::array<double, 3>& hi) const {
  RoundOutward round;
  Interval3 x;
  switch (d.kind) {
    case Definition::Kind::line_plane: {
      // a + (n.(p - a)) (b - a) / (n.(b - a)): one division, last, so that points on a grid come out exactly.
      const auto& [pa, pb, pc] = planes_[d.planes[0].index()];
      const Interval3 n = enclosure::normal(view(pa), view(pb), view(pc));
      const Interval3 a = of(view(d.points[0])), u = of(view(d.points[1])) - a;
      const Interval numerator = dot(n, of(view(pa)) - a), denominator = dot(n, u);
      for (int k = 0; k < 3; ++k) x[k] = a[k] + numerator * u[k] / denominator;
      break;
    }
    case Definition::Kind::three_planes: {
      Interval3 n[3], p[3];
      for (int i = 0; i < 3; ++i) {
        const auto& [pa, pb, pc] = planes_[d.planes[i].index()];
        n[i] = enclosure::normal(view(pa), view(pb), view(pc));
        p[i] = of(view(pa));
      }
      const Interval d1 = dot(n[1], p[1] - p[0]), d2 = dot(n[2], p[2] - p[0]);
      const Interval3 c1 = cross(n[2], n[0]), c2 = cross(n[0], n[1]);
      const Interval determinant = dot(n[2], c2);
      for (int k = 0; k < 3; ++k) x[k] = p[0][k] + (d1 * c1[k] + d2 * c2[k]) / determinant;
      break;
    }
    case Definition::Kind::line_line: {
      const Interval3 a = of(view(d.points[0])), u = of(view(d.points[1])) - a;
      const Interval3 c = of(view(d.points[2])), v = of(view(d.points[3])) - c;
      const Interval3 uv = cross(u, v), wv = cross(c - a, v);
      int k = 0;
      double best = -1;
      for (int i = 0; i < 3; ++i) {
        const double size = uv[i].inf() > 0 ? uv[i].inf() : (uv[i].sup() < 0 ? -uv[i].sup() : -1);
        if (size > best) {
          best = size;
          k = i;
        }
      }
      for (int i = 0; i < 3; ++i) x[i] = a[i] + wv[k] * u[i] / uv[k];
      break;
    }
  }
  for (int k = 0; k < 3; ++k) {
    lo[k] = x[k].inf() + 0.0;  // no zero keeps a sign, as in `add`
    hi[k] = x[k].sup() + 0.0;
    if (!(lo[k] <= hi[k])) {  // overflow on the way: only the exact stage can tell
      lo[k] = -std::numeric_limits<double>::infinity();
      hi[k] = std::numeric_limits<double>::infinity();
    }
  }
}

std::size_t PointTable::memory() const {
  return lo_.capacity() * sizeof(double) + row_.capacity() * sizeof(std::uint32_t) +
         upper_.capacity() * (sizeof(std::array<double, 3>) + sizeof(Definition)) +
         planes_.capacity() * sizeof(std::array<VertexId, 3>) +
         caches_->points.size() * (sizeof(ExactPoint) + 64) + caches_->planes.size() * (sizeof(ExactPlane) + 64);
}

const ExactPoint& PointView::exact() const { return value != nullptr ? *value : table->exact(id); }

PointView view_of(const ExactPoint& value) {
  PointView p{{}, {}, nullptr, VertexId::none(), &value};
  const RationalPoint r = value.rational();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = bounds_of(r[k]);
    p.lo[k] = low, p.hi[k] = high;
  }
  return p;
}

}  // namespace cnrg
