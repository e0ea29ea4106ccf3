// Euler operators on a complex that is no manifold: each makes or kills one cell (or an edge with its end), and
// the formula of Euler and Poincaré holds after each (Masuda 1993):
//
//   v - e + (f - r) - (V - Vh + Vc) = C - Ch + Cc
//
// An operator is called by what it makes (m, M) and what it kills (k, K): mfKCh makes a face and kills a hole of
// the whole, kfMCh is its inverse. So its name says how the numbers change. What they have become is asked of the
// library: a tree that unites the cells that are there is evaluated, from nothing after each operator.
#include <cnrg.h>

#include <cstdint>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>

using namespace cnrg;

/// A cell is called by its corners: a vertex P, an edge PQ, a face of three or four, the cube of all eight.
using Cell = std::string;
const std::map<char, std::string> kCorners{
    {'A', "[0, 0, 0]"}, {'B', "[4, 0, 0]"}, {'C', "[4, 4, 0]"}, {'D', "[0, 4, 0]"},   // of the cube, below
    {'E', "[0, 0, 4]"}, {'F', "[4, 0, 4]"}, {'G', "[4, 4, 4]"}, {'H', "[0, 4, 4]"},   // and above
    {'P', "[2, 1, 4]"}, {'Q', "[2, 1, 6]"}, {'S', "[6, 1, 6]"}, {'T', "[2, 3, 1]"}};  // on it, over it, in it

struct EulerOperator {
  std::string name;
  std::vector<Cell> cells;  // that it makes or kills
};

const std::vector<EulerOperator> kMaking{
    {"mvC", {"A"}},          {"mev", {"B", "AB"}}, {"mev", {"C", "BC"}}, {"mev", {"D", "CD"}},
    {"meCh", {"DA"}},        {"mfKCh", {"ABCD"}},  {"mev", {"E", "AE"}}, {"mev", {"F", "BF"}},
    {"mev", {"G", "CG"}},    {"mev", {"H", "DH"}}, {"meCh", {"EF"}},     {"meCh", {"FG"}},
    {"meCh", {"GH"}},        {"meCh", {"HE"}},     {"mfKCh", {"ABFE"}},  {"mfKCh", {"BCGF"}},
    {"mfKCh", {"CDHG"}},     {"mfKCh", {"DAEH"}},  {"mfCc", {"EFGH"}},  // the last face closes the box
    {"mVKCc", {"ABCDEFGH"}},                                            // the box is filled
    {"mvr", {"P"}},                             // a point on its top is a ring of that face
    {"mev", {"Q", "PQ"}},                       // a rod on it
    {"mvC", {"S"}},                             // a second piece
    {"meKC", {"QS"}},                           // is joined
    {"meCh", {"SF"}},                           // and the wire closed to a loop
    {"meKr", {"PE"}},                           // on the top, from the point to the border
    {"mvVc", {"T"}},                            // a point inside is a cavity of the volume
    {"meKVc", {"CT"}},                          // until it hangs on the border
    {"meVh", {"AG"}},                           // a wire through the cube: around it is a solid ring
    {"mef", {"BG"}},                            // a diagonal parts a side
    {"mfKVh", {"ABG"}},                         // a face spans the ring
    {"mef", {"AH"}},         {"mfV", {"AGH"}},  // a second one parts the volume
};

// Not the way back: cells go in another order, so that many are killed by another operator than they were made by.
const std::vector<EulerOperator> kKilling{
    {"kfV", {"ABG"}},     {"kef", {"BG"}},         {"kfMVh", {"AGH"}},   {"kef", {"AH"}},
    {"keVh", {"AG"}},     {"keMVc", {"CT"}},       {"kvVc", {"T"}},      {"keMr", {"PE"}},
    {"keCh", {"QS"}},     {"keMC", {"SF"}},        {"kvC", {"S"}},       {"kev", {"Q", "PQ"}},
    {"kvr", {"P"}},       {"kVMCc", {"ABCDEFGH"}}, {"kfCc", {"ABCD"}},   {"kfMCh", {"ABFE"}},
    {"kfMCh", {"BCGF"}},  {"kfMCh", {"CDHG"}},     {"kfMCh", {"DAEH"}},  {"kfMCh", {"EFGH"}},
    {"keCh", {"AB"}},     {"keCh", {"BC"}},        {"keCh", {"CD"}},     {"keCh", {"DA"}},
    {"kev", {"A", "AE"}}, {"kev", {"B", "BF"}},    {"kev", {"C", "CG"}}, {"kev", {"D", "DH"}},
    {"keCh", {"EF"}},     {"kev", {"F", "FG"}},    {"kev", {"G", "GH"}}, {"kev", {"H", "HE"}},
    {"kvC", {"E"}},
};

bool makes(char sign) { return sign == 'm' || sign == 'M'; }
bool is_sign(char c) { return makes(c) || c == 'k' || c == 'K'; }

std::string inverse(std::string name) {
  for (char& c : name) {
    if (is_sign(c)) c = static_cast<char>(makes(c) ? c - 'm' + 'k' : c - 'k' + 'm');
  }
  return name;
}

/// The numbers of the formula, by their signs in it.
const std::vector<std::string> kTerms{"v", "e", "f", "r", "V", "Vh", "Vc", "C", "Ch", "Cc"};
using Terms = std::map<std::string, std::int64_t>;
std::int64_t left(const Terms& t) {
  return t.at("v") - t.at("e") + (t.at("f") - t.at("r")) - (t.at("V") - t.at("Vh") + t.at("Vc"));
}
std::int64_t right(const Terms& t) { return t.at("C") - t.at("Ch") + t.at("Cc"); }

/// Changes the numbers as the name says.
void apply(const std::string& name, Terms& terms) {
  std::int64_t change = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (is_sign(name[i])) {
      change = makes(name[i]) ? 1 : -1;
      continue;
    }
    std::string term(1, name[i]);
    if (i + 1 < name.size() && terms.contains(term + name[i + 1])) term += name[++i];  // Vh, not V
    terms.at(term) += change;
  }
}

std::string leaf(const Cell& cell) {
  if (cell.size() == 8) return "{box: {min: " + kCorners.at(cell.front()) + ", max: " + kCorners.at('G') + "}}";
  std::string corners;
  for (const char c : cell) corners += (corners.empty() ? "" : ", ") + kCorners.at(c);
  return (cell.size() == 1 ? "{points: [" : cell.size() == 2 ? "{polyline: [" : "{polygon: [") + corners + "]}";
}

/// The same numbers by the library, of the union of all cells. What is thin comes first and dominates, so that it
/// stays inside of the cube, too.
Terms evaluated(const std::set<Cell>& cells) {
  Terms terms;
  for (const std::string& term : kTerms) terms[term] = 0;
  if (cells.empty()) return terms;
  std::string nodes, names;
  for (const std::size_t corners : {1, 2, 3, 4, 8}) {
    for (const Cell& cell : cells) {
      if (cell.size() != corners) continue;
      nodes += "  " + cell + ": " + leaf(cell) + "\n";
      names += (names.empty() ? "" : ", ") + cell;
    }
  }
  if (cells.size() > 1) nodes += "  model: {union: [" + names + "], dominance: left}\n";
  const std::string tree = "cnrg: 1\nnodes:\n" + nodes + "result: " + (cells.size() > 1 ? "model" : names) + "\n";
  const Result result = evaluate(parse_tree(tree, "cells.yaml")).result();
  const SimplifiedEuler t = simplified_euler(result.complex(), result.selection(), result.cells());
  terms = {{"v", t.v},        {"e", t.e},       {"f", t.f},
           {"r", t.r},        {"V", t.volumes}, {"Vh", t.volume_holes},
           {"C", t.pieces},   {"Ch", t.holes},  {"Vc", t.volume_cavities},
           {"Cc", t.cavities}};
  return terms;
}

class Model {
 public:
  Model() : terms_(evaluated({})) {}

  /// Applies one after the other; a line for all that are the same and follow each other. False: a number is not
  /// what the library counts, or the formula does not hold.
  bool run(const std::vector<EulerOperator>& operators) {
    std::string text;
    for (std::size_t i = 0; i < operators.size(); ++i) {
      const EulerOperator& next = operators[i];
      for (const Cell& cell : next.cells) {
        if (makes(next.name.front())) cells_.insert(cell);
        else cells_.erase(cell);
        text += " " + cell;
      }
      apply(next.name, terms_);
      if (terms_ != evaluated(cells_) || left(terms_) != right(terms_)) {
        std::cout << next.name << text << ": not what is counted\n";
        return false;
      }
      if (i + 1 < operators.size() && operators[i + 1].name == next.name) continue;
      print(next.name, text);
      text.clear();
    }
    return true;
  }

 private:
  void print(const std::string& name, const std::string& text) const {
    std::cout << std::left << std::setw(6) << name << std::right;
    for (const std::string& term : kTerms) std::cout << std::setw(3) << terms_.at(term);
    std::cout << std::setw(5) << left(terms_) << " = " << std::left << std::setw(3) << right(terms_) << text
              << "\n";
  }

  std::set<Cell> cells_;
  Terms terms_;
};

int main() {
  std::cout << "      ";
  for (const std::string& term : kTerms) std::cout << std::setw(3) << term;
  std::cout << "  formula  cells\n";
  Model model;
  if (!model.run(kMaking) || !model.run(kKilling)) return 1;
  std::set<std::string> names, inverses;
  for (const EulerOperator& o : kMaking) names.insert(o.name);
  for (const EulerOperator& o : kKilling) inverses.insert(inverse(o.name));
  std::cout << names.size() << " operators, " << (names == inverses ? "each" : "not each")
            << " with its inverse, in " << kMaking.size() + kKilling.size() << " steps\n";
}

// Output:
//         v  e  f  r  V Vh Vc  C Ch Cc  formula  cells
// mvC     1  0  0  0  0  0  0  1  0  0    1 = 1   A
// mev     4  3  0  0  0  0  0  1  0  0    1 = 1   B AB C BC D CD
// meCh    4  4  0  0  0  0  0  1  1  0    0 = 0   DA
// mfKCh   4  4  1  0  0  0  0  1  0  0    1 = 1   ABCD
// mev     8  8  1  0  0  0  0  1  0  0    1 = 1   E AE F BF G CG H DH
// meCh    8 12  1  0  0  0  0  1  4  0   -3 = -3  EF FG GH HE
// mfKCh   8 12  5  0  0  0  0  1  0  0    1 = 1   ABFE BCGF CDHG DAEH
// mfCc    8 12  6  0  0  0  0  1  0  1    2 = 2   EFGH
// mVKCc   8 12  6  0  1  0  0  1  0  0    1 = 1   ABCDEFGH
// mvr     9 12  6  1  1  0  0  1  0  0    1 = 1   P
// mev    10 13  6  1  1  0  0  1  0  0    1 = 1   Q PQ
// mvC    11 13  6  1  1  0  0  2  0  0    2 = 2   S
// meKC   11 14  6  1  1  0  0  1  0  0    1 = 1   QS
// meCh   11 15  6  1  1  0  0  1  1  0    0 = 0   SF
// meKr   11 16  6  0  1  0  0  1  1  0    0 = 0   PE
// mvVc   12 16  6  0  1  0  1  1  1  0    0 = 0   T
// meKVc  12 17  6  0  1  0  0  1  1  0    0 = 0   CT
// meVh   12 18  6  0  1  1  0  1  1  0    0 = 0   AG
// mef    12 19  7  0  1  1  0  1  1  0    0 = 0   BG
// mfKVh  12 19  8  0  1  0  0  1  1  0    0 = 0   ABG
// mef    12 20  9  0  1  0  0  1  1  0    0 = 0   AH
// mfV    12 20 10  0  2  0  0  1  1  0    0 = 0   AGH
// kfV    12 20  9  0  1  0  0  1  1  0    0 = 0   ABG
// kef    12 19  8  0  1  0  0  1  1  0    0 = 0   BG
// kfMVh  12 19  7  0  1  1  0  1  1  0    0 = 0   AGH
// kef    12 18  6  0  1  1  0  1  1  0    0 = 0   AH
// keVh   12 17  6  0  1  0  0  1  1  0    0 = 0   AG
// keMVc  12 16  6  0  1  0  1  1  1  0    0 = 0   CT
// kvVc   11 16  6  0  1  0  0  1  1  0    0 = 0   T
// keMr   11 15  6  1  1  0  0  1  1  0    0 = 0   PE
// keCh   11 14  6  1  1  0  0  1  0  0    1 = 1   QS
// keMC   11 13  6  1  1  0  0  2  0  0    2 = 2   SF
// kvC    10 13  6  1  1  0  0  1  0  0    1 = 1   S
// kev     9 12  6  1  1  0  0  1  0  0    1 = 1   Q PQ
// kvr     8 12  6  0  1  0  0  1  0  0    1 = 1   P
// kVMCc   8 12  6  0  0  0  0  1  0  1    2 = 2   ABCDEFGH
// kfCc    8 12  5  0  0  0  0  1  0  0    1 = 1   ABCD
// kfMCh   8 12  0  0  0  0  0  1  5  0   -4 = -4  ABFE BCGF CDHG DAEH EFGH
// keCh    8  8  0  0  0  0  0  1  1  0    0 = 0   AB BC CD DA
// kev     4  4  0  0  0  0  0  1  1  0    0 = 0   A AE B BF C CG D DH
// keCh    4  3  0  0  0  0  0  1  0  0    1 = 1   EF
// kev     1  0  0  0  0  0  0  1  0  0    1 = 1   F FG G GH H HE
// kvC     0  0  0  0  0  0  0  0  0  0    0 = 0   E
// 15 operators, each with its inverse, in 66 steps
