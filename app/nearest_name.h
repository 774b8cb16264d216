// Which of the names there are did somebody mean?
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hazer::app {

/// The name with the fewest letters to change, insert or delete, upper and lower case alike (Levenshtein
/// 1966). Empty if `names` is empty or nothing comes near: more than half of the letters would have to
/// change.
std::string nearestName(std::string_view wanted, std::span<const std::string> names);

/// "a, b and c".
std::string listNames(std::span<const std::string> names);

/// " Did you mean 'a'?" if a name is near, and what there is: " There are a, b and c." Starts with a space,
/// to follow a sentence.
std::string suggestName(std::string_view wanted, std::span<const std::string> names);

}  // namespace hazer::app
