// A fuzzer: libFuzzer's driver around one target, whose name the build gives.
#include <algorithm>
#include <cstdint>

#include "tests/campaign/fuzz/targets.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  cnrg::fuzz::limit_children();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const cnrg::fuzz::Target target = *std::ranges::find_if(
      cnrg::fuzz::targets(), [](const auto& t) { return std::string_view(t.name) == CNRG_FUZZ_TARGET; });
  target.run({reinterpret_cast<const char*>(data), size});
  return 0;
}
