// What arrives, universe by universe and source by source, as a table for people and as JSON for machines.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "protocol/artnet_node.h"
#include "protocol/sacn_receiver.h"
#include "protocol/universe_status.h"
#include "protocol/usb/usb_input.h"

namespace hazer::app {

/// What a monitor shows of one moment.
struct MonitorView {
    std::vector<protocol::UniverseStatus> universes;
    protocol::ArtNetStatus artNet;
    std::vector<protocol::SacnReport> sacn;  ///< Receiver by receiver.
    std::vector<protocol::UsbLineStatus> usbDevices;
    protocol::TimePoint now;
    double timeS = 0.0;                           ///< Since the monitor began.
    std::vector<protocol::UniverseId> showSlots;  ///< Those whose slots are wanted.
};

/// Lines of at most 100 columns, each with its end: universes with their sources, counters, time code,
/// trigger, what sACN sources announce, USB interfaces, and the slots that are wanted.
std::string monitorTable(const MonitorView& view);

/// {"time_s", "packets", "refused", "malformed", ..., "timecode", "trigger", "universes": [{"protocol",
/// "universe", "asked", "lost", "merging", "packets", "refused_sources", "sources": [{"name", "address",
/// "priority", "slot_priorities", "alive", "winning", "preview", "synchronized", "packets_per_s", "packets",
/// "late", "losses"}], "slots": [of those that are wanted]}], "sacn": [receiver by receiver: {"levels",
/// "late", "refused", "malformed", "announced": [{"name", "address", "universes"}]}], "usb": [as usbLineJson
/// has it]}
nlohmann::ordered_json monitorJson(const MonitorView& view);

/// "01:02:03:04 at 25 fps".
std::string timeCodeText(const protocol::ArtTimeCode& code);

/// "show 7", "key 'a'".
std::string triggerText(const protocol::ReceivedTrigger& trigger);

}  // namespace hazer::app
