// The name that the user probably meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cnrg {

/// The candidate nearest to `text` by edit distance (insertion, deletion, substitution, exchange of neighbours;
/// case costs nothing), or nothing when none is near: at most a third of the letters may differ.
std::string_view nearest(std::string_view text, std::span<const std::string_view> candidates);

/// `; did you mean `x`?`, or nothing when no candidate is near.
std::string did_you_mean(std::string_view text, std::span<const std::string_view> candidates);

}  // namespace cnrg
