// Which USB interfaces there are, and what is wrong with those that cannot be used.
#pragma once

#include "app/session.h"

namespace hazer::app {

void drawUsb(const Session& session);

}  // namespace hazer::app
