// The sockets of an sACN receiver: as many as the groups that it listens to need. Only for .cpp files of this
// module.
#pragma once

#include <asio/io_context.hpp>
#include <asio/ip/udp.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "protocol/sacn_membership.h"

namespace hazer::protocol {

/// All bound to one port. A socket joins at most kGroupsPerSocket groups, since systems allow no more
/// (Linux: net.ipv4.igmp_max_memberships, 20), and hears only the groups that it has joined itself.
class SacnSockets {
 public:
    static constexpr std::size_t kGroupsPerSocket = 20;

    /// Called on the thread of the context whenever a socket can be read.
    using OnReadable = std::function<void(asio::ip::udp::socket&)>;
    using OnNotice = std::function<void(const std::string&)>;

    /// Binds one socket for IPv4 and, where there is IPv6, one for it. `local4` and `local6` may be the
    /// wildcard; port 0 lets the system choose; nothing: no socket of that version. Throws NetworkError.
    SacnSockets(asio::io_context& context, std::optional<asio::ip::address_v4> local4,
                std::optional<asio::ip::address_v6> local6, std::uint16_t port, OnReadable onReadable,
                OnNotice onNotice);

    std::uint16_t port() const { return port_; }
    bool hasIpv6() const { return hasIpv6_; }

    /// Leaves what is not wanted any more and joins what is new. What cannot be joined is tried again with
    /// the next call.
    void setMemberships(const std::set<SacnMembership>& wanted);

    std::size_t membershipCount() const;
    std::size_t socketCount() const { return sockets_.size(); }

 private:
    struct GroupSocket {
        GroupSocket(asio::io_context& context, bool isV6) : socket(context), isIpv6(isV6) {}
        asio::ip::udp::socket socket;
        bool isIpv6;
        bool isFull = false;  ///< The system let it join no more.
        std::set<SacnMembership> joined;
    };

    GroupSocket& open(const asio::ip::address& local);
    void waitFor(GroupSocket& one);
    void leave(GroupSocket& one, const SacnMembership& membership);
    void join(const SacnMembership& membership);
    bool tryJoin(GroupSocket& one, const SacnMembership& membership);
    GroupSocket* withRoom(bool isIpv6);
    void noticeOnce(const std::string& sentence);

    asio::io_context& context_;
    OnReadable onReadable_;
    OnNotice onNotice_;
    std::uint16_t port_ = 0;
    bool hasIpv6_ = false;
    std::vector<std::unique_ptr<GroupSocket>> sockets_;
    std::set<std::string> noticed_;
};

}  // namespace hazer::protocol
