// A merger that several threads share: receivers write, a frame takes one consistent set.
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "protocol/dmx.h"
#include "protocol/universe_merger.h"
#include "protocol/universe_status.h"

namespace hazer::protocol {

/// Thread-safe. Written by receiving threads, read once a frame.
class UniverseStore {
 public:
    explicit UniverseStore(MergeRules rules = {}) : merger_(rules) {}

    /// Runs `change(UniverseMerger&)` while nobody else has the merger, and gives back what it gives. A
    /// receiver handles a whole batch of datagrams in one change. Times are best read inside, so that they do
    /// not go back.
    template <class Change>
    decltype(auto) change(Change&& change) {
        const std::lock_guard lock(mutex_);
        return std::forward<Change>(change)(merger_);
    }

    /// Copies everything that stands at `now` into `out`, as one consistent set. Reuses the nodes of `out`:
    /// once it holds every universe, a latch does not allocate.
    void latch(UniverseSet& out, TimePoint now);

    /// Everything there is to tell at `now`.
    std::vector<UniverseStatus> status(TimePoint now);

 private:
    std::mutex mutex_;
    UniverseMerger merger_;
};

}  // namespace hazer::protocol
