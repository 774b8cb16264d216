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
#include "app/commands/watched_inputs.h"
#include "app/interrupt.h"
#include "app/moment.h"
#include "app/status_line.h"
#include "protocol/recording/recorder.h"
#include "protocol/recording/usb_wrapping.h"

namespace hazer::app {
namespace {

struct RecordOptions {
    WatchedInputs watched;
    std::string out;
    std::optional<double> seconds;
    bool replaces = false;
    bool isJson = false;
};

/// Everything that arrives, each input on a thread of its own, into one file.
class Tapped {
 public:
    Tapped(const WatchedInputs& watched, protocol::Recorder& recorder)
        : usbRecording_(recorder), inputs_(showToWatch(watched)) {
        ListenOptions options = listenOptionsOf(watched);
        options.tap = [&recorder](const protocol::Datagram& datagram) { recorder.record(datagram); };
        options.usbTap = [this](protocol::UniverseId universe, std::span<const std::uint8_t> slots,
                                protocol::WallTime time) { usbRecording_.record(universe, slots, time); };
        inputs_.listen(options);
    }

    std::string description() const { return inputs_.description(); }

 private:
    protocol::UsbRecording usbRecording_;
    Inputs inputs_;
};

/// Until Ctrl-C, the end of the time, or a disk that takes no more.
double recordUntilDone(const RecordOptions& options, protocol::Recorder& recorder) {
    const Tapped tapped(options.watched, recorder);
    fmt::print(stderr, "recording {} to {}{}\n", tapped.description(), options.out,
               options.seconds ? "" : "; Ctrl-C ends it");
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
                  "  hazer record --out night.pcap                 whatever arrives, until Ctrl-C\n"
                  "  hazer record --out night.pcap myshow.toml     what the inputs of a show hear\n"
                  "  hazer record --out night.pcap --universe 1-8 --for 60\n");
    addWatchedInputs(*command, options->watched);
    command->add_option("--out", options->out, "The file, a pcap with nanoseconds")->required();
    command->add_option("--for", options->seconds, "How many seconds; until Ctrl-C unless given")
        ->check(numberFrom(0.001, 8640000.0));
    command->add_flag("--force", options->replaces, "Replace the file if there is one");
    command->add_flag("--json", options->isJson, "Print the summary as JSON");
    command->callback([options, &chosen] { chosen = [options] { return runRecord(*options); }; });
}

}  // namespace hazer::app
