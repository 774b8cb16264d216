// hazer replay: sends a recording out again.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/commands/recording_options.h"
#include "app/interrupt.h"
#include "app/moment.h"
#include "app/status_line.h"
#include "protocol/recording/resender.h"

namespace hazer::app {
namespace {

struct ReplayOptions {
    std::string file;
    protocol::FrameMap map;
    protocol::ResenderConfig config;
    std::optional<std::chrono::nanoseconds> from;
    bool isJson = false;
};

std::string summaryOf(const protocol::ResenderStatus& status, bool isJson) {
    if (!isJson) {
        return fmt::format(
            "{} packets sent, up to {}; late by {:.3f} ms in the median, {:.3f} ms for 99 in 100\n",
            status.packets, momentText(status.time), 1e3 * status.medianLateS, 1e3 * status.p99LateS);
    }
    const nlohmann::ordered_json json{{"packets", status.packets},
                                      {"failed", status.failed},
                                      {"rounds", status.rounds},
                                      {"time_s", std::chrono::duration<double>(status.time).count()},
                                      {"late_median_s", status.medianLateS},
                                      {"late_p99_s", status.p99LateS},
                                      {"late_worst_s", status.worstLateS}};
    return json.dump(2) + "\n";
}

int runReplay(const ReplayOptions& options) {
    protocol::ResenderConfig config = options.config;
    config.rules.from = options.from.value_or(protocol::RecordingTime(0));
    protocol::Resender resender(options.file, options.map, config);
    fmt::print(stderr, "sending {} to {}{}\n", options.file, config.to,
               config.rules.loops ? "; Ctrl-C ends it" : "");
    {
        const Interrupt interrupt;
        StatusLine line;
        resender.run([&] {
            line.show([&] {
                const protocol::ResenderStatus status = resender.status();
                return fmt::format("{}  {} packets", momentText(status.time), status.packets);
            });
            return interrupt.asked();
        });
    }
    for (const std::string& warning : resender.warnings()) spdlog::warn("{}", warning);
    const protocol::ResenderStatus status = resender.status();
    if (status.failed > 0) spdlog::warn("{} packets could not be sent; check the address", status.failed);
    fmt::print("{}", summaryOf(status, options.isJson));
    return kExitOk;
}

}  // namespace

void addReplayCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command = program.add_subcommand("replay", "Send a recording out again, packet by packet.");
    beginHelpWith(
        *command,
        "  hazer replay night.pcap                      to this machine, as fast as it was recorded\n"
        "  hazer replay night.pcap --to 2.0.0.5 --loop  to a node, until Ctrl-C\n"
        "  hazer replay show.fseq --as sacn --first-universe 11 --from 1:20\n");
    command->add_option("FILE", options->file, "A recording: pcap, pcapng, OLA show file, FSEQ")->required();
    command->add_option("--to", options->config.to, "Address of the receiver; 127.0.0.1 unless given");
    command
        ->add_option("--port", options->config.port,
                     "UDP port; 6454 for Art-Net and 5568 for sACN unless given")
        ->check(CLI::Range(1, 65535));
    command
        ->add_option("--rate", options->config.rules.rate,
                     "Times faster than recorded, 0.01..100; 1 unless given")
        ->check(numberFrom(0.01, 100.0));
    command->add_flag("--loop", options->config.rules.loops, "Begin again at the end, until Ctrl-C");
    addMomentOption(*command, "--from", options->from, "Begin there, with what stood then; 0 unless given");
    addFrameMapOptions(*command, options->map, protocol::Transport::kArtNet, false);
    command->add_flag("--json", options->isJson, "Print the summary as JSON");
    command->callback([options, &chosen] { chosen = [options] { return runReplay(*options); }; });
}

}  // namespace hazer::app
