// What a test asks of a page: is it well-formed, does it load anything.
#pragma once

#include <string>
#include <vector>

namespace cnrg::bench {

/// The first fault of elements, attributes and entities as XML sees them, with its place; empty: none.
std::string markup_fault(const std::string& page);
/// Values of all attributes with the name.
std::vector<std::string> attribute_values(const std::string& page, const std::string& name);

}  // namespace cnrg::bench
