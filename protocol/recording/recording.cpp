#include "protocol/recording/recording.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

#include "protocol/recording/fseq_reader.h"
#include "protocol/recording/ola_reader.h"
#include "protocol/recording/pcap_reader.h"

namespace hazer::protocol {
namespace {

using namespace std::string_view_literals;

enum class Format : std::uint8_t { kPcap, kOla, kFseq };

constexpr std::array kCaptureMagics{
    "\xD4\xC3\xB2\xA1"sv,  // pcap, microseconds, of a little-endian machine
    "\xA1\xB2\xC3\xD4"sv,  // the same of a big-endian one
    "\x4D\x3C\xB2\xA1"sv,  // nanoseconds
    "\xA1\xB2\x3C\x4D"sv,
    "\x34\xCD\xB2\xA1"sv,  // pcap of old Linux kernels with patches
    "\xA1\xB2\xCD\x34"sv,
    "\x0A\x0D\x0D\x0A"sv,  // pcapng
};

std::optional<Format> formatOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::array<char, 8> start{};
    stream.read(start.data(), start.size());
    const std::string_view text(start.data(), static_cast<std::size_t>(stream.gcount()));
    if (text == "OLA Show"sv) return Format::kOla;
    for (const std::string_view magic : {"PSEQ"sv, "FSEQ"sv, "ESEQ"sv}) {
        if (text.starts_with(magic)) return Format::kFseq;
    }
    for (const std::string_view magic : kCaptureMagics) {
        if (text.starts_with(magic)) return Format::kPcap;
    }
    return std::nullopt;
}

void refuseUnreadable(const std::filesystem::path& file) {
    std::error_code failure;
    const bool isFile = std::filesystem::is_regular_file(file, failure);
    if (failure) {
        throw RecordingError(
            fmt::format("{}: the recording cannot be read: {}", file.string(), failure.message()));
    }
    // Pipes have no places to go back to.
    if (!isFile) throw RecordingError(fmt::format("{}: not a file; a recording must be one", file.string()));
}

}  // namespace

std::unique_ptr<RecordingReader> openRecording(const std::filesystem::path& file, const FrameMap& map) {
    refuseUnreadable(file);
    const std::optional<Format> format = formatOf(file);
    if (!format) {
        throw RecordingError(
            fmt::format("{}: not a recording; pcap, pcapng, OLA show files and FSEQ are", file.string()));
    }
    switch (*format) {
        case Format::kOla:
            return openOlaShow(file, map);
        case Format::kFseq:
            return openFseq(file, map);
        case Format::kPcap:
            break;
    }
    return openPcap(file);
}

bool isRecording(const std::filesystem::path& file) {
    std::error_code failure;
    return std::filesystem::is_regular_file(file, failure) && formatOf(file).has_value();
}

}  // namespace hazer::protocol
