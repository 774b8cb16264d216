#include "app/report/speed_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/demo_programme.h"
#include "app/paths.h"
#include "protocol/dmx.h"
#include "render/gl/headless_context.h"

namespace hazer::app {
namespace {

constexpr double kFrameS = 1.0 / 25.0;

void playDemo(Session& session, double timeS) {
    for (PatchedFixture& patched : session.patch().fixtures()) {
        protocol::Slots slots{};
        writeDemoLook(patched.fixture, timeS, slots);
        patched.fixture.decode(slots);
    }
}

bool isDemo(const Show& show) {
    std::error_code missing;
    return std::filesystem::equivalent(show.file, showFolder() / "demo.toml", missing) && !missing;
}

}  // namespace

SpeedReport measureSpeed(Session& session, int frames) {
    const bool playsDemo = isDemo(session.show());
    const double startS = session.timeS();
    SpeedReport report;
    report.device = render::gl::describeContext();
    report.show = session.show().file.filename().string();
    report.width = session.settings().width;
    report.height = session.settings().height;
    report.frames = frames;
    report.medians = measureFrames(session, frames, [&](int frame) {
        const double timeS = startS + frame * kFrameS;
        if (playsDemo) playDemo(session, timeS);
        session.settle();
        // What turns without end, such as a gobo, turns on.
        session.patch().step(kFrameS);
        session.setTime(timeS);
    });
    return report;
}

nlohmann::ordered_json speedJson(const SpeedReport& report) {
    nlohmann::ordered_json json{{"device", report.device},
                                {"show", report.show},
                                {"size", {report.width, report.height}},
                                {"frames", report.frames},
                                {"fps", 1000.0 / report.medians.frameMs},
                                {"frame_ms_median", report.medians.frameMs},
                                {"cpu_ms_median", report.medians.cpuMs},
                                {"passes", nlohmann::ordered_json::array()}};
    for (const PassMedian& pass : report.medians.passes) {
        json["passes"].push_back({{"name", pass.name}, {"ms_median", pass.ms}});
    }
    return json;
}

std::string speedMarkdown(const SpeedReport& report) {
    std::string text = fmt::format(
        "# Speed of {}\n\n{}, {} x {} pixels, median of {} frames.\n\n"
        "| pass | ms |\n|---|---|\n",
        report.show, report.device, report.width, report.height, report.frames);
    for (const PassMedian& pass : report.medians.passes) {
        text += fmt::format("| {} | {:.2f} |\n", pass.name, pass.ms);
    }
    text += fmt::format("| whole frame, with reading it back | {:.2f} |\n", report.medians.frameMs);
    text += fmt::format("\n{:.1f} frames a second; {:.1f} ms of CPU time a frame, all threads together.\n",
                        1000.0 / report.medians.frameMs, report.medians.cpuMs);
    return text;
}

}  // namespace hazer::app
