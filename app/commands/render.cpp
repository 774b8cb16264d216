// hazer render: a picture, numbered frames or a film of a show, without a window.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "app/assignment.h"
#include "app/commands/command.h"
#include "app/commands/integrator_option.h"
#include "app/commands/max_error_option.h"
#include "app/commands/port_options.h"
#include "app/commands/recording_options.h"
#include "app/commands/size_option.h"
#include "app/film.h"
#include "app/interrupt.h"
#include "app/picture_file.h"
#include "app/progress.h"
#include "app/session.h"
#include "app/session_view.h"
#include "render/gl/headless_context.h"

namespace hazer::app {
namespace {

struct RenderOptions {
    std::string show;
    std::string out = "hazer.png";
    std::vector<std::string> assignments;
    Size size;
    std::string camera;
    double listenS = 0.0;
    InputPorts ports;
    std::optional<float> ev100;
    render::Integrator integrator = render::Integrator::kAngle;
    int samples = 0;
    std::string view = "light";
    double maxError = 0.0;
    bool hasNoBloom = false;
    std::string replay;
    protocol::FrameMap replayMap;
    std::optional<std::chrono::nanoseconds> replayFrom;
    double timeS = 0.0;
    double seconds = 0.0;  // 0: a still
    double framesPerS = 25.0;
};

std::string checkOut(const std::string& text) {
    try {
        outputKind(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

void applySettings(const RenderOptions& options, Session& session) {
    render::Settings& settings = session.settings();
    settings.width = options.size.width;
    settings.height = options.size.height;
    settings.exposureEv100 = options.ev100.value_or(settings.exposureEv100);
    settings.integrator = options.integrator;
    settings.samples = options.samples;
    settings.maxError = options.maxError;
    settings.bloom = !options.hasNoBloom;
    if (!options.camera.empty()) session.camera() = session.show().camera(options.camera).camera;
    for (const std::string& assignment : options.assignments) assign(assignment, session.patch());
    session.setTime(options.timeS);
}

/// Waits while the receiver works on its own thread.
void listenFor(double seconds) {
    const protocol::TimePoint end =
        protocol::Clock::now() +
        std::chrono::duration_cast<protocol::Clock::duration>(std::chrono::duration<double>(seconds));
    const Interrupt interrupt;
    while (protocol::Clock::now() < end && !interrupt.asked()) {
        std::this_thread::sleep_until(std::min(end, protocol::Clock::now() + std::chrono::milliseconds(50)));
    }
}

/// Silence is no mistake of the show, but whoever listens wants to know why the picture is dark.
void warnIfNothingArrived(const Session& session) {
    const std::vector<protocol::UniverseId> patched = session.patch().universes();
    const auto hasArrived = [&](const protocol::UniverseId& id) { return session.universes().contains(id); };
    if (patched.empty() || std::any_of(patched.begin(), patched.end(), hasArrived)) return;
    spdlog::warn(
        "no DMX arrived for the universes of the show by {}; check the desk's address and "
        "universe, and whether another program took it: of programs on one port only one hears what is "
        "sent to this machine alone, all hear a broadcast",
        session.inputs().description());
}

void writeView(const SessionView& view, const std::string& file) {
    makeFolderOf(file);
    if (std::filesystem::path(file).extension() == ".exr") {
        writeImage(view.numbers, file);
    } else {
        writeImage(falseColor(view.numbers, view.from, view.to), file);
    }
    fmt::print(stderr, "{}: {}; colours from {:g} (dark) to {:g} (bright)\n", view.unit,
               viewSummary(view.numbers), view.from, view.to);
}

void writeFrame(Session& session, const RenderOptions& options, const std::string& file) {
    if (options.view == "error") {
        writeView(drawErrorView(session), file);
    } else if (options.view == "cost") {
        writeView(drawCostView(session), file);
    } else {
        writePicture(session.renderer(), file);
    }
    fmt::print("{}\n", file);
}

void renderStill(Session& session, const RenderOptions& options) {
    session.draw();
    writeFrame(session, options, options.out);
}

/// Draws frame after frame, 1/fps apart, and gives each to `take(index)`.
template <typename Take>
void renderFrames(Session& session, const RenderOptions& options, Take take) {
    const int count = std::max(1, static_cast<int>(std::lround(options.seconds * options.framesPerS)));
    Progress progress("drawing frame", count);
    const Interrupt interrupt;
    for (int index = 0; index < count; ++index) {
        interrupt.throwIfAsked();
        progress.show(index + 1);
        session.draw();
        take(index);
        session.advance(1.0 / options.framesPerS);
    }
}

void renderFilm(Session& session, const RenderOptions& options) {
    makeFolderOf(options.out);
    const render::Settings& settings = session.settings();
    Film film(options.out, {settings.width, settings.height, options.framesPerS});
    renderFrames(session, options, [&](int) { film.add(session.renderer().readDisplay()); });
    film.finish();
    fmt::print("{}\n", options.out);
}

void renderNumbered(Session& session, const RenderOptions& options) {
    renderFrames(session, options,
                 [&](int index) { writeFrame(session, options, numberedFile(options.out, index).string()); });
}

void renderAsAsked(Session& session, const RenderOptions& options) {
    if (outputKind(options.out) == OutputKind::kFilm) {
        renderFilm(session, options);
    } else if (options.seconds > 0.0) {
        renderNumbered(session, options);
    } else {
        renderStill(session, options);
    }
}

SessionOptions sessionOptionsFrom(const RenderOptions& options) {
    SessionOptions session{.listen = options.listenS > 0.0, .ports = options.ports};
    if (options.replay.empty()) return session;
    session.replay = ShowRecording{.file = options.replay,
                                   .map = options.replayMap,
                                   .from = options.replayFrom.value_or(protocol::RecordingTime(0))};
    return session;
}

int runRender(RenderOptions options) {
    if (options.view != "light" && outputKind(options.out) == OutputKind::kFilm) {
        fmt::print(stderr, "hazer: --view {} is a picture; give --out a name that ends in .png or .exr\n",
                   options.view);
        return kExitUsage;
    }
    Show show = loadShow(options.show);
    // A film needs a length; a still has none.
    if (outputKind(options.out) == OutputKind::kFilm && options.seconds == 0.0) options.seconds = 10.0;
    const render::gl::HeadlessContext context;
    Session session(std::move(show), sessionOptionsFrom(options));
    applySettings(options, session);
    listenFor(options.listenS);
    session.advance(0.0);
    if (options.listenS > 0.0) warnIfNothingArrived(session);
    session.settle();
    renderAsAsked(session, options);
    return kExitOk;
}

void addPictureOptions(CLI::App& command, RenderOptions& options) {
    command.add_option("--out", options.out, "File: .png, .exr (cd/m2) or .mp4; hazer.png unless given")
        ->check(checkOut);
    addSizeOption(command, options.size);
    command.add_option("--camera", options.camera, "Name of a camera of the show; its first unless given");
    command.add_option("--ev", options.ev100, "Exposure as EV100, -20..40; the show's unless given")
        ->check(numberFrom(-20.0, 40.0));
    addIntegratorOption(command, options.integrator);
    command
        .add_option("--samples", options.samples, "Samples of the integrator, 1..16384; its own unless given")
        ->check(CLI::Range(1, 16384));
    addMaxErrorOption(command, options.maxError);
    command
        .add_option(
            "--view", options.view,
            "light; or error, how far each pixel is from a converged picture; or cost, how many beams "
            "were integrated for it")
        ->check(CLI::IsMember({"light", "error", "cost"}));
    command.add_flag("--no-bloom", options.hasNoBloom, "Without the glow around bright light");
}

void addTimeOptions(CLI::App& command, RenderOptions& options) {
    command.add_option("--time", options.timeS, "Seconds since the start, for the haze that moves")
        ->check(numberFrom(0.0, 1e6));
    command
        .add_option("--seconds", options.seconds, "Length of a film (10 unless given) or of numbered frames")
        ->check(numberFrom(0.001, 86400.0));
    command.add_option("--fps", options.framesPerS, "Frames a second, 1..240; 25 unless given")
        ->check(numberFrom(1.0, 240.0));
}

void addInputOptions(CLI::App& command, RenderOptions& options) {
    command
        .add_option(
            "--set", options.assignments,
            "Hold an attribute, FIXTURE.Attribute=VALUE (deg, Hz, 0..1, slot of a wheel); may be repeated")
        ->check(checkAssignment);
    command.add_option("--listen", options.listenS, "Listen so many seconds, then draw what stands")
        ->check(numberFrom(0.001, 86400.0));
    command.add_option(
        "--replay", options.replay,
        "A recording that plays in place of those of the show: pcap, pcapng, OLA show file, FSEQ");
    addMomentOption(command, "--from", options.replayFrom, "Where the recording begins; 0 unless given");
    addFrameMapOptions(command, options.replayMap, protocol::Transport::kArtNet, true);
    addPortOptions(command, options.ports);
}

}  // namespace

void addRenderCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        program.add_subcommand("render", "Draw a picture or a film of a show, without a window.");
    beginHelpWith(
        *command,
        "  hazer render myshow.toml                                        writes hazer.png\n"
        "  hazer render myshow.toml --set spot1.Dimmer=1 --set spot1.Tilt=30 --out look.exr\n"
        "  hazer render rig.mvr --set '*.Dimmer=1' --out rig.png           a rig with every lamp lit\n"
        "  hazer render myshow.toml --listen 2 --out now.png               what the desk sends now\n"
        "  hazer render myshow.toml --seconds 4 --out haze.mp4             a film\n"
        "  hazer render myshow.toml --replay night.pcap --from 1:20        what stood then\n"
        "  hazer render myshow.toml --seconds 4 --out frames/haze_%04d.png numbered frames\n");
    command->add_option("SHOW", options->show, "The show file (.toml) or rig (.mvr)")->required();
    addPictureOptions(*command, *options);
    addInputOptions(*command, *options);
    addTimeOptions(*command, *options);
    command->callback([options, &chosen] { chosen = [options] { return runRender(*options); }; });
}

}  // namespace hazer::app
