// The frame of a benchmark's `main`: options are read, faults become one line.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "csg/text/escape.h"

namespace cnrg::bench {

/// Reads the options and calls `run()` for the exit status; 2 for bad options and for what `run` throws.
template <class Run>
int command(CLI::App& program, int argc, char** argv, const Run& run) {
  const char* const name = program.get_name().c_str();
  try {
    program.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return program.exit(e);
    std::fprintf(stderr, "%s: error: %s; see `%s --help`\n", name, shown(e.what()).c_str(), name);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: error: %s\n", name, shown(e.what()).c_str());
  }
  return 2;
}

}  // namespace cnrg::bench
