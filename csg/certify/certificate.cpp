// Uncertain places in words.
#include "csg/certify/certificate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cnrg {
namespace {

std::string decimals(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", x);
  return buffer;
}

}  // namespace

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
    const UncertainPlace& place = places[i];
    std::string text;
    for (std::size_t k = 0; k < place.names.size(); ++k)
      text += (k == 0 ? "" : k + 1 == place.names.size() ? " and " : ", ") + place.names[k];
    for (std::size_t k = 0; k < 3; ++k)
      text += (k == 0 ? " near [" : ", ") + decimals(std::abs(place.at[k]) < 1e-9 ? 0.0 : place.at[k]);
    switch (place.why) {
      case UncertainPlace::Why::near:
        text += "]: they touch, or are nearer to it than " + decimals(place.size);
        break;
      case UncertainPlace::Why::facets: text += "]: these facets do not tell how they meet"; break;
      case UncertainPlace::Why::budget: text += "]: the budget of steps did not tell how they meet";
    }
    result.push_back({tree.file, tree.nodes[place.nodes[0]].operator_at, Diagnostic::Level::notice, text});
  }
  return result;
}

}  // namespace cnrg
