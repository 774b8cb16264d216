#include "protocol/recording/pcap_reader.h"

#include <fmt/format.h>
#include <pcap/pcap.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "protocol/recording/link_layer.h"
#include "protocol/recording/udp_extractor.h"

namespace hazer::protocol {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kReadBufferBytes = 256u * 1024u;

bool beginsWith(Bytes bytes, std::size_t offset, std::string_view text) {
    return bytes.size() >= offset + text.size() &&
           std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset),
                      [](char c, std::uint8_t byte) { return static_cast<std::uint8_t>(c) == byte; });
}

bool isLighting(const UdpDatagram& datagram) {
    using namespace std::string_view_literals;
    return isLightingPort(datagram.to.port) || beginsWith(datagram.bytes, 0, "Art-Net\0"sv) ||
           beginsWith(datagram.bytes, 4, "ASC-E1.17\0\0\0"sv);
}

struct ClosePcap {
    void operator()(pcap_t* capture) const { pcap_close(capture); }
};
using PcapHandle = std::unique_ptr<pcap_t, ClosePcap>;

PcapHandle openHandle(const std::filesystem::path& file) {
    std::FILE* stream = std::fopen(file.c_str(), "rb");
    if (stream == nullptr) {
        throw RecordingError(
            fmt::format("{}: the recording cannot be read: {}", file.string(), std::strerror(errno)));
    }
    std::setvbuf(stream, nullptr, _IOFBF, kReadBufferBytes);
    std::array<char, PCAP_ERRBUF_SIZE> reason{};
    PcapHandle handle(
        pcap_fopen_offline_with_tstamp_precision(stream, PCAP_TSTAMP_PRECISION_NANO, reason.data()));
    if (handle) return handle;
    std::fclose(stream);
    throw RecordingError(
        fmt::format("{}: not a capture that libpcap reads: {}", file.string(), reason.data()));
}

/// Seconds and nanoseconds as one number. Times that no clock shows would overflow it and become 0.
std::chrono::nanoseconds timeOf(const timeval& time) {
    constexpr std::int64_t kMostSeconds = std::int64_t{1} << 33;  // the year 2242
    const auto seconds = static_cast<std::int64_t>(time.tv_sec);
    if (seconds < 0 || seconds > kMostSeconds) return std::chrono::nanoseconds(0);
    return std::chrono::seconds(seconds) + std::chrono::nanoseconds(time.tv_usec);
}

/// Enough of a record to know it again.
struct Fingerprint {
    std::chrono::nanoseconds time{};
    std::uint32_t size = 0;
    std::uint64_t hash = 0;
    bool operator==(const Fingerprint&) const = default;
};

Fingerprint fingerprintOf(const pcap_pkthdr& header, const u_char* bytes) {
    constexpr std::size_t kHashed = 64;          // headers and sequence number
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    for (std::size_t i = 0; i < std::min<std::size_t>(header.caplen, kHashed); ++i) {
        hash = (hash ^ bytes[i]) * 1099511628211u;
    }
    return {timeOf(header.ts), header.caplen, hash};
}

/// What a reader remembers besides its place in the file.
struct PcapState {
    std::uint64_t records = 0;         ///< Read so far.
    off_t lastOffset = 0;              ///< Where reading began that gave the last record.
    Fingerprint last{};                ///< Of that record.
    std::chrono::nanoseconds start{};  ///< When the first was captured.
    RecordingTime time{};              ///< The latest so far, since then.
    std::uint64_t cut = 0;
    bool isAtEnd = false;
    UdpExtractor extractor{};
};

struct PcapMark : RecordingMark {
    explicit PcapMark(PcapState there) : state(std::move(there)) {}
    PcapState state;
};

class PcapReader : public RecordingReader {
 public:
    explicit PcapReader(const std::filesystem::path& file)
        : file_(file), handle_(openHandle(file)), size_(std::filesystem::file_size(file)) {
        refuseUnknownLinkType();
    }

    std::optional<RecordedPacket> next() override {
        while (const auto frame = nextFrame()) {
            const auto ip = ipPacketOf(pcap_datalink(handle_.get()), *frame);
            if (!ip) continue;
            const auto datagram = state_.extractor.take(*ip, state_.time);
            if (!datagram || !isLighting(*datagram)) continue;
            if (datagram->isCut) {
                ++state_.cut;
                continue;
            }
            return RecordedPacket{state_.time,
                                  RecordedDatagram{datagram->from, datagram->to, datagram->bytes}};
        }
        return std::nullopt;
    }

    RecordingMarkPtr mark() const override { return std::make_shared<PcapMark>(state_); }

    void goTo(const RecordingMark& mark) override {
        const PcapState& there = static_cast<const PcapMark&>(mark).state;
        if (there.records == 0) {
            handle_ = openHandle(file_);
        } else if (!goToRecord(there)) {
            skipTo(there.records);
        }
        state_ = there;
    }

    std::optional<RecordingTime> duration() const override {
        return state_.isAtEnd ? std::optional(state_.time) : std::nullopt;
    }

    double readShare() const override {
        if (state_.isAtEnd || size_ == 0) return 1.0;
        return std::clamp(static_cast<double>(state_.lastOffset) / static_cast<double>(size_), 0.0, 1.0);
    }

    std::uint64_t refusedCount() const override { return state_.cut + state_.extractor.lostCount(); }

    const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
    void refuseUnknownLinkType() const {
        const int linkType = pcap_datalink(handle_.get());
        if (isKnownLinkType(linkType)) return;
        const char* name = pcap_datalink_val_to_description(linkType);
        throw RecordingError(
            fmt::format("{}: a capture of link type {} ({}), in which hazer finds no Art-Net or sACN; "
                        "capture on Ethernet, "
                        "loopback or 'any'",
                        file_.string(), linkType, name == nullptr ? "unknown" : name));
    }

    std::optional<Bytes> nextFrame() {
        if (state_.isAtEnd) return std::nullopt;
        pcap_pkthdr* header = nullptr;
        const u_char* bytes = nullptr;
        const off_t offset = ftello(pcap_file(handle_.get()));
        const int result = pcap_next_ex(handle_.get(), &header, &bytes);
        if (result != 1) {
            state_.isAtEnd = true;
            if (result != PCAP_ERROR_BREAK) warnOnce();
            return std::nullopt;
        }
        ++state_.records;
        state_.lastOffset = offset;
        state_.last = fingerprintOf(*header, bytes);
        if (state_.records == 1) state_.start = state_.last.time;
        // Clocks are set back, and captures are glued together. Time in a recording goes forward only.
        state_.time = std::max(state_.time, state_.last.time - state_.start);
        return Bytes(bytes, header->caplen);
    }

    void warnOnce() {
        if (!warnings_.empty()) return;
        warnings_.push_back(fmt::format("{}: read up to packet {}, where the capture is cut or broken: {}",
                                        file_.string(), state_.records, pcap_geterr(handle_.get())));
    }

    /// Reads the last record before the place again: it proves that the place is what it was. It may not be
    /// where a pcapng has several sections, each with interfaces of its own.
    bool goToRecord(const PcapState& there) {
        if (fseeko(pcap_file(handle_.get()), there.lastOffset, SEEK_SET) != 0) return false;
        pcap_pkthdr* header = nullptr;
        const u_char* bytes = nullptr;
        return pcap_next_ex(handle_.get(), &header, &bytes) == 1 &&
               fingerprintOf(*header, bytes) == there.last;
    }

    void skipTo(std::uint64_t records) {
        handle_ = openHandle(file_);
        pcap_pkthdr* header = nullptr;
        const u_char* bytes = nullptr;
        for (std::uint64_t record = 0; record < records; ++record) {
            if (pcap_next_ex(handle_.get(), &header, &bytes) == 1) continue;
            throw RecordingError(fmt::format("{}: the recording changed while it was read", file_.string()));
        }
    }

    std::filesystem::path file_;
    PcapHandle handle_;
    std::uintmax_t size_;
    PcapState state_;
    std::vector<std::string> warnings_;
};

}  // namespace

std::unique_ptr<RecordingReader> openPcap(const std::filesystem::path& file) {
    return std::make_unique<PcapReader>(file);
}

}  // namespace hazer::protocol
