// The frame of a benchmark's `main`: options are read, faults become one line.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <sstream>
#include <string>

#include "csg/text/escape.h"
#include "kernel/exact/rational.h"

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
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: error: memory ran out\n", name);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: error: %s\n", name, shown(e.what()).c_str());
  }
  return 2;
}

/// CLI11's own range lets what is no number through.
inline CLI::Validator number_between(double low, double high) {
  std::ostringstream range;
  range << "a number from " << low << " to " << high;
  return CLI::Validator(
      [=, text = range.str()](const std::string& word) {
        const std::optional<Rational> value = parse_rational(word);
        return value && to_double(*value) >= low && to_double(*value) <= high ? std::string()
                                                                              : "'" + word + "' is not " + text;
      },
      "NUMBER");
}

/// `--seconds` and `--gigabytes` of a run (process.h).
inline void add_limits(CLI::App& program, std::optional<double>& seconds, std::optional<double>& gigabytes,
                       const std::string& more) {
  program.add_option("--seconds", seconds, "Time limit of a run" + more + " (60)")
      ->check(number_between(0.01, 1e5));
  program.add_option("--gigabytes", gigabytes, "Memory limit of a run" + more + " (4)")
      ->check(number_between(0.01, 1e4));
}

}  // namespace cnrg::bench
