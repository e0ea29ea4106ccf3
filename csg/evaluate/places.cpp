#include "csg/evaluate/places.h"

#include <algorithm>
#include <map>
#include <optional>

#include "csg/result/result_data.h"
#include "kernel/base/error.h"
#include "kernel/base/parallel.h"
#include "kernel/complex/interior.h"

namespace cnrg {
namespace {

using Place = Places::Place;
constexpr std::size_t kWorthAThread = 16;  // points: each is a walk through a tree of boxes, and exact predicates

std::vector<Location> locations(const Locator& locator, std::span<const RationalPoint> points,
                                const Watch& watch) {
  std::vector<Location> out(points.size());
  Steps steps(watch, "locate", points.size());
  for_each_index(
      points.size(),
      [&](std::size_t i) {
        out[i] = locator.locate(points[i]);
        steps.step();
      },
      kWorthAThread);
  return out;
}

/// Numbers of cells without bounds, of a result that was evaluated with a larger frame, in this one.
class CellNumbers {
 public:
  CellNumbers(const Result& here, const Locator& locator, const Result& there)
      : here_(here), locator_(locator), there_(there), there_locator_(there.complex()) {}

  Place of(const Place& place) {
    if (place.index == SimplifiedComplex::kNowhere) return place;
    auto& numbers = numbers_[place.dimension];
    if (!numbers) numbers = numbers_of(place.dimension);
    const auto found = numbers->find(place.index);
    require(found != numbers->end(), "Places: a cell beyond the frame that is not within it");
    return {place.dimension, found->second};
  }

 private:
  const Result& here_;
  const Locator& locator_;
  const Result& there_;
  const Locator there_locator_;
  std::array<std::optional<std::map<std::uint32_t, std::uint32_t>>, 4> numbers_;

  std::map<std::uint32_t, std::uint32_t> numbers_of(int dimension) const {
    const Complex& complex = here_.complex();
    const SimplifiedComplex& cells = here_.cells();
    std::map<std::uint32_t, std::uint32_t> numbers;
    const auto add = [&](std::size_t i, const RationalPoint& p) {
      const Place there = there_.place(there_locator_.locate(p));
      require(there.dimension == dimension, "Places: a cell is of another dimension with a larger frame");
      numbers[there.index] = static_cast<std::uint32_t>(i);
    };
    const auto reaches = [&](HalfEdge h) {
      return complex.on_frame(complex.origin(h)) || complex.on_frame(complex.target(h));
    };
    if (dimension == 1) {
      for (std::size_t i = 0; i < cells.edges.size(); ++i) {
        const auto& chain = cells.edges[i].chain;
        if (std::none_of(chain.begin(), chain.end(), reaches)) continue;
        add(i, interior_point(complex, chain.front().edge()).rational());
      }
    } else if (dimension == 2) {
      for (std::size_t i = 0; i < cells.faces.size(); ++i) {
        bool any = false;
        for (const auto& loop : cells.faces[i].loops) any = any || std::any_of(loop.begin(), loop.end(), reaches);
        if (any) add(i, interior_point(complex, cells.faces[i].cells.front().face()).rational());
      }
    } else if (dimension == 3) {
      for (std::size_t i = 0; i < cells.regions.size(); ++i) {
        const std::vector<RegionId>& regions = cells.regions[i].cells;
        const auto inside = [&](RegionId r) { return complex.unbounded(r) && !complex.outside_frame(r); };
        const auto found = std::find_if(regions.begin(), regions.end(), inside);
        if (found != regions.end()) add(i, interior_point(complex, locator_, *found));
      }
    }
    return numbers;
  }
};

}  // namespace

struct Places::Data {
  Result result;
  std::shared_ptr<const Tree> tree;
  NodeId node;
  Locator locator;

  Data(Result r, std::shared_ptr<const Tree> t, NodeId n)
      : result(std::move(r)), tree(std::move(t)), node(n), locator(result.complex()) {}
};

Places::Places(Result result, std::shared_ptr<const Tree> tree, NodeId node)
    : data_(std::make_unique<Data>(std::move(result), std::move(tree), node)) {}
Places::~Places() = default;

std::vector<Place> Places::of(std::span<const RationalPoint> points, const Watch& watch, int threads) const {
  const Complex& complex = data_->result.complex();
  const std::vector<Location> found = locations(data_->locator, points, watch);
  std::vector<Place> out(points.size());
  std::vector<std::size_t> beyond;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (beyond_frame(complex, found[i])) beyond.push_back(i);
    else out[i] = data_->result.place(found[i]);
  }
  if (beyond.empty()) return out;
  std::vector<RationalPoint> far;
  for (const std::size_t i : beyond) {
    const std::string what = "point " + std::to_string(i) + ": ";
    if (data_->tree == nullptr) {
      throw InputError(what +
                       "it lies beyond the box to which planes and half-spaces were cut, and this result has no "
                       "tree to evaluate again; give nearer points");
    }
    if (const std::string fault = too_far(points[i]); !fault.empty()) throw InputError(what + fault);
    far.push_back(points[i]);
  }
  EvaluateOptions options;
  options.threads = threads;
  options.rows = Rows::none;
  options.raw = data_->result.data().raw;
  options.result = data_->node;
  options.reach = far;
  options.watch = watch;
  const Result larger = evaluate(*data_->tree, options).result(data_->node);
  CellNumbers numbers(data_->result, data_->locator, larger);
  const Locator locator(larger.complex());
  const std::vector<Location> there = locations(locator, far, watch);
  for (std::size_t k = 0; k < far.size(); ++k) {
    require(!beyond_frame(larger.complex(), there[k]), "Places: a point is beyond the frame that was to hold it");
    out[beyond[k]] = numbers.of(larger.place(there[k]));
  }
  return out;
}

std::string too_far(const RationalPoint& p) {
  const Rational limit(Integer(1) << 1000);  // the frame is some times as large, and of doubles
  const auto is_far = [&](const Rational& x) { return abs(x) > limit; };
  if (std::none_of(p.begin(), p.end(), is_far)) return {};
  return "this point is too far away for a tree with planes or half-spaces; its coordinates may be up to 2^1000, "
         "about "
         "1e301";
}

}  // namespace cnrg
