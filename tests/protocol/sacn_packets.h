// sACN datagrams written out by hand, so that the tests do not believe the code under test.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/protocol/packets.h"

namespace hazer::protocol::test {

struct SacnDataFields {
    std::uint8_t cid = 1;  // sixteen times
    std::string name = "desk";
    std::uint8_t priority = 100;
    std::uint16_t syncAddress = 0;
    std::uint8_t sequence = 0;
    std::uint8_t options = 0;
    std::uint16_t universe = 1;
    std::uint8_t startCode = 0;
    Bytes slots{1, 2, 3, 4};
    std::optional<std::uint16_t> claimedCount{};  // absent: the true one
};

Bytes sacnData(const SacnDataFields& fields);

Bytes sacnSync(std::uint16_t syncAddress, std::uint8_t sequence, std::uint8_t cid = 1);

struct SacnDiscoveryFields {
    std::uint8_t cid = 1;
    std::string name = "desk";
    std::uint8_t page = 0;
    std::uint8_t lastPage = 0;
    std::vector<std::uint16_t> universes{1};
};

Bytes sacnDiscovery(const SacnDiscoveryFields& fields);

/// OLA 0.10.9's draft of universe discovery, which has another layout: root vector 4, framing vector 4.
Bytes olaDraftDiscovery();

}  // namespace hazer::protocol::test
