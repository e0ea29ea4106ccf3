#include "tests/campaign/driver/state.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace cnrg::campaign {
namespace {

constexpr const char* kFirstLine = "cnrg campaign 1";
constexpr std::size_t kLongestMessage = 2000;

Verdict verdict_of(const std::string& word) {
  for (const Verdict v : {Verdict::right, Verdict::wrong, Verdict::declined, Verdict::unknown})
    if (word == name(v)) return v;
  throw std::runtime_error("no verdict: " + word);
}

void expect(std::istringstream& in, const std::string& key) {
  std::string word;
  if (!(in >> word) || word != key) throw std::runtime_error("`" + key + "` is missing");
}

}  // namespace

void Tally::add(Verdict verdict) {
  switch (verdict) {
    case Verdict::right: ++right; break;
    case Verdict::wrong: ++wrong; break;
    case Verdict::declined: ++declined; break;
    case Verdict::unknown: ++unknown; break;
  }
}

bool State::clean() const {
  return std::all_of(tallies.begin(), tallies.end(),
                     [](const auto& entry) { return entry.second.wrong == 0 && entry.second.declined == 0; });
}

std::uint64_t State::trials() const {
  std::uint64_t all = 0;
  for (const auto& [family, tally] : tallies) all += tally.trials();
  return all;
}

std::string one_line(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (out.size() > kLongestMessage) break;
    if (c == '\n') out += "\\n";
    else if (c == '\\') out += "\\\\";
    else out += c;
  }
  return out;
}

std::string from_one_line(const std::string& line) {
  std::string out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool escaped = line[i] == '\\' && i + 1 < line.size();
    out += !escaped ? line[i] : line[++i] == 'n' ? '\n' : line[i];
  }
  return out;
}

std::string to_text(const State& state) {
  std::ostringstream out;
  out.precision(12);
  out << kFirstLine << "\n";
  for (const auto& [family, t] : state.tallies)
    out << "family " << family << " next " << t.next << " right " << t.right << " wrong " << t.wrong
        << " declined " << t.declined << " unknown " << t.unknown << " seconds " << t.seconds << "\n";
  for (const Failure& f : state.failures)
    out << "failure " << f.family << " " << f.seed << " " << name(f.outcome.verdict) << " "
        << one_line(f.outcome.message) << "\n";
  return out.str();
}

State parse_state(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != kFirstLine)
    throw std::runtime_error(std::string("a state begins with the line `") + kFirstLine + "`");
  State state;
  for (int number = 2; std::getline(lines, line); ++number) {
    try {
      std::istringstream in(line);
      std::string kind, family;
      in >> kind >> family;
      if (kind == "family") {
        Tally t;
        expect(in, "next"), in >> t.next;
        expect(in, "right"), in >> t.right;
        expect(in, "wrong"), in >> t.wrong;
        expect(in, "declined"), in >> t.declined;
        expect(in, "unknown"), in >> t.unknown;
        expect(in, "seconds"), in >> t.seconds;
        if (!in) throw std::runtime_error("a number is missing");
        state.tallies[family] = t;
      } else if (kind == "failure") {
        Failure f;
        std::string verdict;
        f.family = family;
        if (!(in >> f.seed >> verdict)) throw std::runtime_error("a seed or a verdict is missing");
        f.outcome.verdict = verdict_of(verdict);
        std::getline(in >> std::ws, f.outcome.message);
        f.outcome.message = from_one_line(f.outcome.message);
        state.failures.push_back(std::move(f));
      } else {
        throw std::runtime_error("neither `family` nor `failure`");
      }
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + error.what());
    }
  }
  return state;
}

std::string table(const State& state, const Families& families) {
  std::ostringstream out;
  char line[512];
  const auto row = [&](const std::string& family, const std::string& oracle, const Tally& t) {
    const double rate = t.seconds > 0 ? static_cast<double>(t.trials()) / t.seconds : 0;
    std::snprintf(line, sizeof line, "%-18s %-44s %9llu %9llu %6llu %8llu %8llu %9.1f %8.3f\n", family.c_str(),
                  oracle.c_str(), static_cast<unsigned long long>(t.trials()),
                  static_cast<unsigned long long>(t.right), static_cast<unsigned long long>(t.wrong),
                  static_cast<unsigned long long>(t.declined), static_cast<unsigned long long>(t.unknown), rate,
                  t.seconds / 3600);
    out << line;
  };
  std::snprintf(line, sizeof line, "%-18s %-44s %9s %9s %6s %8s %8s %9s %8s\n", "family", "oracle", "trials",
                "right", "wrong", "declined", "unknown", "trials/s", "hours");
  out << line;
  Tally all;
  for (const auto& family : families) {
    const auto at = state.tallies.find(family->name());
    if (at == state.tallies.end()) continue;
    const Tally& t = at->second;
    row(family->name(), family->oracle(), t);
    all.right += t.right, all.wrong += t.wrong, all.declined += t.declined, all.unknown += t.unknown;
    all.seconds += t.seconds;
  }
  row("all", "", all);
  return out.str();
}

}  // namespace cnrg::campaign
