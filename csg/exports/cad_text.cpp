// The child's part, and what becomes of its answer; see the header.
#include "csg/exports/cad_text.h"

#include "csg/text/child.h"
#include "csg/text/input_file.h"
#include "csg/text/plugin.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

enum class Answer : std::uint8_t { text, input_error, broken_invariant };

int make_in_child(decltype(&cnrg_cad_text) make, const CadParts& parts, CadFormat format, const MemoryFile& file) {
  const auto answer = [&](Answer kind, const std::string& text) {
    file.write_value(kind);
    file.write_list(text);
  };
  try {
    CadText made;
    make(parts, format, made);
    answer(Answer::text, made.text);
    file.write_value(std::uint64_t(made.notices.size()));
    for (const std::string& notice : made.notices) file.write_list(notice);
  } catch (const InputError& error) {
    answer(Answer::input_error, error.what());
  } catch (const InvariantError& error) {
    answer(Answer::broken_invariant, error.what());
  }
  return 0;
}

const char* const kInstead = "write .json, which holds any result, or .msh, which holds its facets";

[[noreturn]] void fail(const ChildEnd& end) {
  using Kind = ChildEnd::Kind;
  switch (end.kind) {
    case Kind::time:
      throw InputError("OpenCASCADE did not end within " + std::to_string(end.seconds) +
                       " s of processor time: " + kInstead);
    case Kind::memory:
      throw FileError(
          std::string("OpenCASCADE ran out of memory, or of room for the file (ulimit -f): free some, or ") +
          kInstead);
    case Kind::signal:
      throw InputError("OpenCASCADE crashed (signal " + std::to_string(end.number) + "): " + kInstead);
    default: throw InputError("OpenCASCADE ended its process (" + std::to_string(end.number) + "): " + kInstead);
  }
}

}  // namespace

CadText cad_text(const CadParts& parts, CadFormat format) {
  const auto make = CNRG_PLUGIN_FUNCTION(kCadPlugin, cnrg_cad_text);
  constexpr std::size_t kSeconds = 600, kFacesPerSecond = 100;
  const ChildLimits limits{.seconds = kSeconds + parts.faces.size() / kFacesPerSecond,
                           .bytes = memory_of_machine()};
  const MemoryFile file("OpenCASCADE");
  const ChildEnd end =
      run_in_child("OpenCASCADE", limits, [&] { return make_in_child(make, parts, format, file); });
  if (end.kind != ChildEnd::Kind::done || end.number != 0) fail(end);
  file.rewind();
  CadText result;
  const auto kind = file.read_value<Answer>();
  file.read_list(result.text);
  if (kind == Answer::broken_invariant) throw InvariantError(result.text);
  if (kind != Answer::text) throw InputError(result.text + ": " + kInstead);
  const auto n = file.read_value<std::uint64_t>();
  for (std::uint64_t i = 0; i < n; ++i) file.read_list(result.notices.emplace_back());
  return result;
}

}  // namespace cnrg
