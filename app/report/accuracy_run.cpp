#include "app/report/accuracy_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "app/report/oracle_check.h"

namespace hazer::app {
namespace {

constexpr int kMostFrames = 30;
constexpr double kLongFrameMs = 3000.0;
constexpr int kFramesOfOtherPasses = 8;

/// The passes that draw light in the air.
bool isAirPass(std::string_view name) {
    return name.find("beams") != std::string_view::npos || name.find("air") != std::string_view::npos;
}

/// Milliseconds of the last frame in the passes that `counts` chooses.
template <typename Counts>
double lastMs(const render::Renderer& renderer, Counts counts) {
    double sum = 0.0;
    for (const render::PassTime& pass : renderer.lastPassTimes()) {
        if (counts(pass.name)) sum += pass.milliseconds;
    }
    return sum;
}

void hideLenses(render::Scene& scene) {
    for (render::Beam& beam : scene.beams) beam.showsLens = false;
}

/// The same scene with light in the air alone: surfaces are black, lenses hidden. What the air is integrated
/// with stays.
render::Scene airAlone(render::Scene scene) {
    for (render::MeshInstance& instance : scene.instances) {
        instance.material.albedo = render::Color(0.0f);
        instance.material.specular = 0.0f;
    }
    hideLenses(scene);
    scene.ambient.illuminanceLx = 0.0f;
    scene.backgroundCdPerM2 = render::Color(0.0f);
    return scene;
}

/// Draws one scene with one setting after another.
class AccuracyRun {
 public:
    AccuracyRun(Session& session, const AccuracyOptions& options)
        : session_(session), options_(options), air_(airAlone(session.scene())) {}

    /// As many for the converged picture as there is time for.
    void chooseNodes(AccuracyScene& result);
    void drawReference();
    void measureOtherPasses();
    void measure(const IntegratorSetting& setting, AccuracyScene& result);
    void checkAir(AccuracyScene& result) const;
    void checkWhole(AccuracyScene& result) const;

 private:
    render::Settings sized(render::Settings settings) const;
    std::optional<OracleCheck> check(const render::FloatImage& picture, const render::Scene& scene,
                                     AccuracyScene& result) const;
    double draw(const render::Settings& settings);
    std::optional<double> expectedS(const IntegratorSetting& setting) const;

    Session& session_;
    const AccuracyOptions& options_;
    render::Scene air_;
    int nodes_ = 0;
    render::FloatImage reference_;
    double otherPassesMs_ = 0.0;
    IntegratorSetting previous_;
    double previousMs_ = 0.0;
};

render::Settings AccuracyRun::sized(render::Settings settings) const {
    settings.width = session_.settings().width;
    settings.height = session_.settings().height;
    settings.exposureEv100 = session_.settings().exposureEv100;
    return settings;
}

/// Draws the air alone; returns milliseconds of its passes.
double AccuracyRun::draw(const render::Settings& settings) {
    session_.renderer().render(air_, session_.camera(), sized(settings));
    return lastMs(session_.renderer(), isAirPass);
}

void AccuracyRun::chooseNodes(AccuracyScene& result) {
    constexpr int kNodes = 4096;
    constexpr int kTried = 128;
    draw(convergedSettings(kTried));  // compiles shaders
    const double triedS = 1e-3 * draw(convergedSettings(kTried));
    nodes_ = kNodes;
    while (nodes_ > kTried && triedS * nodes_ / kTried > options_.longestS) nodes_ /= 2;
    if (nodes_ == kNodes) return;
    result.notes.push_back(fmt::format(
        "The converged picture has {} nodes instead of {}, which would take too long.", nodes_, kNodes));
}

void AccuracyRun::drawReference() {
    draw(convergedSettings(nodes_));
    reference_ = session_.renderer().readRadiance();
    if (litPixels(reference_).empty()) {
        throw std::runtime_error(
            fmt::format("{}: no light is in the air of the picture; light a fixture with --set "
                        "NAME.Dimmer=1, or choose another camera",
                        session_.show().file.string()));
    }
}

void AccuracyRun::measureOtherPasses() {
    std::vector<double> ms;
    for (int frame = 0; frame < 1 + kFramesOfOtherPasses; ++frame) {
        session_.renderer().render(session_.scene(), session_.camera(), sized({}));
        const double others =
            lastMs(session_.renderer(), [](std::string_view name) { return !isAirPass(name); });
        if (frame > 0) ms.push_back(others);
    }
    otherPassesMs_ = median(ms);
}

/// How long a frame of more samples of the same will take; empty if nothing tells.
std::optional<double> AccuracyRun::expectedS(const IntegratorSetting& setting) const {
    if (setting.integrator != previous_.integrator || previous_.settings.samples == 0) return std::nullopt;
    return 1e-3 * previousMs_ * setting.settings.samples / previous_.settings.samples;
}

void AccuracyRun::measure(const IntegratorSetting& setting, AccuracyScene& result) {
    const std::optional<double> seconds = expectedS(setting);
    if (seconds && *seconds > options_.longestS) {
        result.notes.push_back(fmt::format("{}, {}: left out, since a frame would take about {:.0f} s.",
                                           setting.integrator, setting.setting, *seconds));
        return;
    }
    std::vector<double> ms{draw(setting.settings)};
    AccuracyRow row{setting.integrator,
                    setting.setting,
                    setting.settings.samples,
                    0,
                    0.0,
                    0.0,
                    pictureError(session_.renderer().readRadiance(), reference_)};
    // The first frame may have compiled shaders: it counts only where compiling would not be seen.
    if (ms.front() < kLongFrameMs) ms.front() = draw(setting.settings);
    double passedS = 1e-3 * ms.front();
    while (passedS + 1e-3 * ms.back() < options_.rowS && ms.size() < kMostFrames) {
        ms.push_back(draw(setting.settings));
        passedS += 1e-3 * ms.back();
    }
    row.frames = static_cast<int>(ms.size());
    row.msMedian = median(ms);
    row.frameMsMedian = row.msMedian + otherPassesMs_;
    previous_ = setting;
    previousMs_ = row.msMedian;
    result.rows.push_back(std::move(row));
}

std::optional<OracleCheck> AccuracyRun::check(const render::FloatImage& picture, const render::Scene& scene,
                                              AccuracyScene& result) const {
    const OracleResult oracle =
        checkAgainstOracle(picture, scene, session_.camera(), session_.renderer(), options_.oraclePixels);
    const auto& notes = result.notes;
    if (!oracle.check && std::find(notes.begin(), notes.end(), oracle.why) == notes.end()) {
        result.notes.push_back(oracle.why);
    }
    return oracle.check;
}

void AccuracyRun::checkAir(AccuracyScene& result) const {
    result.oracle = check(reference_, air_, result);
}

/// The show as it is, but for lenses, which the oracle does not know.
void AccuracyRun::checkWhole(AccuracyScene& result) const {
    render::Scene scene = session_.scene();
    if (std::any_of(scene.beams.begin(), scene.beams.end(),
                    [](const auto& beam) { return beam.gobo >= 0; })) {
        result.notes.push_back(
            "Surfaces are not held against the oracle, since it blurs a gobo that a surface is lit through "
            "in another way.");
        return;
    }
    hideLenses(scene);
    session_.renderer().render(scene, session_.camera(), sized(convergedSettings(nodes_)));
    result.wholeOracle = check(session_.renderer().readRadiance(), scene, result);
}

}  // namespace

AccuracyScene measureAccuracy(Session& session, const AccuracyOptions& options,
                              const std::function<void()>& step) {
    AccuracyScene result;
    result.title = session.show().title;
    AccuracyRun run(session, options);
    run.chooseNodes(result);
    run.drawReference();
    run.checkAir(result);
    run.checkWhole(result);
    run.measureOtherPasses();
    for (const IntegratorSetting& setting : options.settings) {
        step();
        run.measure(setting, result);
    }
    return result;
}

}  // namespace hazer::app
