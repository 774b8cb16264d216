// hazer monitor: who sends what, without a picture.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "app/commands/command.h"
#include "app/commands/watched_inputs.h"
#include "app/inputs.h"
#include "app/interrupt.h"
#include "app/monitor.h"

namespace hazer::app {
namespace {

constexpr double kDefaultLookS = 3.0;
constexpr double kTableIntervalS = 0.5;
constexpr double kJsonIntervalS = 1.0;

// Cursor to the corner, and clear what is below: no flicker, as with a cleared screen.
constexpr const char* kBackToCorner = "\x1b[H";
constexpr const char* kClearLineEnd = "\x1b[K";
constexpr const char* kClearBelow = "\x1b[J";
constexpr const char* kClearScreen = "\x1b[2J";

struct MonitorOptions {
    WatchedInputs watched;
    std::optional<double> seconds;
    bool json = false;
    bool follow = false;
    std::vector<int> slots;
};

class Monitor {
 public:
    explicit Monitor(const MonitorOptions& options)
        : options_(options), inputs_(showToWatch(options.watched)) {
        inputs_.listen(listenOptionsOf(options.watched));
        fmt::print(stderr, "listening to {}{}\n", inputs_.description(),
                   repeats() && !options.seconds ? "; Ctrl-C ends it" : "");
    }

    int run() {
        if (options_.json && repeats()) return repeat(kJsonIntervalS, [&] { printJson(-1); });
        if (repeats()) {
            fmt::print("{}", kClearScreen);
            return repeat(kTableIntervalS, [&] { redraw(); });
        }
        waitUntil(options_.seconds.value_or(kDefaultLookS));
        options_.json ? printJson(2) : static_cast<void>(fmt::print("{}", monitorTable(view())));
        return kExitOk;
    }

 private:
    // A table refreshes in place where somebody watches.
    bool repeats() const { return options_.json ? options_.follow : isatty(STDOUT_FILENO) != 0; }

    template <class Show>
    int repeat(double intervalS, Show show) {
        for (int i = 1; !interrupt_.asked(); ++i) {
            const double nextS = i * intervalS;
            if (options_.seconds && nextS > *options_.seconds + 1e-9) break;
            waitUntil(nextS);
            show();
            std::fflush(stdout);
        }
        return kExitOk;
    }

    void waitUntil(double timeS) {
        using namespace std::chrono_literals;
        while (!interrupt_.asked()) {
            const double leftS = timeS - timeNowS();
            if (leftS <= 0.0) return;
            std::this_thread::sleep_for(
                std::min(std::chrono::duration<double>(leftS), std::chrono::duration<double>(50ms)));
        }
    }

    void printJson(int indent) { fmt::print("{}\n", monitorJson(view()).dump(indent)); }

    void redraw() {
        std::string text = monitorTable(view());
        for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', end)) {
            text.insert(end, kClearLineEnd);
            end += std::char_traits<char>::length(kClearLineEnd) + 1;
        }
        fmt::print("{}{}{}", kBackToCorner, text, kClearBelow);
    }

    MonitorView view() {
        MonitorView view;
        view.now = protocol::Clock::now();
        view.universes = inputs_.status(view.now);
        view.artNet = inputs_.artNet();
        view.sacn = inputs_.sacn();
        view.usbDevices = inputs_.usbDevices();
        view.timeS = timeNowS();
        for (const protocol::UniverseStatus& universe : view.universes) {
            if (std::ranges::find(options_.slots, universe.universe.number) != options_.slots.end()) {
                view.showSlots.push_back(universe.universe);
            }
        }
        return view;
    }

    double timeNowS() const { return std::chrono::duration<double>(protocol::Clock::now() - start_).count(); }

    const MonitorOptions& options_;
    Inputs inputs_;
    Interrupt interrupt_;
    protocol::TimePoint start_ = protocol::Clock::now();
};

}  // namespace

void addMonitorCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<MonitorOptions>();
    CLI::App* command =
        program.add_subcommand("monitor", "See who sends which universe: sources, rates, losses, winners.");
    beginHelpWith(
        *command,
        "  hazer monitor                          whatever arrives, until Ctrl-C\n"
        "  hazer monitor myshow.toml --slots 1    the inputs of a show, with the values of universe 1\n"
        "  hazer monitor --universe 1-8           joins sACN universes that nobody announces, too\n"
        "  hazer monitor --json --for 5           one JSON document after five seconds\n"
        "  hazer monitor --json --follow          one line of JSON a second\n");
    addWatchedInputs(*command, options->watched);
    command->add_flag("--json", options->json, "JSON in place of a table");
    command->add_flag("--follow", options->follow, "With --json: a line a second, until Ctrl-C or --for");
    command->add_option("--slots", options->slots, "Show the values of this universe, too; may be repeated")
        ->check(CLI::Range(0, 65535));
    command->add_option("--for", options->seconds, "Seconds; 3 unless given, in a terminal until Ctrl-C")
        ->check(numberFrom(0.1, 1e6));
    command->callback([options, &chosen] { chosen = [options] { return Monitor(*options).run(); }; });
}

}  // namespace hazer::app
