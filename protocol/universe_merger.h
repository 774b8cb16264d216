// Who wins a universe: levels of any number of sources in, one look out. Merging, priorities, synchronization
// and loss for every transport, without sockets or clocks. docs/protocols.md tells the same as scenarios and
// rules.
#pragma once

#include <array>
#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/dmx.h"
#include "protocol/universe_status.h"

namespace hazer::protocol {

/// How sources of equal priority become one look.
enum class MergeMode : std::uint8_t {
    kHighest,  ///< Highest takes precedence (HTP), slot by slot.
    /// Latest takes precedence (LTP): the whole packet of the source whose levels changed last. A packet that
    /// repeats its levels is not later, or two desks that both send all the time would flicker.
    kLatest,
};

/// What becomes of a look when its last source is lost.
struct LossRule {
    bool fadesOut = false;                     ///< Else the last look stands.
    std::chrono::milliseconds fadeTime{2000};  ///< From the loss to dark.
};

struct MergeRules {
    MergeMode mode = MergeMode::kHighest;  ///< Of every universe that setMode has not been called for.
    LossRule loss{};
    /// A second source waits this long for its per-address priorities before its levels count
    /// (ETC's sampling period). The first source of a universe never waits.
    std::chrono::milliseconds samplingPeriod{1500};
    std::size_t sacnSourcesPerUniverse = 16;
    /// Universes that are remembered beyond those that were asked for. Those that were lost longest ago make
    /// room for new ones, a sixteenth of so many at once; one with a live source never does.
    std::size_t unaskedUniverses = 4096;
};

/// One packet of levels, as every transport gives it.
struct Levels {
    UniverseId universe{};
    SourceId source{};
    std::uint8_t priority = kDefaultPriority;  ///< 0..200. Art-Net and USB have none and give the default.
    std::span<const std::uint8_t> slots{};     ///< 0..512 values; missing ones are 0 and are not controlled.
    bool isPreview = false;                    ///< sACN Preview_Data, for the status alone.
    std::string_view name{};                   ///< As with describe; empty: as it was.
    std::string_view address{};                ///< The same.
};

/// Levels that wait for a synchronization packet of this group. Art-Net: one group for each sending address
/// (its four bytes as a number); sACN: the synchronization address.
struct SyncGroup {
    Transport transport = Transport::kSacn;
    std::uint32_t address = 0;
    auto operator<=>(const SyncGroup&) const = default;
};

enum class Verdict : std::uint8_t {
    kTaken,
    kTooManySources,    ///< Art-Net: a third source. sACN: beyond MergeRules::sacnSourcesPerUniverse.
    kTooManyUniverses,  ///< Not asked for, and all remembered ones are live.
};

/// Not thread-safe; times handed in must not go back. Memory is bounded whatever arrives, and nothing is
/// allocated once every source and universe has been seen.
class UniverseMerger {
 public:
    explicit UniverseMerger(MergeRules rules = {});
    ~UniverseMerger();
    UniverseMerger(const UniverseMerger& other);  ///< The copy goes on exactly as the other would.
    UniverseMerger& operator=(const UniverseMerger& other);
    UniverseMerger(UniverseMerger&&) noexcept;
    UniverseMerger& operator=(UniverseMerger&&) noexcept;

    const MergeRules& rules() const;

    /// A universe that is patched: always has room. Transport::kAny asks for the number on every transport
    /// and merges them as one universe.
    void ask(UniverseId universe);

    /// Levels that show at once. Drops what the source holds back.
    Verdict show(const Levels& levels, TimePoint now);

    /// Levels that wait for showHeld(group); newer ones replace older ones. Counts as a sign of life.
    Verdict hold(const Levels& levels, SyncGroup group, TimePoint now);

    /// Shows everything that waits for `group`, all at once. Returns the number of universes that changed
    /// hands.
    std::size_t showHeld(SyncGroup group, TimePoint now);

    /// Per-address priorities (start code 0xDD): 0 = not controlled, 1..200. Missing ones are 0. They may
    /// come before the first levels.
    Verdict setSlotPriorities(UniverseId universe, const SourceId& source,
                              std::span<const std::uint8_t> priorities, TimePoint now);

    /// The source says that it stops (Stream_Terminated, a USB interface pulled).
    void leave(UniverseId universe, const SourceId& source, TimePoint now);

    /// What to call a source in the status.
    void describe(UniverseId universe, const SourceId& source, std::string_view name,
                  std::string_view address);

    /// Counts a packet that came out of order, for the status.
    void countLate(UniverseId universe, const SourceId& source);

    /// Of one universe, known or not, in place of MergeRules; if only seen in Transport::kAny: of that whole.
    void setMode(UniverseId universe, MergeMode mode);
    MergeMode mode(UniverseId universe) const;
    void setLoss(UniverseId universe, LossRule loss);

    /// ArtAddress AcCancelMerge: from the next levels on, only their source counts until another stays alone.
    void cancelMerge(UniverseId universe);

    /// ArtAddress AcClearOp: all slots 0 until the next levels.
    void clear(UniverseId universe, TimePoint now);

    /// Whether any source of this universe is alive.
    bool isLive(UniverseId universe, TimePoint now);

    /// Whether two sources or more of this universe are alive.
    bool isMerging(UniverseId universe, TimePoint now);

    /// When a source will be lost, a sampling period ends or a held look has to be let go; nothing then:
    /// never.
    std::optional<TimePoint> nextDeadline() const;

    /// Lets go of what is overdue at `now`. Call before reading, and at nextDeadline.
    void expire(TimePoint now);

    /// Copies every look as it stands at `now`, a fade included. Reuses the nodes of `out`.
    void latch(UniverseSet& out, TimePoint now) const;

    /// Universes that had to make room for others (MergeRules::unaskedUniverses).
    std::uint64_t evictedUniverses() const;

    /// Sources of all universes, lost ones included.
    std::size_t sourceCount() const;

    /// Everything there is to tell about universes and sources, at `now`, ascending by universe.
    std::vector<UniverseStatus> status(TimePoint now) const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
