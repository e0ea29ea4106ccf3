// Operands in the form of OpenCASCADE, and what its algorithms report.
#pragma once

#include <BOPAlgo_Options.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Shape.hxx>
#include <sstream>
#include <string>
#include <vector>

#include "bench/peers/system.h"

namespace cnrg::bench {

/// The arguments of a General Fuse that together are one operand: each solid, then all of one lower dimension.
using OcctArguments = std::vector<TopoDS_Shape>;

/// Throws Refusal at the stage `input` for what OpenCASCADE does not take.
OcctArguments occt_arguments(const Model& model);

/// Runs a stage; what OpenCASCADE throws there is a refusal.
template <class Work>
auto guarded_occt(const char* stage, Work work) {
  try {
    return work();
  } catch (const Standard_Failure& failure) {
    const std::string words = failure.GetMessageString() != nullptr ? failure.GetMessageString() : "";
    throw Refusal(stage, std::string(failure.DynamicType()->Name()) + (words.empty() ? "" : ": " + words));
  }
}

/// The first line of what the algorithm reports.
template <class Dump>
std::string first_occt_line(Dump dump) {
  std::stringstream text;
  dump(text);
  std::string line;
  std::getline(text, line);
  return line;
}

inline void require_no_occt_errors(const BOPAlgo_Options& fuse, const char* stage) {
  if (!fuse.HasErrors()) return;
  throw Refusal(stage, first_occt_line([&](std::ostream& out) { fuse.DumpErrors(out); }));
}

}  // namespace cnrg::bench
