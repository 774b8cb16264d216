// "spot1.Tilt=30": attributes set by hand on the command line.
#pragma once

#include <string>

#include "app/patch.h"

namespace hazer::app {

/// Holds an attribute as FIXTURE.Attribute=VALUE says, in the units of Fixture::hold. The last dot before '='
/// parts the fixture's name from the attribute. The name * means every fixture that has the attribute. Throws
/// std::runtime_error, which lists the fixtures of the show, or the attributes of the fixture, if one is
/// unknown.
void assign(const std::string& text, Patch& patch);

/// Empty if the text reads FIXTURE.Attribute=VALUE, else what is wrong with it.
std::string checkAssignment(const std::string& text);

}  // namespace hazer::app
