#include "protocol/printable_text.h"

#include <cstdint>

namespace hazer::protocol {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

std::uint8_t byteAt(std::string_view bytes, std::size_t index) {
    return static_cast<std::uint8_t>(bytes[index]);
}

// Length of a well-formed sequence by its first byte; 0: none begins with it (Unicode, table 3-7).
std::size_t lengthFrom(std::uint8_t first) {
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return 2;
    if (first >= 0xE0 && first <= 0xEF) return 3;
    if (first >= 0xF0 && first <= 0xF4) return 4;
    return 0;
}

// The range of the second byte keeps out overlong forms, surrogates and what lies beyond U+10FFFF.
bool isSecondByte(std::uint8_t first, std::uint8_t second) {
    const std::uint8_t lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const std::uint8_t highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    return second >= lowest && second <= highest;
}

bool isControl(std::string_view character) {
    const std::uint8_t first = byteAt(character, 0);
    if (character.size() == 1) return first < 0x20 || first == 0x7F;
    return first == 0xC2 && byteAt(character, 1) < 0xA0;  // U+0080..U+009F
}

// The character that `bytes` begins with; empty if it is not well-formed.
std::string_view firstCharacter(std::string_view bytes) {
    const std::uint8_t first = byteAt(bytes, 0);
    const std::size_t length = lengthFrom(first);
    if (length == 0 || length > bytes.size()) return {};
    for (std::size_t i = 1; i < length; ++i) {
        const std::uint8_t next = byteAt(bytes, i);
        if ((next & 0xC0) != 0x80 || (i == 1 && !isSecondByte(first, next))) return {};
    }
    return bytes.substr(0, length);
}

}  // namespace

std::string printableText(std::string_view bytes, std::size_t maxSize) {
    std::string text;
    while (!bytes.empty()) {
        const std::string_view character = firstCharacter(bytes);
        const bool isPrintable = !character.empty() && !isControl(character);
        const std::string_view shown = isPrintable ? character : kReplacement;
        if (text.size() + shown.size() > maxSize) break;
        text += shown;
        bytes.remove_prefix(character.empty() ? 1 : character.size());
    }
    return text;
}

}  // namespace hazer::protocol
