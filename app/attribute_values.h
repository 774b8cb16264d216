// "Pan=90,Tilt=45": values of a fixture's attributes on the command line.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hazer::app {

/// Attribute and value in the units of fixtures::Fixture::hold, in the order of writing.
using AttributeValues = std::vector<std::pair<std::string, double>>;

/// Reads NAME=VALUE, several with commas in between. Throws std::runtime_error with the part that is none.
AttributeValues parseAttributeValues(std::string_view text);

}  // namespace hazer::app
