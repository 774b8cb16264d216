// The frame as a list of passes.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "render/asset_sink.h"
#include "render/ies_web.h"
#include "render/image.h"
#include "render/mesh.h"
#include "render/resources.h"
#include "render/scene.h"

namespace hazer::render {

/// Milliseconds of one pass, by the GPU's clock where it has one.
struct PassTime {
    std::string name;
    double milliseconds = 0.0;
};

/// Draws scenes with the current OpenGL context, which must be 4.1 core or later and stay current. Owns all
/// its GL names. Throws RenderError if a shader is missing or does not compile, NoGlError if the context is
/// too old.
class Renderer : public AssetSink {
 public:
    explicit Renderer(std::filesystem::path shaderFolder);
    ~Renderer() override;
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    MeshId addMesh(const Mesh& mesh) override;
    GoboId addGobo(const std::uint8_t* rgba, int width, int height) override;
    WebId addWeb(const IesWeb& web) override;

    /// Draws a frame into the renderer's own targets.
    void render(const Scene& scene, const Camera& camera, const Settings& settings);

    /// Scene radiance of the last frame: cd/m^2, before bloom and tone mapping.
    FloatImage readRadiance() const;

    /// The last frame with bloom, exposure and tone mapping.
    ByteImage readDisplay();

    /// Shows the last frame in a framebuffer of the context (0: the window) of the given size.
    void present(unsigned framebuffer, int width, int height);

    /// How long each pass of a recent frame took; empty until a frame's timers have come back.
    std::vector<PassTime> passTimes() const;

    /// The same of the last frame; waits until it has been drawn.
    std::vector<PassTime> lastPassTimes() const;

    /// Everything that exists on the GPU for this renderer at the moment.
    Resources resources() const;

    /// A mesh and a web as they were added, and what a gobo lets through (kGoboSize^2 RGBA bytes, linear, row
    /// 0 on top): for whoever checks the pictures.
    Mesh readMesh(MeshId mesh) const;
    const IesWeb& readWeb(WebId web) const;
    const std::vector<std::uint8_t>& readGobo(GoboId gobo) const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::render
