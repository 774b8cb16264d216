// hazer inspect: what is in a fixture file, a show or a recording.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/attribute_values.h"
#include "app/commands/command.h"
#include "app/commands/recording_options.h"
#include "app/fixture_library.h"
#include "app/inspection.h"
#include "app/moment.h"
#include "app/recording_summary.h"
#include "app/rig_inspection.h"
#include "app/show_rig.h"
#include "fixtures/fixture_file.h"
#include "fixtures/mvr.h"
#include "protocol/recording/recording_player.h"

namespace hazer::app {
namespace {

struct InspectOptions {
    std::string file;
    bool isJson = false;
    std::string
        at;  ///< A moment of a recording, or values of a fixture's attributes; empty: its end, or at rest.
    protocol::FrameMap map;
};

/// Names come from other people's files: what is not UTF-8 in them must not end the program.
std::string printable(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string inspectShow(const InspectOptions& options) {
    const Show show = loadShow(options.file);
    const Patch patch(show);
    for (const std::string& overlap : patch.overlaps()) {
        fmt::print(stderr, "hazer: warning: {}: {}\n", options.file, overlap);
    }
    return options.isJson ? printable(describeShow(show, patch)) : summarizeShow(show, patch);
}

std::string inspectRig(const InspectOptions& options) {
    const std::vector<std::string> warnings = loadShow(options.file).warnings;
    const fixtures::MvrScene scene = fixtures::MvrArchive(options.file).readScene();
    return options.isJson ? printable(describeRig(scene, warnings)) : summarizeRig(scene, warnings);
}

std::string inspectFixtureType(const InspectOptions& options) {
    const AttributeValues values = options.at.empty() ? AttributeValues() : parseAttributeValues(options.at);
    const fixtures::FixtureTypePtr type = fixtures::loadFixtureType(resolveGdtf(options.file, {}));
    return options.isJson ? printable(describeFixtureType(type, values)) : summarizeFixtureType(*type);
}

double secondsOf(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

/// Goes to the moment that is asked about and returns the duration, which a capture tells only when it has
/// been read to its end.
double goTo(const std::optional<std::chrono::nanoseconds>& moment, protocol::RecordingPlayer& player) {
    player.goToEnd();
    for (const std::string& warning : player.warnings()) fmt::print(stderr, "hazer: warning: {}\n", warning);
    const double durationS = secondsOf(player.time());
    if (moment) player.goTo(*moment);
    return durationS;
}

std::optional<std::chrono::nanoseconds> momentOf(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const auto moment = parseMoment(text);
    if (!moment) throw std::runtime_error(fmt::format("'{}' is no time; write 80, 1:20 or 1:02:03.5", text));
    return moment;
}

std::string inspectRecording(const InspectOptions& options) {
    const protocol::ReplayRules rules{.fileName = std::filesystem::path(options.file).filename().string()};
    protocol::RecordingPlayer player(options.file, options.map, rules,
                                     protocol::RecordingPlayer::Indexing::kNone);
    const double durationS = goTo(momentOf(options.at), player);
    return options.isJson ? printable(describeRecording(player, durationS))
                          : summarizeRecording(player, durationS);
}

std::string inspectFile(const InspectOptions& options) {
    if (protocol::isRecording(options.file)) return inspectRecording(options);
    const bool isShow = std::filesystem::path(options.file).extension() == ".toml";
    const bool isFixture = !isShow && !isRig(options.file);
    if (!options.at.empty() && !(isFixture && options.isJson))
        throw std::runtime_error("--at is for recordings, and with --json for fixture files");
    if (isFixture) return inspectFixtureType(options);
    return isShow ? inspectShow(options) : inspectRig(options);
}

int runInspect(const InspectOptions& options) {
    fmt::print("{}", inspectFile(options));
    return kExitOk;
}

/// Empty if the text is a moment or values of attributes, else what is wrong with it.
std::string checkAt(const std::string& text) {
    if (parseMoment(text)) return {};
    try {
        parseAttributeValues(text);
        return {};
    } catch (const std::runtime_error&) {
        return fmt::format("'{}' is neither a time such as 1:20 nor values such as Pan=90,Tilt=45", text);
    }
}

}  // namespace

void addInspectCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<InspectOptions>();
    CLI::App* command = program.add_subcommand("inspect",
                                               "Say what is in a fixture file (GDTF, QLC+, Open Fixture "
                                               "Library), a rig (MVR), a show or a recording.");
    beginHelpWith(*command,
                  "  hazer inspect myshow.toml            which fixture listens to which slots\n"
                  "  hazer inspect rig.mvr                fixtures, addresses and places\n"
                  "  hazer inspect fixture.gdtf           modes, channels and wheels\n"
                  "  hazer inspect moving-spot --json     a fixture that comes with hazer, for machines\n"
                  "  hazer inspect moving-spot --json --at Pan=90,Tilt=45   where its beams are then\n"
                  "  hazer inspect night.pcap --at 1:20   what stood on the network at that moment\n");
    command
        ->add_option("FILE", options->file,
                     "A show (.toml), a rig (.mvr), a .gdtf file or its unpacked folder, a .qxf or Open "
                     "Fixture Library .json "
                     "file, a fixture of hazer's library, or a recording (pcap, pcapng, OLA show file, FSEQ)")
        ->required();
    command->add_flag("--json", options->isJson, "Print JSON");
    command
        ->add_option(
            "--at", options->at,
            "The moment of a recording; its end unless given. Of a fixture, where it stands: Pan=90,Tilt=45")
        ->type_name("TIME|VALUES")
        ->check(checkAt);
    addFrameMapOptions(*command, options->map, protocol::Transport::kDmx, true);
    command->callback([options, &chosen] { chosen = [options] { return runInspect(*options); }; });
}

}  // namespace hazer::app
