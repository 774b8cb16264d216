// What the window remembers from frame to frame.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "app/orbit_camera.h"
#include "app/session.h"
#include "app/window_frame_times.h"
#include "app/window_held_faders.h"
#include "app/window_resolution.h"
#include "app/window_stage.h"

namespace hazer::app {

struct WindowState {
    explicit WindowState(Session& session)
        : camera(session.camera()),
          held(session.show()),
          stage(ballAroundStage(session.show())),
          controlsOfShow(session.controls()) {}

    OrbitCamera camera;
    HeldFaders held;
    WindowResolution resolution;
    WindowFrameTimes frameTimes;
    Ball stage;
    SceneControls controlsOfShow;          ///< As the show file has them, to go back to.
    std::size_t selected = 0;              ///< Index of a fixture in the patch, if it has any.
    std::map<std::string, int> lastGobos;  ///< By fixture/attribute: the slot that "gobo" switches back on.
    bool showsPanels = true;
    bool showsHelp = false;
};

}  // namespace hazer::app
