// One call of each room, so that all of the library is linked: a tree read and evaluated, a point located, a mesh
// read, files written.
#include <cnrg.h>

#include <iostream>

int main() {
  const cnrg::Tree tree = cnrg::parse_tree(R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  b: {sphere: {center: [2, 2, 2], radius: "1/2", segments: 8}}
  m: {difference: [a, b]}
result: m
)",
                                           "model.yaml");
  const cnrg::Evaluation evaluation = cnrg::evaluate(tree);
  const cnrg::Result model = evaluation.result("m");
  const cnrg::Locator locator(model.complex());
  const cnrg::Location center = locator.locate({1, 1, 1});
  std::cout << "a " << evaluation.rows.front().volume().value() << ", center in a cell of dimension "
            << center.dimension << "\n";
  cnrg::write("m.json", model);
  cnrg::write("m.off", snap(model));
  cnrg::TetrahedralResult(model).write("m.msh");
  const std::vector<cnrg::Shape> shapes{cnrg::ResultShape{"m.json"}, cnrg::MeshShape{"m.off", {}}};
  for (const cnrg::Shape& shape : shapes) {
    const auto complex = cnrg::build_complex(cnrg::make_soup({{cnrg::prepare(shape)}}));
    std::cout << complex->region_count << " regions, " << cnrg::validate(*complex) << "\n";
  }
  const cnrg::Result again = cnrg::read_result("m.json");
  std::cout << again.component_count() << " components, as before: " << model.component_count() << "\n";
}
