// An experiment: problems by the values of parameters, the systems that get them, limits, and what is known of the
// results. It is a file, or a folder of meshes.
//
// A file is a tree (csg/FORMATS.md) whose key `x-experiment` says which values its `parameters` take and which of
// its nodes are problems; bench/README.md, Experiments, has all keys. In place of a tree it may name a program
// that prints one, or a family of problems (bench/cases/family.h).
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bench/cases/family.h"

namespace cnrg::bench {

/// Of a problem, by the parameter's name: exact numbers in lowest terms, or words.
using Values = std::map<std::string, std::string>;

struct Parameter {
  std::string name;
  std::vector<std::string> values;
  std::vector<std::string> usual{};  ///< those of the file
  std::string means{};               ///< for people; may be empty
};

/// What is known of the result of a node: its volume, an expression, or another node that is the same point set.
struct Claim {
  std::string volume, node;
};

/// A program as a system: see `external_system`.
struct ProgramSystem {
  std::string name;
  std::vector<std::string> words;  ///< the program, absolute, and options before its operands
  double rounding = 1e-12;
  std::optional<int> rescale;  ///< as of `rescaled` (bench/peers/system.h)
  friend bool operator==(const ProgramSystem&, const ProgramSystem&) = default;
};

/// What a claim says of a problem.
struct Claimed {
  std::optional<Rational> volume;
  std::optional<Model> result;
};

/// What of a node is compared.
enum class Compared : std::uint8_t {
  results,  ///< the point set that a system makes of its operands: of a union, intersection or difference
  sets,     ///< the value as a set of marked cells, by a system itself: of any operator
  regions,  ///< the regions of the value, by a system that parts space
};

struct Experiment {
  std::string name;  ///< of the file without its ending; of letters, digits, `.`, `_` and `-`
  std::string title;
  std::string path;    ///< absolute
  std::string text{};  ///< of the file; empty for a folder
  std::string family{};
  std::vector<std::string> program{};  ///< may have expressions
  std::vector<std::string> nodes{};
  Compared compared = Compared::results;
  std::vector<Parameter> parameters{};
  std::map<std::string, Claim> claims{};  ///< by node
  std::vector<std::string> systems{};     ///< names; empty: all
  std::vector<ProgramSystem> programs{};
  std::optional<double> seconds{}, gigabytes{};  ///< limits of a run
  int warm_runs = 0;                             ///< after the first one
  std::string growth = "triangles";              ///< what costs are drawn against: that or `size`

  bool is_folder() const { return text.empty(); }
  bool is_own() const;  ///< of this source
  const Parameter* parameter(const std::string& name) const;

  struct Named {
    std::string name;
    Values values;  ///< `node`, too, of a tree
  };
  /// All, in the order of the parameters; names are `EXPERIMENT-NODE-NAMEvalue...`, those of a family as
  /// `ProblemId`. Throws std::runtime_error if two have one name.
  std::vector<Named> problems() const;
  /// Throws std::runtime_error and what reading and evaluating trees throws.
  Problem make(const Named& problem) const;
  /// Of one that compares sets or regions.
  Tree tree(const Named& problem) const;
  /// Throws as `make` does for what costs little to tell.
  void check(const Named& problem) const;
  /// Throws as `make` does.
  Claimed claimed(const Named& problem) const;
  /// How rows tell what parameters are: an operation, a size (0: none), a distance k (none; nobody: `exact`), a
  /// seed.
  ProblemId roles(const Named& problem) const;
};

/// `NAME=VALUE,LOW..HIGH,...`: values in place of those of the file.
struct GivenValues {
  std::string name;
  std::vector<std::string> values;
};
/// Throws std::runtime_error for a text that is none.
GivenValues given_values(const std::string& text);

/// The name of an experiment of this source (bench/experiments), the path of a file, or a folder of meshes; `used`
/// gets the names of those given that it has. One for each kind of what is compared: those of sets and regions are
/// called `NAME.sets`, `NAME.regions`. Throws std::runtime_error with what there is, and TreeError for a fault of
/// a file.
std::vector<Experiment> read_experiments(const std::string& name, const std::vector<GivenValues>& given,
                                         std::set<std::string>& used);
/// A number that tells texts apart (FNV-1a of 64 bits).
std::string digest(const std::string& text);

/// Of this source, sorted.
std::vector<std::string> experiment_names();

}  // namespace cnrg::bench
