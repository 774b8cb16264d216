// Sends sACN over UDP.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "protocol/sacn_source.h"

namespace hazer::protocol {

struct SacnSenderConfig {
    SacnSourceConfig source{};  ///< A CID of 0 is replaced by a random one.
    std::string to{};           ///< IPv4 or IPv6 address of one receiver; empty: multicast.
    /// For multicast: the name or an address of the interface to send from; empty: the system's choice.
    std::string interface {};
    bool usesIpv6Groups = false;  ///< For multicast: ff18::8300:HHLL instead of 239.255.H.L.
    std::uint16_t port = kSacnPort;
};

/// One source with its socket. Call sendDue often enough: at nextDue(), or with every frame. Not thread-safe.
class SacnSender {
 public:
    /// Throws NetworkError if the address or the interface cannot be used.
    explicit SacnSender(SacnSenderConfig config);
    ~SacnSender();  ///< Terminates, so that receivers let go at once.
    SacnSender(const SacnSender&) = delete;
    SacnSender& operator=(const SacnSender&) = delete;

    const Cid& cid() const;

    void setLevels(std::uint16_t universe, std::span<const std::uint8_t> slots);
    void setSlotPriorities(std::uint16_t universe, std::span<const std::uint8_t> priorities);
    std::optional<TimePoint> nextDue() const;

    /// Sends all that is due. Throws NetworkError if the system cannot send there, as when no network leads
    /// to the address.
    void sendDue(TimePoint now);

    /// Says of every universe that it ends, and forgets it. Throws NetworkError as sendDue.
    void terminate();

    std::uint64_t packetCount() const;  ///< Datagrams sent so far.

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
