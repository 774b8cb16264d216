#include "protocol/sacn_group.h"

namespace hazer::protocol {
namespace {

std::uint8_t highByte(std::uint16_t value) {
    return static_cast<std::uint8_t>(value >> 8);
}

std::uint8_t lowByte(std::uint16_t value) {
    return static_cast<std::uint8_t>(value & 0xFF);
}

}  // namespace

IpEndpoint sacnGroupV4(std::uint16_t universe, std::uint16_t port) {
    return {.address = {239, 255, highByte(universe), lowByte(universe)}, .isIpv6 = false, .port = port};
}

IpEndpoint sacnGroupV6(std::uint16_t universe, std::uint16_t port) {
    return {.address = {0xFF, 0x18, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x83, 0x00, highByte(universe),
                        lowByte(universe)},
            .isIpv6 = true,
            .port = port};
}

bool isMulticast(const IpEndpoint& endpoint) {
    return endpoint.isIpv6 ? endpoint.address[0] == 0xFF : (endpoint.address[0] & 0xF0) == 0xE0;
}

bool isWrongGroup(const IpEndpoint& to, std::uint16_t universe) {
    if (!isMulticast(to)) return false;
    return to != (to.isIpv6 ? sacnGroupV6(universe, to.port) : sacnGroupV4(universe, to.port));
}

}  // namespace hazer::protocol
