// The same as model.yaml, in C++: its volume, and files of libraries that are opened when they are wanted.
#include <cnrg.h>

#include <iostream>

int main() {
  const auto ground = cnrg::prepare(cnrg::BoxShape{{0, 0, 0}, {2, 2, 2}});
  const auto pit = cnrg::prepare(cnrg::BoxShape{{1, 1, 1}, {3, 3, 3}});
  const auto complex = cnrg::build_complex(cnrg::make_soup({{ground}, {pit}}));
  const std::vector<cnrg::Group> leaves = cnrg::leaf_groups(*complex);
  const cnrg::Group model =
      cnrg::boolean_operation(*complex, cnrg::BooleanOp::subtract, cnrg::Dominance::left, leaves[0], leaves[1])
          .group;
  const cnrg::Result result(complex, model, {.result = "model", .leaves = {"ground", "pit"}});
  std::cout << *result.volume(1) << "\n";
  cnrg::write("model.h5m", result);
  cnrg::write("model.step", result);
}
