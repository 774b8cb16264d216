// hazer record: what arrives on the network and by USB, into a file that Wireshark reads.
#include <fmt/format.h>
#include <signal.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "app/commands/command.h"
#include "app/interrupt.h"
#include "app/moment.h"
#include "app/show_universes.h"
#include "app/status_line.h"
#include "protocol/receiver.h"
#include "protocol/recording/recorder.h"
#include "protocol/recording/usb_wrapping.h"
#include "protocol/sacn_receiver.h"
#include "protocol/universe_store.h"
#include "protocol/usb/usb_input.h"

namespace hazer::app {
namespace {

struct RecordOptions {
    std::string show;
    std::string out;
    std::vector<std::uint16_t> sacnUniverses;
    std::optional<double> seconds;
    std::optional<std::uint16_t> port;
    std::optional<std::uint16_t> sacnPort;
    bool replaces = false;
    bool isJson = false;
};

std::vector<protocol::UniverseId> wantedBy(const RecordOptions& options) {
    std::vector<protocol::UniverseId> universes;
    if (!options.show.empty()) universes = universesOf(loadShow(options.show));
    for (const std::uint16_t number : options.sacnUniverses) {
        universes.push_back({protocol::Transport::kSacn, number});
    }
    return universes;
}

/// Everything that can be recorded, each on a thread of its own, into one file.
class Sources {
 public:
    Sources(const RecordOptions& options, protocol::Recorder& recorder) : usbRecording_(recorder) {
        const auto tap = [&recorder](const protocol::Datagram& datagram) { recorder.record(datagram); };
        const std::vector<protocol::UniverseId> universes = wantedBy(options);
        protocol::ReceiverConfig artNet;
        artNet.port = options.port.value_or(artNet.port);
        artNet.portAddresses = numbersOn(protocol::Transport::kArtNet, universes);
        artNet.tap = tap;
        artNet_.emplace(artNet, store_);
        protocol::SacnReceiverConfig sacn;
        sacn.port = options.sacnPort.value_or(sacn.port);
        sacn.universes = numbersOn(protocol::Transport::kSacn, universes);
        sacn.tap = tap;
        sacn.notice = [](const std::string& sentence) { spdlog::warn("{}", sentence); };
        sacn_.emplace(sacn, store_);
        if (protocol::UsbInput::isBuiltIn()) usb_.emplace(usbConfig(), store_);
    }

 private:
    protocol::UsbConfig usbConfig() {
        protocol::UsbConfig config;
        config.tap = [this](protocol::UniverseId universe, std::span<const std::uint8_t> slots,
                            protocol::WallTime time) { usbRecording_.record(universe, slots, time); };
        return config;
    }

    protocol::UsbRecording usbRecording_;
    protocol::UniverseStore store_;
    std::optional<protocol::Receiver> artNet_;
    std::optional<protocol::SacnReceiver> sacn_;
    std::optional<protocol::UsbInput> usb_;
};

/// Until Ctrl-C, the end of the time, or a disk that takes no more.
double recordUntilDone(const RecordOptions& options, protocol::Recorder& recorder) {
    const Sources sources(options, recorder);
    const Interrupt interrupt;
    StatusLine line;
    const protocol::TimePoint start = protocol::Clock::now();
    double passedS = 0.0;
    while (!interrupt.asked() && recorder.status().failure.empty() &&
           passedS < options.seconds.value_or(passedS + 1.0)) {
        constexpr double kLookEveryS = 0.05;
        const double restS =
            options.seconds ? std::min(kLookEveryS, *options.seconds - passedS) : kLookEveryS;
        std::this_thread::sleep_for(std::chrono::duration<double>(restS));
        passedS = std::chrono::duration<double>(protocol::Clock::now() - start).count();
        line.show([&] {
            const protocol::RecorderStatus status = recorder.status();
            return fmt::format("{}  {} packets, {:.1f} MB, {} dropped",
                               momentText(std::chrono::nanoseconds(static_cast<std::int64_t>(passedS * 1e9))),
                               status.packets, 1e-6 * static_cast<double>(status.bytes), status.dropped);
        });
    }
    return passedS;
}

/// What could not even begin to listen leaves no empty file behind.
double recordOrRemove(const RecordOptions& options, protocol::Recorder& recorder) {
    try {
        return recordUntilDone(options, recorder);
    } catch (const std::exception&) {
        recorder.finish();
        std::filesystem::remove(options.out);
        throw;
    }
}

std::string summaryOf(const protocol::RecorderStatus& status, double seconds, const RecordOptions& options) {
    if (!options.isJson) {
        return fmt::format("{}: {} packets in {:.1f} s, {} dropped\n", options.out, status.packets, seconds,
                           status.dropped);
    }
    const nlohmann::ordered_json json{{"file", options.out},       {"seconds", seconds},
                                      {"packets", status.packets}, {"bytes", status.bytes},
                                      {"dropped", status.dropped}, {"failure", status.failure}};
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int runRecord(const RecordOptions& options) {
    // A limit of the system on the size of files shall end the recording with a sentence, not the program.
    ::signal(SIGXFSZ, SIG_IGN);
    protocol::Recorder recorder({.file = options.out, .replacesFile = options.replaces});
    fmt::print(stderr, "recording to {}{}\n", options.out, options.seconds ? "" : "; Ctrl-C ends it");
    const double seconds = recordOrRemove(options, recorder);
    recorder.finish();
    const protocol::RecorderStatus status = recorder.status();
    fmt::print("{}", summaryOf(status, seconds, options));
    if (status.failure.empty() && status.dropped > 0) {
        spdlog::warn("{} packets are missing: the disk was too slow for them", status.dropped);
    }
    if (status.failure.empty()) return kExitOk;
    fmt::print(stderr, "hazer: {}\n", status.failure);
    return kExitBadInput;
}

}  // namespace

void addRecordCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<RecordOptions>();
    CLI::App* command =
        program.add_subcommand("record", "Record what arrives by Art-Net, sACN and USB, for Wireshark too.");
    beginHelpWith(*command,
                  "  hazer record --out night.pcap                 until Ctrl-C\n"
                  "  hazer record --out night.pcap myshow.toml     asks desks for the universes of a show\n"
                  "  hazer record --out night.pcap --universe 1 --universe 2 --for 60\n");
    command->add_option("SHOW", options->show, "A show (.toml) whose universes to ask for");
    command->add_option("--out", options->out, "The file, a pcap with nanoseconds")->required();
    command
        ->add_option("--universe", options->sacnUniverses,
                     "An sACN universe, 1..63999, to join the multicast group of; may be repeated")
        ->check(CLI::Range(1, 63999));
    command->add_option("--for", options->seconds, "How many seconds; until Ctrl-C unless given")
        ->check(numberFrom(0.001, 8640000.0));
    command->add_option("--port", options->port, "UDP port of Art-Net; 6454 unless given")
        ->check(CLI::Range(0, 65535));
    command->add_option("--sacn-port", options->sacnPort, "UDP port of sACN; 5568 unless given")
        ->check(CLI::Range(0, 65535));
    command->add_flag("--force", options->replaces, "Replace the file if there is one");
    command->add_flag("--json", options->isJson, "Print the summary as JSON");
    command->callback([options, &chosen] { chosen = [options] { return runRecord(*options); }; });
}

}  // namespace hazer::app
