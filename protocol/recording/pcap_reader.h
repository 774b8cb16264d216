// Captures of networks: pcap and pcapng, read by libpcap.
#pragma once

#include <filesystem>
#include <memory>

#include "protocol/recording/recording.h"

namespace hazer::protocol {

/// Reads Art-Net and sACN out of a capture: UDP to port 6454 or 5568, or to any port if the payload begins as
/// either does. Everything else is passed over. Link types: Ethernet with VLAN tags, Linux cooked, loopback,
/// raw IP; IPv4 and IPv6, fragments joined. A capture that was cut gives what is whole, with a warning.
/// Throws RecordingError if it is no capture, or one of something that is no network.
std::unique_ptr<RecordingReader> openPcap(const std::filesystem::path& file);

}  // namespace hazer::protocol
