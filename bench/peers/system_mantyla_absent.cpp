// Where there is no bench/baseline yet; system_mantyla.cpp otherwise.
#include "bench/peers/built_in.h"

namespace cnrg::bench {
namespace {

System absent(const std::string& name) {
  return {.name = name,
          .title = name,
          .guarantee = "",
          .version = "",
          .absent = "built without bench/baseline",
          .evaluate = [](const Problem&) -> Answer { throw Refusal("input", "built without bench/baseline"); }};
}

}  // namespace

System mantyla_double_system() { return absent("mantyla-double"); }
System mantyla_exact_system() { return absent("mantyla-exact"); }

}  // namespace cnrg::bench
