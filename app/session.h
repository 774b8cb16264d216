// A running show: what arrives on the network becomes light, frame by frame.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/inputs.h"
#include "app/patch.h"
#include "app/playback.h"
#include "app/room_haze.h"
#include "app/show.h"
#include "app/staging.h"
#include "protocol/universe_merger.h"
#include "render/renderer.h"

namespace hazer::app {

struct SessionOptions {
    bool listen = false;  ///< Open the show's inputs (see Inputs::listen for a show without any).
    InputPorts ports{};   ///< Replace those of the show's inputs.
    bool plays = true;    ///< Play the show's recordings.
    bool scrubs = false;  ///< Prepare recordings for going anywhere in a moment.
    std::optional<ShowRecording> replay{};  ///< Plays in place of the show's recordings.
};

/// How long the parts of the last frame took on the CPU.
struct FrameTimes {
    double advanceMs = 0.0;  ///< Latch, decode, mechanics.
    double drawMs = 0.0;     ///< Rig, scene, and handing the passes to OpenGL.
};

/// Owns everything of a show that runs. Needs a current OpenGL 4.1 context for its whole life. Throws
/// ShowError, fixtures::ParseError, render::RenderError or protocol::NetworkError when it cannot start.
class Session {
 public:
    Session(Show show, const SessionOptions& options);

    const Show& show() const { return show_; }
    Patch& patch() { return patch_; }
    const Patch& patch() const { return patch_; }
    SceneControls& controls() { return controls_; }
    render::Camera& camera() { return camera_; }
    render::Settings& settings() { return settings_; }
    render::Renderer& renderer() { return renderer_; }

    /// Takes what has arrived as one consistent set, decodes it and lets the mechanics move for `dtS` >= 0
    /// seconds.
    void advance(double dtS);

    /// Puts all mechanics where they want to go, as if a long time had passed.
    void settle();

    /// Draws the show as it stands, with camera(), controls() and settings(), into the renderer's own
    /// targets.
    void draw();

    /// What draw() draws. The haze is that of controls() and what the show's machines have added to it.
    render::Scene scene();

    double timeS() const { return timeS_; }         ///< Since the start; moves the noise in the haze.
    void setTime(double timeS) { timeS_ = timeS; }  ///< Jumps; mechanics stay where they are.
    const FrameTimes& frameTimes() const { return frameTimes_; }

    /// What had arrived when the last frame took its universes.
    const protocol::UniverseSet& universes() const { return latched_; }

    /// What all receivers of Art-Net together have seen; zeros if nothing listens.
    protocol::ReceiverCounters counters() const { return inputs_.artNet().counters; }

    /// Who sends, and all else there is to know about what arrives.
    Inputs& inputs() { return inputs_; }
    const Inputs& inputs() const { return inputs_; }

    /// The UDP port really bound for Art-Net; 0 if nothing listens to it.
    std::uint16_t port() const { return inputs_.port(); }

    /// The recordings that play.
    const std::vector<std::unique_ptr<Playback>>& playbacks() const { return playbacks_; }

 private:
    void play(const SessionOptions& options);

    Show show_;
    Patch patch_;
    render::Renderer renderer_;
    Staging staging_;
    SceneControls controls_;
    RoomHaze roomHaze_;
    render::Camera camera_;
    render::Settings settings_;
    Inputs inputs_;
    protocol::UniverseSet latched_;
    std::vector<std::unique_ptr<Playback>> playbacks_;
    FrameTimes frameTimes_;
    double timeS_ = 0.0;
};

}  // namespace hazer::app
