// What arrives on the network: datagrams counted, universes slot by slot.
#pragma once

#include "app/session.h"
#include "app/window_packet_rates.h"

namespace hazer::app {

void drawNetwork(const Session& session, const WindowPacketRates& rates);

}  // namespace hazer::app
