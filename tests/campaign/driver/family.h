// A family of trials: random cases of one kind, and the oracle that judges them.
//
// A trial is a family and a seed, nothing else, so that each can be made again anywhere. What it means to fail is
// in three words: `wrong` (the oracle says something else), `declined` (an error where none is expected) and
// `unknown` (the oracle itself failed: nothing is known).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cnrg::campaign {

enum class Verdict : std::uint8_t { right, wrong, declined, unknown };
const char* name(Verdict verdict);

struct Outcome {
  Verdict verdict = Verdict::right;
  std::string message{};
};

/// Runs a comparison, which returns the first difference in words or an empty string, and judges what it throws:
/// an input error is `declined`, a failure of the oracle `unknown`, everything else `wrong`.
Outcome judge(const std::function<std::string()>& compare);

/// How shrinking asks for a verdict: by `judge`, or in a process of its own (isolated.h).
using Judge = std::function<Outcome(const std::function<std::string()>&)>;

struct Shrunk {
  Outcome outcome;
  std::string text;  ///< a tree file, or as much of one as the case has
};

class Family {
 public:
  Family(std::string name, std::string oracle, double share)
      : name_(std::move(name)), oracle_(std::move(oracle)), share_(share) {}
  virtual ~Family() = default;
  const std::string& name() const { return name_; }
  const std::string& oracle() const { return oracle_; }
  /// Of the time of a campaign, relative to the other families.
  double share() const { return share_; }

  virtual Outcome trial(std::uint64_t seed) const = 0;
  /// The case as it is made.
  virtual std::string text(std::uint64_t seed) const = 0;
  /// The smallest case found that fails like this one; `keep` is called with each that is smaller than the one
  /// before, so that whoever runs out of time has the last of them.
  virtual Shrunk shrink(std::uint64_t seed, const Judge& judge,
                        const std::function<void(const Shrunk&)>& keep) const = 0;

 private:
  std::string name_, oracle_;
  double share_;
};

/// A family from functions.
template <class Case>
struct Recipe {
  std::string name, oracle;
  double share = 1;
  std::function<Case(std::uint64_t seed)> make;
  std::function<std::string(const Case&)> compare;
  std::function<std::vector<Case>(const Case&)> smaller;
  std::function<std::string(const Case&)> text;
};

template <class Case>
class FamilyOf : public Family {
 public:
  explicit FamilyOf(Recipe<Case> recipe)
      : Family(recipe.name, recipe.oracle, recipe.share), recipe_(std::move(recipe)) {}

  Outcome trial(std::uint64_t seed) const override {
    return judge([&] { return recipe_.compare(recipe_.make(seed)); });
  }

  std::string text(std::uint64_t seed) const override { return recipe_.text(recipe_.make(seed)); }

  Shrunk shrink(std::uint64_t seed, const Judge& judge,
                const std::function<void(const Shrunk&)>& keep) const override {
    Case least = recipe_.make(seed);
    Shrunk out{judge([&] { return recipe_.compare(least); }), recipe_.text(least)};
    keep(out);
    for (bool progress = out.outcome.verdict != Verdict::right; progress;) {
      progress = false;
      for (Case& less : recipe_.smaller(least)) {
        const Outcome outcome = judge([&] { return recipe_.compare(less); });
        if (outcome.verdict != out.outcome.verdict) continue;
        least = std::move(less);
        out = {outcome, recipe_.text(least)};
        keep(out);
        progress = true;
        break;
      }
    }
    return out;
  }

 private:
  Recipe<Case> recipe_;
};

using Families = std::vector<std::unique_ptr<const Family>>;

template <class Case>
void add(Families& families, Recipe<Case> recipe) {
  families.push_back(std::make_unique<FamilyOf<Case>>(std::move(recipe)));
}

}  // namespace cnrg::campaign
