// Sends a recording out again, packet by packet at its time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/recording/recording.h"
#include "protocol/recording/resend_schedule.h"

namespace hazer::protocol {

struct ResenderConfig {
    std::string to = "127.0.0.1";         ///< IPv4 or IPv6 address of one receiver.
    std::optional<std::uint16_t> port{};  ///< For both protocols; nothing: 6454 and 5568.
    ResendRules rules{};
};

struct ResenderStatus {
    RecordingTime time{};       ///< Of the recording.
    std::uint64_t packets = 0;  ///< Sent.
    std::uint64_t failed = 0;   ///< Refused by the system.
    std::uint64_t rounds = 0;   ///< Times the end was reached.
    /// How late packets were handed to the system, half and 99 in 100 of them at most, and the worst [s].
    double medianLateS = 0.0;
    double p99LateS = 0.0;
    double worstLateS = 0.0;
};

/// Not thread-safe.
class Resender {
 public:
    /// Throws RecordingError or NetworkError if the file or the address cannot be used.
    Resender(const std::filesystem::path& file, const FrameMap& map, const ResenderConfig& config);
    ~Resender();

    /// Sends until the end, or until `shouldStop`, which is asked at least every 50 ms. Deadlines are counted
    /// from the start, so that no delay adds up.
    void run(const std::function<bool()>& shouldStop);

    ResenderStatus status() const;
    const std::vector<std::string>& warnings() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
