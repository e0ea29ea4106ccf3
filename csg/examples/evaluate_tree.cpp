// A tree as a text, evaluated: one row per node, operands before users.
//
// `read_tree("model.yaml")` does the same for a file. Faults of the text are TreeErrors, whose `what()` begins
// with file, line and column.
#include <cnrg.h>

#include <iostream>

const char* const kModel = R"(cnrg: 1
nodes:
  block: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  sheet: {polygon: [[2, 0, 0], [2, 4, 0], [2, 4, 4], [2, 0, 4]]}
  shaft: {box: {min: [1, 1, -1], max: ["4/3", 2, 5]}}
  split: {union: [sheet, block], dominance: left}
  model: {difference: [split, shaft]}
result: model
)";

int main() {
  const cnrg::Evaluation evaluation = cnrg::evaluate(cnrg::parse_tree(kModel, "model.yaml"));
  for (const cnrg::NodeRow& row : evaluation.rows) {
    std::cout << row.name << " (" << row.operator_name << "):";
    for (const std::size_t cells : row.cells) std::cout << " " << cells;
    std::cout << ", removed " << row.removed() << ", volume " << row.volume().value() << "\n";
  }
  try {
    cnrg::parse_tree("cnrg: 1\nnodes: {a: {union: [b, c]}}\nresult: a\n", "faulty.yaml");
  } catch (const cnrg::InputError& e) {
    std::cout << e.what() << "\n";
  }
}

// Output:
// sheet (polygon): 4 4 1 0, removed 0, volume 0
// block (box): 8 12 6 1, removed 0, volume 64
// split (union): 12 20 11 2, removed 0, volume 64
// shaft (box): 8 12 6 1, removed 0, volume 2
// model (difference): 20 32 15 2, removed 36, volume 188/3
// faulty.yaml:2:21: error: there is no node called `b`; add it to `nodes` or use another name
