// Art-Net datagrams written out by hand, so that the tests do not believe the code under test.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hazer::protocol::test {

using Bytes = std::vector<std::uint8_t>;

struct DmxFields {
    std::uint8_t sequence = 0;
    std::uint8_t physical = 0;
    std::uint8_t subUni = 0;
    std::uint8_t net = 0;
    std::optional<std::uint16_t> claimedLength{};  // absent: the true one
    Bytes slots{1, 2, 3, 4};
};

Bytes dmxDatagram(const DmxFields& fields);

/// A poll of 22 bytes that asks every node.
Bytes pollDatagram();

/// A poll in targeted mode.
Bytes targetedPollDatagram(std::uint16_t first, std::uint16_t last);

/// The first `size` bytes in a heap block of exactly that size, where a sanitizer sees any read beyond.
Bytes prefixOf(std::span<const std::uint8_t> bytes, std::size_t size);

}  // namespace hazer::protocol::test
