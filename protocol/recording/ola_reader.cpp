#include "protocol/recording/ola_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string_view>

#include "protocol/recording/universe_range.h"

namespace hazer::protocol {
namespace {

constexpr std::string_view kHeaderV1 = "OLA Show";
constexpr std::string_view kHeaderV2 = "OLA Show V2";

// A universe number and 512 values are 2 059 characters at most. A line without end must not fill the memory.
constexpr std::size_t kLongestLine = 4096;

// A hundred days, far beyond any show. Sums of delays stay far from overflow.
constexpr std::chrono::hours kLongest{2400};

enum class Version : std::uint8_t { kDelays, kTimes };

template <class Number>
std::optional<Number> numberFrom(std::string_view text) {
    Number number{};
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
    return number;
}

struct Line {
    std::string text;
    bool hasEnd = true;  ///< Whether a line feed closed it.
};

struct Place {
    std::streamoff offset = 0;
    std::uint64_t line = 0;  ///< The number of the last line read.
    RecordingTime time{};    ///< Of the next frame.
    bool isAtEnd = false;
};

struct OlaMark : RecordingMark {
    explicit OlaMark(const Place& there) : place(there) {}
    Place place;
};

class OlaReader : public RecordingReader {
 public:
    OlaReader(const std::filesystem::path& file, const FrameMap& map)
        : file_(file), map_(map), stream_(file, std::ios::binary), size_(std::filesystem::file_size(file)) {
        if (!stream_) throw RecordingError(fmt::format("{}: the show file cannot be read", file.string()));
        readHeader();
        const Place start = place_;
        while (next()) {
        }
        if (sawMicroseconds_) {
            isInMicroseconds_ = true;
            goTo(OlaMark(start));
            while (next()) {
            }
        }
        duration_ = place_.time;
        goTo(OlaMark(start));
    }

    std::optional<RecordedPacket> next() override {
        const std::optional<Line> line = readLine();
        if (!line || line->text.empty()) return end();
        if (!readFrame(*line)) return end();
        RecordedPacket packet{place_.time, RecordedFrame{universe_, slots_}};
        readTime();
        return packet;
    }

    RecordingMarkPtr mark() const override { return std::make_shared<OlaMark>(place_); }

    void goTo(const RecordingMark& mark) override {
        place_ = static_cast<const OlaMark&>(mark).place;
        stream_.clear();
        stream_.seekg(place_.offset);
    }

    std::optional<RecordingTime> duration() const override { return duration_; }

    double readShare() const override {
        if (place_.isAtEnd || size_ == 0) return 1.0;
        return static_cast<double>(place_.offset) / static_cast<double>(size_);
    }

    std::uint64_t refusedCount() const override { return 0; }
    const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
    [[noreturn]] void fail(const std::string& what) const {
        throw RecordingError(fmt::format("{}:{}: {}", file_.string(), place_.line, what));
    }

    std::nullopt_t end() {
        place_.isAtEnd = true;
        return std::nullopt;
    }

    std::optional<Line> readLine() {
        if (place_.isAtEnd) return std::nullopt;
        Line line;
        char c = 0;
        bool sawAny = false;
        line.hasEnd = false;
        while (stream_.get(c)) {
            sawAny = true;
            ++place_.offset;
            if (c == '\n') {
                line.hasEnd = true;
                break;
            }
            line.text.push_back(c);
            if (line.text.size() > kLongestLine) {
                ++place_.line;
                fail("a line of more than 4096 characters belongs to no show file");
            }
        }
        if (!sawAny) return std::nullopt;
        ++place_.line;
        if (line.text.ends_with('\r')) line.text.pop_back();
        return line;
    }

    void readHeader() {
        const std::optional<Line> line = readLine();
        if (line && line->text == kHeaderV1) {
            version_ = Version::kDelays;
        } else if (line && line->text == kHeaderV2) {
            version_ = Version::kTimes;
        } else {
            place_.line = 1;
            fail("a show file of OLA begins with the line 'OLA Show' or 'OLA Show V2'");
        }
    }

    /// False if it is the cut last line of a recorder that was ended.
    bool readFrame(const Line& line) {
        const std::string_view text = line.text;
        const std::size_t space = text.find(' ');
        const auto universe = numberFrom<std::uint32_t>(text.substr(0, space));
        if (space == std::string_view::npos || !universe || !readSlots(text.substr(space + 1))) {
            if (line.hasEnd) {
                fail("a frame is a universe, one space and up to 512 values 0..255 between commas");
            }
            warnOfCut();
            return false;
        }
        const auto mapped = universeAt(map_, *universe);
        if (!mapped) fail(outOfRange(map_, *universe));
        universe_ = *mapped;
        return true;
    }

    bool readSlots(std::string_view text) {
        slots_.clear();
        while (!text.empty()) {
            const std::size_t comma = std::min(text.find(','), text.size());
            const auto value = numberFrom<std::uint8_t>(text.substr(0, comma));
            if (!value || slots_.size() == kSlotCount) return false;
            slots_.push_back(*value);
            if (comma + 1 == text.size()) return false;  // a comma with nothing after it
            text.remove_prefix(std::min(comma + 1, text.size()));
        }
        return true;
    }

    /// The line after a frame: when the next one comes. Nothing, or an empty line, ends the show.
    void readTime() {
        const std::optional<Line> line = readLine();
        if (!line || line->text.empty()) {
            end();
            return;
        }
        const std::optional<RecordingTime> time =
            version_ == Version::kDelays ? timeAfterDelay(line->text) : timeFromStart(line->text);
        if (time && *time > kLongest) fail("a show of more than a hundred days is refused");
        if (time) {
            place_.time = *time;
        } else if (line->hasEnd) {
            fail(version_ == Version::kDelays ? "between two frames there must be a delay in milliseconds"
                                              : "between two frames there must be a time, seconds and "
                                                "milliseconds, not before the last");
        } else {
            warnOfCut();
            end();
        }
    }

    std::optional<RecordingTime> timeAfterDelay(std::string_view text) const {
        const auto delay = numberFrom<std::uint32_t>(text);
        if (!delay) return std::nullopt;
        return place_.time + std::chrono::milliseconds(*delay);
    }

    /// The drafts of version 2 disagree whether the second number counts milliseconds or microseconds. The
    /// description says milliseconds; a number above 999 proves the other, for the whole file.
    std::optional<RecordingTime> timeFromStart(std::string_view text) {
        const std::size_t space = text.find(' ');
        if (space == std::string_view::npos) return std::nullopt;
        const auto seconds = numberFrom<std::uint32_t>(text.substr(0, space));
        const auto fraction = numberFrom<std::uint32_t>(text.substr(space + 1));
        if (!seconds || !fraction || *fraction > 999'999) return std::nullopt;
        if (*fraction > 999) sawMicroseconds_ = true;
        const RecordingTime whole = std::chrono::seconds(*seconds);
        if (!isInMicroseconds_ && sawMicroseconds_) return whole;  // read again once the unit is known
        const RecordingTime time = isInMicroseconds_ ? whole + std::chrono::microseconds(*fraction)
                                                     : whole + std::chrono::milliseconds(*fraction);
        if (time < place_.time) return std::nullopt;
        return time;
    }

    void warnOfCut() {
        if (!warnings_.empty()) return;
        warnings_.push_back(
            fmt::format("{}:{}: the last line is cut and left out", file_.string(), place_.line));
    }

    std::filesystem::path file_;
    FrameMap map_;
    std::ifstream stream_;
    std::uintmax_t size_;
    Version version_ = Version::kDelays;
    bool isInMicroseconds_ = false;
    bool sawMicroseconds_ = false;
    Place place_;
    UniverseId universe_{};
    std::vector<std::uint8_t> slots_;
    RecordingTime duration_{};
    std::vector<std::string> warnings_;
};

}  // namespace

std::unique_ptr<RecordingReader> openOlaShow(const std::filesystem::path& file, const FrameMap& map) {
    return std::make_unique<OlaReader>(file, map);
}

}  // namespace hazer::protocol
