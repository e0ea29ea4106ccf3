// One run of one system on one problem, judged: the record that sweeps collect and reports are made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cnrg::bench {

enum class Verdict : std::uint8_t {
  same,                ///< the exact point set (up to the system's stated rounding), each contact once
  same_regularized,    ///< the closure of the interior: what the operation makes of lower dimension is missing
  contact_duplicated,  ///< the point set, but edges or vertices at a non-manifold contact are there twice or more
  contact_lost,     ///< parts that touch in the exact result do not, or the other way round (rounded coordinates)
  dangling_lost,    ///< a surface, wire or point of an operand that the exact result has is missing
  within_rounding,  ///< as much volume up to the system's stated rounding, but with other shells or handles
  wrong,            ///< anything else: volume or surface too much or too little, or no solid at all
  refused,          ///< the system says that it cannot
  crashed,
  timed_out,
  out_of_memory,
  unjudged,  ///< there is a result, but the exact one could not be had within the limits
};
inline constexpr std::size_t kVerdicts = 12;
/// `same`, `same-regularized`, ... as in files.
const char* to_string(Verdict verdict);
std::optional<Verdict> parse_verdict(const std::string& text);
/// No result, or a wrong one: what a failure rate counts. The others are right by some contract, or unjudged.
bool is_failure(Verdict verdict);

/// What is counted in a point set, simplified to its canonical form: no coplanar faces and collinear edges apart.
struct Facts {
  std::string volume = "0";  ///< exact, p or p/q, cubic units
  std::size_t vertices = 0, edges = 0, faces = 0, regions = 0;
  std::size_t shells = 0;  ///< of the boundary of its solid, as a surface
  long genus = 0;          ///< handles of those shells together, pulled apart at contacts
  std::size_t non_manifold_edges = 0, non_manifold_vertices = 0;
  std::size_t dangling_faces = 0, dangling_edges = 0, dangling_vertices = 0;  ///< bound no solid
};

/// The exact result of a problem and who agrees.
struct Truth {
  Facts facts;
  /// `Nef`: Nef polyhedra have the same point set, compared by CGAL alone; `Nef-by-us`: compared by our kernel.
  /// `volume`: the volume agrees with corefinement to 1e-9. `node`, `formula`: what the experiment claims. `none`:
  /// neither was possible; `reason` says why. `DISAGREES`: one of them has another result.
  std::string confirmed = "none", reason;
  // Not in rows: the file or folder of the experiment, and a digest of the operands.
  std::string experiment{}, digest{};
};

/// Who confirms the verdict of a row, without the kernel. `Nef`: CGAL compares the result itself. `integrals`: of
/// the difference of result and Boolean, exact. `points`: random ones, exact; both look at solids alone. `none`:
/// nobody could; `reason` says why. `DISPUTED`: one of them contradicts. `no-verdict`: there is none to confirm.
struct Confirmation {
  std::string by = "no-verdict", reason{};
};

struct SweepRow {
  std::string problem, family;                ///< `family`: the experiment's name
  std::map<std::string, std::string> values;  ///< of its parameters, and its `node`
  std::string operation;                      ///< of the problem; `fold` where it mixes them
  long size = 1;                              ///< the parameter `size`, else the triangles; 0 of sets and regions
  std::optional<int> distance;                ///< the parameter `k`, of 10^-k; none: `exact`, or there is none
  bool has_distance = false;
  unsigned seed = 1;
  std::size_t operands = 0, triangles = 0;  ///< of all operands

  std::string system;
  Verdict verdict = Verdict::wrong;
  std::string stage, message;  ///< of a refusal, failure or wrong result; a signal of a crash
  std::vector<std::pair<std::string, double>> stages;  ///< seconds, of runs that gave a result
  std::vector<double> warm{};                          ///< seconds of runs after that one, in the same process
  std::optional<double> asserted_seconds{};  ///< of the same run with CGAL's assertions, which are off in these
  double seconds = 0;          ///< of those together; wall time of the process when there is no result
  std::size_t peak_bytes = 0;  ///< resident, the program and its input included
  std::size_t own_bytes = 0;   ///< of the run alone
  double exact_share = -1;     ///< see Answer; negative: not said
  std::string note;

  std::optional<Facts> facts;      ///< of the result
  double excess = 0, missing = 0;  ///< volumes of result - truth, truth - result as parts of the truth's
  std::size_t duplicates = 0;      ///< vertices of the result at the place of another one
  Truth truth;
  Confirmation confirmation{};
  double limit_seconds = 0;
  std::size_t limit_bytes = 0;
  double load = 0;      ///< of the machine in the minute before
  std::string command;  ///< reproduces the row
};

/// JSON objects on one line and back. Parts of volumes that are not finite are `null` there and come back as not a
/// number. The readers throw std::runtime_error for what is no such object, with the member that is wrong.
std::string to_json(const SweepRow& row);
SweepRow row_of_json(const std::string& text);
std::string to_json(const Truth& truth);
Truth truth_of_json(const std::string& text);
std::string to_json(const Facts& facts);
Facts facts_of_json(const std::string& text);

}  // namespace cnrg::bench
