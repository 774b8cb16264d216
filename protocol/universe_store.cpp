#include "protocol/universe_store.h"

namespace hazer::protocol {

void UniverseStore::latch(UniverseSet& out, TimePoint now) {
    const std::lock_guard lock(mutex_);
    merger_.expire(now);
    merger_.latch(out, now);
}

std::vector<UniverseStatus> UniverseStore::status(TimePoint now) {
    const std::lock_guard lock(mutex_);
    merger_.expire(now);
    return merger_.status(now);
}

}  // namespace hazer::protocol
