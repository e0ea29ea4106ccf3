// Catch2, 2 or 3, in one spelling: that of 2 for what 3 has renamed or moved.
#pragma once

#include <string>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>

using Catch::Approx;

namespace Catch {
using Matchers::EndsWith;
using Matchers::Matches;
using Matchers::StartsWith;

inline auto Contains(const std::string& part) { return Matchers::ContainsSubstring(part); }

using Invoker = Detail::unique_ptr<ITestInvoker>;
}  // namespace Catch
#else
#include <catch2/catch.hpp>

namespace Catch {
using Invoker = ITestInvoker*;
}  // namespace Catch
#endif

/// Ends a case that cannot run here; tests/scripts/summary says so and does not count it as passed. What is a part
/// of a case only says WARN("left out: ...").
#define NOT_RUN(why)            \
  do {                          \
    WARN("not run: " << (why)); \
    return;                     \
  } while (false)
