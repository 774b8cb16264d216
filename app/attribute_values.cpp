#include "app/attribute_values.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace hazer::app {
namespace {

std::pair<std::string, double> parseOne(std::string_view text) {
    const std::size_t equals = text.find('=');
    double value = 0.0;
    if (equals != std::string_view::npos && equals > 0) {
        const std::string_view number = text.substr(equals + 1);
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
        if (error == std::errc() && end == number.data() + number.size() && std::isfinite(value))
            return {std::string(text.substr(0, equals)), value};
    }
    throw std::runtime_error(fmt::format("'{}' is no value of an attribute; write Pan=90,Tilt=45", text));
}

}  // namespace

AttributeValues parseAttributeValues(std::string_view text) {
    AttributeValues values;
    while (true) {
        const std::size_t comma = text.find(',');
        values.push_back(parseOne(text.substr(0, comma)));
        if (comma == std::string_view::npos) return values;
        text.remove_prefix(comma + 1);
    }
}

}  // namespace hazer::app
