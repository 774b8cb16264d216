#include "app/show_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/toml_reader.h"

namespace hazer::app {
namespace {

// Those that have a transport in its order; "file" is app/show_recording.h's.
const std::vector<std::string> kInputProtocols{"artnet", "sacn", "usb", "file"};
const std::vector<std::string> kMergeModes{"htp", "ltp"};  // in the order of protocol::MergeMode
const std::vector<std::string> kPreviewRules{"both", "live", "preview"};  // of protocol::PreviewRule
const std::vector<std::string> kLossRules{"hold", "fade"};

constexpr Limits kFadeS{0.0, 3600.0};

protocol::LossRule readLoss(TomlReader& reader) {
    protocol::LossRule loss;
    loss.fadesOut = reader.choice("on_loss", kLossRules, 0) == 1;
    const double otherwiseS = std::chrono::duration<double>(loss.fadeTime).count();
    if (!loss.fadesOut && reader.has("fade_s")) {
        reader.fail("fade_s does nothing unless on_loss is \"fade\"; set that or take fade_s out");
    }
    loss.fadeTime =
        std::chrono::milliseconds(std::lround(1000.0 * reader.number("fade_s", otherwiseS, kFadeS)));
    return loss;
}

void readArtNet(TomlReader& reader, ShowInput& input) {
    input.address = reader.text("address", input.address);
    input.port = static_cast<std::uint16_t>(reader.integer("port", input.port, {0, 65535}));
    input.isProgrammable = reader.flag("programmable", false);
}

void readSacn(TomlReader& reader, ShowInput& input) {
    input.interface = reader.text("interface", "");
    input.preview = static_cast<protocol::PreviewRule>(reader.choice("preview", kPreviewRules, 0));
    input.port = static_cast<std::uint16_t>(reader.integer("port", input.port, {0, 65535}));
}

void readUsb(TomlReader& reader, ShowInput& input) {
    input.usbSerial = reader.text("serial", "");
    if (reader.has("universe"))
        input.usbUniverse = static_cast<std::uint16_t>(reader.requiredInteger("universe", {1, 65535}));
}

bool mergesAlike(const ShowInput& a, const ShowInput& b) {
    return a.merge == b.merge && a.loss.fadesOut == b.loss.fadesOut && a.loss.fadeTime == b.loss.fadeTime;
}

}  // namespace

ShowInput inputOf(protocol::Transport transport) {
    ShowInput input;
    input.transport = transport;
    if (transport == protocol::Transport::kSacn) input.port = protocol::kSacnPort;
    return input;
}

protocol::MergeRules readMerging(TomlReader& reader) {
    protocol::MergeRules rules;
    rules.mode = static_cast<protocol::MergeMode>(reader.choice("merge", kMergeModes, 0));
    rules.loss = readLoss(reader);
    return rules;
}

ShowInput readInput(TomlReader& reader) {
    constexpr std::array kTransports{protocol::Transport::kArtNet, protocol::Transport::kSacn,
                                     protocol::Transport::kDmx};
    ShowInput input = inputOf(kTransports[reader.choice("protocol", kInputProtocols, 0)]);
    input.line = reader.line();
    if (input.transport == protocol::Transport::kDmx) {
        readUsb(reader, input);
    } else if (input.transport == protocol::Transport::kSacn) {
        readSacn(reader, input);
    } else {
        readArtNet(reader, input);
    }
    const protocol::MergeRules rules = readMerging(reader);
    input.merge = rules.mode;
    input.loss = rules.loss;
    reader.refuseUnknownKeys();
    return input;
}

void refuseContradictions(const std::vector<ShowInput>& inputs, const std::filesystem::path& file) {
    for (const ShowInput& input : inputs) {
        const auto first = std::ranges::find(inputs, input.transport, &ShowInput::transport);
        if (mergesAlike(*first, input)) continue;
        failInShow(file, input.line,
                   fmt::format(
                       "an input of the same protocol in line {} has another merge, on_loss or fade_s; their "
                       "universes are the same, so give both the same",
                       first->line));
    }
}

}  // namespace hazer::app
