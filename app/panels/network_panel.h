// What arrives on the network: who sends each universe, its slots, time code and triggers, datagrams counted.
#pragma once

#include "app/session.h"

namespace hazer::app {

void drawNetwork(Session& session);

}  // namespace hazer::app
