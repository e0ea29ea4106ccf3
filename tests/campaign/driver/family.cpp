#include "tests/campaign/driver/family.h"

#include <exception>
#include <new>

#include "kernel/base/error.h"
#include "tests/oracles/dag.h"
#include "tests/oracles/nef_oracle.h"

namespace cnrg::campaign {

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::right: return "right";
    case Verdict::wrong: return "wrong";
    case Verdict::declined: return "declined";
    case Verdict::unknown: break;
  }
  return "unknown";
}

Outcome judge(const std::function<std::string()>& compare) {
  try {
    std::string failure = compare();
    if (failure.empty()) return {};
    const bool refused = failure.starts_with(properties::kRefused);
    return {refused ? Verdict::declined : Verdict::wrong, std::move(failure)};
  } catch (const properties::OracleFailure& error) {
    return {Verdict::unknown, error.what()};
  } catch (const InputError& error) {
    return {Verdict::declined, error.what()};
  } catch (const FileError& error) {
    return {Verdict::declined, error.what()};
  } catch (const std::bad_alloc&) {
    return {Verdict::declined, "out of memory"};
  } catch (const std::exception& error) {
    return {Verdict::wrong, std::string("thrown: ") + error.what()};
  }
}

}  // namespace cnrg::campaign
