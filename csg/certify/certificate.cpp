// Uncertain places in words.
#include "csg/certify/certificate.h"

#include <algorithm>
#include <cmath>

#include "csg/text/table.h"

namespace cnrg {

std::string UncertainPlace::text() const {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  for (std::size_t k = 0; k < 3; ++k)
    text += (k == 0 ? " near [" : ", ") + decimal(std::abs(at[k]) < 1e-9 ? 0.0 : at[k], "%.6g");
  switch (why) {
    case Why::near:
      if (names.size() == 1)
        return text + "]: it meets itself, or is nearer to that than " + decimal(size, "%.6g");
      return text + "]: they touch, or " +
             (size > 0 ? "are nearer to it than " + decimal(size, "%.6g") : "nearly") + ": apart there, or with " +
             (common > 0    ? "a curve"
              : common == 0 ? "two points"
                            : "a point") +
             " in common";
    case Why::facets: return text + "]: these facets do not tell how they meet";
    case Why::budget: return text + "]: the budget of steps did not tell how they meet";
  }
  return text;
}

std::string Certificate::doubt(const Tree& tree) const {
  const std::string text = "its surfaces may not meet as its faces say: ";
  if (!places.empty()) {
    const std::size_t more = places.size() - 1;
    return text + places[0].text() + (more == 0 ? "" : "; and " + counted(more, "more place", "more places"));
  }
  if (!unknown.empty())
    return text + "of curved faces of `" + tree.nodes[unknown[0]].name + "` only the facets were asked";
  return left == 0 ? "" : text + "not all was asked within the budget of steps";
}

void Certificate::add(const Certificate& more) {
  asked += more.asked;
  apart += more.apart;
  crossing += more.crossing;
  contacts += more.contacts;
  left += more.left;
  places.insert(places.end(), more.places.begin(), more.places.end());
  unknown.insert(unknown.end(), more.unknown.begin(), more.unknown.end());
}

std::vector<Diagnostic> Certificate::notices(const Tree& tree, std::size_t most) const {
  std::vector<Diagnostic> result;
  for (std::size_t i = 0; i < std::min(most, places.size()); ++i) {
    result.push_back(
        {tree.file, tree.nodes[places[i].nodes[0]].operator_at, Diagnostic::Level::notice, places[i].text()});
  }
  return result;
}

std::vector<Diagnostic> Certificate::told(const Tree& tree) const {
  constexpr std::size_t kTold = 3;
  std::vector<Diagnostic> result = notices(tree, kTold);
  const auto tell = [&](const std::string& text) {
    result.push_back({tree.file, {}, Diagnostic::Level::notice, text});
  };
  if (places.size() > kTold)
    tell(counted(places.size() - kTold, "more place", "more places") +
         " where curved surfaces may not meet as their facets do; --certify tells of ten");
  if (left > 0)
    tell(counted(left, "question", "questions") +
         " whether curved surfaces meet as their facets do left open; --certify asks on");
  return result;
}

}  // namespace cnrg
