#include "app/session.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <utility>

#include "app/paths.h"

namespace hazer::app {
namespace {

double millisecondsSince(protocol::TimePoint start) {
    return std::chrono::duration<double, std::milli>(protocol::Clock::now() - start).count();
}

render::Settings settingsOf(const Show& show) {
    render::Settings settings;
    settings.exposureEv100 = show.exposureEv100;
    return settings;
}

}  // namespace

Session::Session(Show show, const SessionOptions& options)
    : show_(std::move(show)),
      patch_(show_),
      renderer_(shaderFolder()),
      staging_(show_, renderer_),
      controls_(controlsOf(show_)),
      camera_(show_.cameras.front().camera),
      settings_(settingsOf(show_)),
      inputs_(show_) {
    warnAboutRig(show_, staging_);
    for (const std::string& warning : patch_.fileWarnings())
        spdlog::warn("{}: {}", show_.file.string(), warning);
    for (const std::string& overlap : patch_.overlaps()) spdlog::warn("{}: {}", show_.file.string(), overlap);
    patch_.settle();
    play(options);
    if (options.listen) inputs_.listen({.ports = options.ports});
}

void Session::play(const SessionOptions& options) {
    std::vector<ShowRecording> recordings;
    if (options.replay) {
        recordings.push_back(*options.replay);
    } else if (options.plays) {
        recordings = show_.recordings;
    }
    for (const ShowRecording& recording : recordings) {
        playbacks_.push_back(std::make_unique<Playback>(recording, patch_.universes(), options.scrubs));
    }
}

void Session::advance(double dtS) {
    const protocol::TimePoint start = protocol::Clock::now();
    inputs_.latch(latched_, start);
    for (const auto& playback : playbacks_) {
        // Where nothing listens, as for a film, no time code can come: the recording plays by itself.
        if (playback->followsTimeCode && inputs_.hearsTimeCode()) {
            playback->follow(inputs_.artNet().timeCode, start);
        } else {
            playback->advance(dtS);
        }
        playback->mergeInto(latched_, start);
    }
    patch_.decode(latched_);
    patch_.step(dtS);
    roomHaze_.step(supplyOf(patch_), dtS);
    timeS_ += dtS;
    frameTimes_.advanceMs = millisecondsSince(start);
}

void Session::settle() {
    patch_.settle();
    roomHaze_.settle(supplyOf(patch_));
}

void Session::draw() {
    const protocol::TimePoint start = protocol::Clock::now();
    renderer_.render(scene(), camera_, settings_);
    frameTimes_.drawMs = millisecondsSince(start);
}

render::Scene Session::scene() {
    SceneControls controls = controls_;
    roomHaze_.addTo(controls.haze);
    return staging_.scene(patch_, controls, timeS_);
}

}  // namespace hazer::app
