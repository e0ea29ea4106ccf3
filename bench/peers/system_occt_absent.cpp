// Where OpenCASCADE was not found; system_occt.cpp otherwise.
#include "bench/peers/built_in.h"

namespace cnrg::bench {

System occt_system() {
  return {.name = "occt",
          .title = "OpenCASCADE General Fuse",
          .guarantee = "",
          .version = [] { return std::string(); },
          .absent = "built without OpenCASCADE; bench/run installs what it needs",
          .evaluate = [](const Problem&) -> Answer { throw Refusal("input", "built without OpenCASCADE"); }};
}

}  // namespace cnrg::bench
