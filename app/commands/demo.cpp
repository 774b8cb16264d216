// hazer demo: the show that comes with hazer, sent to itself over loopback Art-Net.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <thread>

#include "app/commands/command.h"
#include "app/demo_player.h"
#include "app/demo_programme.h"
#include "app/display.h"
#include "app/film.h"
#include "app/interrupt.h"
#include "app/paths.h"
#include "app/picture_file.h"
#include "app/progress.h"
#include "app/session.h"
#include "protocol/network_error.h"
#include "render/gl/headless_context.h"

namespace hazer::app {
namespace {

struct DemoOptions {
    bool isHeadless = false;
    std::string folder = "out";
};

constexpr double kFilmS = 10.0;
constexpr FilmFormat kFilmFormat{640, 360, 25.0};
constexpr int kPictureWidth = 1280;
constexpr int kPictureHeight = 720;

Show demoShow() {
    return loadShow(showFolder() / "demo.toml");
}

/// Plays at the rate of a desk, in real time, while a window shows it. If the network fails it says so and
/// falls silent, as a desk does whose cable is pulled.
class BackgroundPlayer {
 public:
    BackgroundPlayer(const Show& show, std::uint16_t port) : patch_(show), player_(patch_, port) {
        thread_ = std::jthread([this](const std::stop_token& stop) { playUntilItFails(stop); });
    }

 private:
    void playUntilItFails(const std::stop_token& stop) {
        try {
            play(stop);
        } catch (const protocol::NetworkError& error) {
            spdlog::error("{}", error.what());
        }
    }

    void play(const std::stop_token& stop) {
        constexpr double kPacketsPerS = 44.0;  // what DMX512 itself reaches
        using Seconds = std::chrono::duration<double>;
        const protocol::TimePoint start = protocol::Clock::now();
        for (long index = 0; !stop.stop_requested(); ++index) {
            const double timeS = static_cast<double>(index) / kPacketsPerS;
            player_.send(timeS);
            std::this_thread::sleep_until(
                start + std::chrono::duration_cast<protocol::Clock::duration>(Seconds(timeS)));
        }
    }

    Patch patch_;
    DemoPlayer player_;
    std::jthread thread_;
};

int runInWindow() {
    std::optional<BackgroundPlayer> player;
    return showInWindow(demoShow(), {.listen = true, .ports = {.artNet = 0}},
                        [&](Session& session) { player.emplace(session.show(), session.port()); });
}

/// Waits until the receiver's thread has taken `count` packets more than `before`; for a bounded time, as UDP
/// may lose some.
void awaitPackets(const Session& session, std::uint64_t before, int count) {
    const protocol::TimePoint patience = protocol::Clock::now() + std::chrono::milliseconds(500);
    while (session.counters().dmx < before + static_cast<std::uint64_t>(count) &&
           protocol::Clock::now() < patience) {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
}

void playFrame(Session& session, DemoPlayer& player, double timeS) {
    const std::uint64_t before = session.counters().dmx;
    awaitPackets(session, before, player.send(timeS));
    session.advance(1.0 / kFilmFormat.framesPerS);
}

void setSize(Session& session, int width, int height) {
    session.settings().width = width;
    session.settings().height = height;
}

void drawPicture(Session& session, const std::filesystem::path& file) {
    setSize(session, kPictureWidth, kPictureHeight);
    session.draw();
    writePicture(session.renderer(), file);
    setSize(session, kFilmFormat.width, kFilmFormat.height);
}

/// Plays the programme from its start in time of its own. Draws the picture on the way, and every frame if
/// there is a film.
void playHeadless(Session& session, const std::filesystem::path& picture, Film* film) {
    DemoPlayer player(session.patch(), session.port());
    const int pictureFrame = static_cast<int>(std::lround(kStrikingMomentS * kFilmFormat.framesPerS));
    const int filmFrames = static_cast<int>(std::lround(kFilmS * kFilmFormat.framesPerS));
    const int frames = film == nullptr ? pictureFrame + 1 : std::max(pictureFrame + 1, filmFrames);
    Progress progress("playing frame", frames);
    const Interrupt interrupt;
    setSize(session, kFilmFormat.width, kFilmFormat.height);
    for (int frame = 0; frame < frames; ++frame) {
        interrupt.throwIfAsked();
        progress.show(frame + 1);
        playFrame(session, player, frame / kFilmFormat.framesPerS);
        if (frame == 0) session.settle();
        if (film != nullptr && frame < filmFrames) {
            session.draw();
            film->add(session.renderer().readDisplay());
        }
        if (frame == pictureFrame) drawPicture(session, picture);
    }
}

int runHeadless(const DemoOptions& options) {
    const std::filesystem::path folder = options.folder;
    const std::filesystem::path picture = folder / "demo.png";
    const std::filesystem::path filmFile = folder / "demo.mp4";
    makeFolder(folder);
    Show show = demoShow();
    const render::gl::HeadlessContext context;
    Session session(std::move(show), {.listen = true, .ports = {.artNet = 0}});
    std::optional<Film> film;
    if (canMakeFilms()) {
        film.emplace(filmFile, kFilmFormat);
    } else {
        fmt::print(stderr, "hazer: there is no ffmpeg on PATH, so there will be a picture but no film\n");
    }
    playHeadless(session, picture, film ? &*film : nullptr);
    fmt::print("{}\n", picture.string());
    if (!film) return kExitOk;
    film->finish();
    fmt::print("{}\n", filmFile.string());
    return kExitOk;
}

}  // namespace

void addDemoCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<DemoOptions>();
    CLI::App* command =
        program.add_subcommand("demo", "Play the show that comes with hazer to itself over Art-Net.");
    beginHelpWith(
        *command,
        "  hazer demo                        in a window if there is a display, else as files in ./out\n"
        "  hazer demo --headless --out /tmp  a picture and, if ffmpeg is there, a film of 10 s\n");
    command->add_flag("--headless", options->isHeadless, "Write files instead of opening a window");
    command->add_option("--out", options->folder, "Folder for the files; out unless given");
    command->callback([options, &chosen] {
        chosen = [options] {
            return options->isHeadless || !hasDisplay() ? runHeadless(*options) : runInWindow();
        };
    });
}

}  // namespace hazer::app
