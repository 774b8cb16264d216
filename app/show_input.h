// Where a show listens, and what becomes of what it hears: [[input]] in the show file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "protocol/sacn_listener.h"
#include "protocol/universe_merger.h"

namespace hazer::app {

class TomlReader;

/// A network, or, as Transport::kDmx, USB interfaces.
struct ShowInput {
    protocol::Transport transport = protocol::Transport::kArtNet;
    std::string address = "0.0.0.0";  ///< Art-Net: local IPv4 address to bind.
    std::uint16_t port = 6454;        ///< UDP.
    std::string interface {};         ///< sACN: name or address of the only interface; empty: all.
    protocol::PreviewRule preview = protocol::PreviewRule::kBoth;  ///< sACN.
    bool isProgrammable = false;  ///< Art-Net: ArtAddress may change names, addresses and merging.
    std::string usbSerial{};      ///< Of one USB interface; empty: all that no other input names.
    std::optional<std::uint16_t> usbUniverse{};  ///< That interface's number, or the first of theirs.
    /// How the universes of this transport merge. All inputs of one transport agree.
    protocol::MergeMode merge = protocol::MergeMode::kHighest;
    protocol::LossRule loss{};  ///< The same for what becomes of a look without a source.
    std::size_t line = 0;       ///< In the show file.
};

/// One that says nothing but its transport.
ShowInput inputOf(protocol::Transport transport);

/// Reads the keys that every input has for merging and loss: merge, on_loss, fade_s. Throws ShowError.
protocol::MergeRules readMerging(TomlReader& reader);

/// Reads one [[input]]. Throws ShowError.
ShowInput readInput(TomlReader& reader);

/// Throws ShowError if two inputs of one transport would merge its universes in two ways.
void refuseContradictions(const std::vector<ShowInput>& inputs, const std::filesystem::path& file);

}  // namespace hazer::app
