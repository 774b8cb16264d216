#include "render/renderer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/error.h"
#include "render/gl/debug_output.h"
#include "render/gl/inventory.h"
#include "render/gl/pass_timer.h"
#include "render/gl/texture.h"
#include "render/gobo_store.h"
#include "render/gobo_table_plan.h"
#include "render/mesh_store.h"
#include "render/passes/air_grid.h"
#include "render/passes/antialias_pass.h"
#include "render/passes/aperture_pass.h"
#include "render/passes/bloom_pass.h"
#include "render/passes/display_grid.h"
#include "render/passes/lens_pass.h"
#include "render/passes/lit_surface_pass.h"
#include "render/passes/shadow_pass.h"
#include "render/passes/surface_pass.h"
#include "render/passes/tone_map_pass.h"
#include "render/scene_plan.h"
#include "render/still_surfaces.h"
#include "render/web_store.h"

namespace hazer::render {
namespace {

void requireGl41() {
    if (epoxy_gl_version() < 41) {
        throw NoGlError(
            fmt::format("hazer needs OpenGL 4.1, this context has {}.{}; update the graphics driver",
                        epoxy_gl_version() / 10, epoxy_gl_version() % 10));
    }
}

/// Linear Rec. 709 from linear Rec. 2020 (ITU-R BT.2087).
glm::vec3 rec709FromRec2020(const glm::vec3& c) {
    return {1.660491f * c.r - 0.587641f * c.g - 0.072850f * c.b,
            -0.124550f * c.r + 1.132900f * c.g - 0.008349f * c.b,
            -0.018151f * c.r - 0.100579f * c.g + 1.118730f * c.b};
}

/// Row y of a picture that GL hands over from the bottom up.
std::size_t flippedRow(int y, int height, int width) {
    return 3 * static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width);
}

std::vector<PassTime> named(const std::vector<std::pair<std::string, double>>& passes) {
    std::vector<PassTime> times;
    for (const auto& [name, milliseconds] : passes) times.push_back({name, milliseconds});
    return times;
}

}  // namespace

struct Renderer::Impl {
    explicit Impl(const std::filesystem::path& shaderFolder)
        : apertures(shaderFolder),
          surfaces(shaderFolder),
          shadows(shaderFolder),
          air(shaderFolder),
          airGrid(shaderFolder),
          litSurfaces(shaderFolder),
          lenses(shaderFolder),
          bloom(shaderFolder),
          grid(shaderFolder),
          toneMap(shaderFolder),
          antialias(shaderFolder) {}

    void resize(int newWidth, int newHeight);
    void makeBodyTargets(bool forBodies);
    void drawBackground(const Scene& scene);
    void drawSurfaces(const Scene& scene, const Camera& camera, const ScenePlan& plan);
    void drawLitSurfaces(const LightInputs& in);
    void drawAir(const LightInputs& in);
    void drawCost(const LightInputs& in);
    void drawToneMap();
    void drawAntialias();

    template <typename Draw>
    void pass(const char* name, Draw draw) {
        const gl::DebugGroup group(name);
        timer.begin(name);
        draw();
        timer.end();
    }

    MeshStore meshes;
    GoboStore gobos;
    WebStore webs;
    AperturePass apertures;
    SurfacePass surfaces;
    ShadowPass shadows;
    AirPass air;
    AirGrid airGrid;
    LitSurfacePass litSurfaces;
    StillSurfaces stillSurfaces;
    LensPass lenses;
    BloomPass bloom;
    DisplayGrid grid;
    ToneMapPass toneMap;
    AntialiasPass antialias;
    gl::PassTimer timer;
    gl::Texture radiance;
    gl::Framebuffer radianceTarget;
    gl::Texture toneMapped;
    gl::Framebuffer toneMapTarget;
    gl::Texture display;
    gl::Framebuffer displayTarget;
    int width = 0;
    int height = 0;
    float exposure = 0.0f;   ///< Radiance to sensor full scale.
    bool hasBodies = false;  ///< What there are targets for.
    bool hasBloom = false;
};

void Renderer::Impl::resize(int newWidth, int newHeight) {
    if (newWidth == width && newHeight == height) return;
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (newWidth < 1 || newHeight < 1 || newWidth > limit || newHeight > limit) {
        throw RenderError(
            fmt::format("A picture of {}x{} cannot be drawn; this graphics driver goes up to {}x{}", newWidth,
                        newHeight, limit, limit));
    }
    width = newWidth;
    height = newHeight;
    grid.resize(width, height);
    bloom.resize(grid.blocks());
    // 32-bit floats: a lens is ten million times brighter than the haze, and hundreds of beams are added up.
    radiance = gl::makeTexture2d(GL_RGBA32F, width, height, GL_LINEAR);
    radianceTarget = {};
    toneMapped = gl::makeTexture2d(GL_RGBA8, width, height, GL_LINEAR);
    display = gl::makeTexture2d(GL_RGBA8, width, height, GL_LINEAR);
    toneMapTarget = gl::makeFramebufferFor({toneMapped.id(), display.id()}, grid.mask());
    displayTarget = gl::makeFramebufferFor({display.id()}, grid.mask());
}

/// The radiance itself stays when bodies come and go.
void Renderer::Impl::makeBodyTargets(bool forBodies) {
    if (radianceTarget.id() != 0 && forBodies == hasBodies) return;
    hasBodies = forBodies;
    surfaces.resize(width, height, radiance.id(), hasBodies);
    radianceTarget = gl::makeFramebufferFor({radiance.id()}, surfaces.depth());
}

void Renderer::Impl::drawBackground(const Scene& scene) {
    const glm::vec4 background(scene.backgroundCdPerM2, 1.0f);
    glClearBufferfv(GL_COLOR, 0, &background[0]);
}

void Renderer::Impl::drawSurfaces(const Scene& scene, const Camera& camera, const ScenePlan& plan) {
    if (stillSurfaces.isKept()) {
        stillSurfaces.restore(radianceTarget.id());
    } else {
        surfaces.draw(scene, plan.haze.extinctionPerM, camera, meshes);
    }
}

void Renderer::Impl::drawLitSurfaces(const LightInputs& in) {
    if (stillSurfaces.isKept()) return;
    litSurfaces.draw(in);
    stillSurfaces.keep(radianceTarget.id());
}

void Renderer::Impl::drawAir(const LightInputs& in) {
    const int step = in.plan.airStep;
    if (step > 1) {
        airGrid.draw(air, in, radiance.id(), step);
        glBindFramebuffer(GL_FRAMEBUFFER, radianceTarget.id());
    } else {
        air.draw(in, in.plan.airGroups);
    }
}

void Renderer::Impl::drawCost(const LightInputs& in) {
    static constexpr std::array<float, 4> kNothing{};
    glClearBufferfv(GL_COLOR, 0, kNothing.data());
    const int step = in.plan.airStep;
    if (step > 1) {
        airGrid.count(air, in, step);
        glBindFramebuffer(GL_FRAMEBUFFER, radianceTarget.id());
    } else {
        air.count(in, in.plan.airGroups, 1.0f);
    }
}

void Renderer::Impl::drawToneMap() {
    glBindFramebuffer(GL_FRAMEBUFFER, toneMapTarget.id());
    glViewport(0, 0, width, height);
    grid.drawBetween();
    DisplayGrid::onlyExact();
    toneMap.draw(radiance.id(), grid, hasBloom, exposure);
    DisplayGrid::everywhere();
}

void Renderer::Impl::drawAntialias() {
    glBindFramebuffer(GL_FRAMEBUFFER, displayTarget.id());
    DisplayGrid::onlyEdges();
    antialias.draw(toneMapped.id());
    DisplayGrid::everywhere();
}

Renderer::Renderer(std::filesystem::path shaderFolder) {
    requireGl41();
    gl::enableDebugOutput();
    impl_ = std::make_unique<Impl>(shaderFolder);
}

Renderer::~Renderer() = default;

MeshId Renderer::addMesh(const Mesh& mesh) {
    return impl_->meshes.add(mesh);
}

GoboId Renderer::addGobo(const std::uint8_t* rgba, int width, int height) {
    return impl_->gobos.add(rgba, width, height);
}

WebId Renderer::addWeb(const IesWeb& web) {
    return impl_->webs.add(web);
}

void Renderer::render(const Scene& scene, const Camera& camera, const Settings& settings) {
    Impl& r = *impl_;
    r.resize(settings.width, settings.height);
    r.exposure = 1.0f / (1.2f * std::exp2(settings.exposureEv100));
    const ScenePlan plan = planScene(scene, camera, settings, r.meshes.bounds(), r.webs.webs());
    r.hasBloom = plan.bloom;
    r.makeBodyTargets(plan.surfaces);
    r.timer.beginFrame();

    std::vector<int> composedLayers;
    if (!plan.apertures.composed.empty())
        r.pass("apertures", [&] { composedLayers = r.apertures.draw(plan.apertures.composed, r.gobos); });
    if (!plan.shadowMaps.empty()) r.pass("shadow maps", [&] { r.shadows.draw(scene, plan, r.meshes); });
    glViewport(0, 0, r.width, r.height);
    r.stillSurfaces.beginFrame(surfaceView(scene, camera, settings, plan));
    if (plan.surfaces) r.pass("surfaces", [&] { r.drawSurfaces(scene, camera, plan); });
    glBindFramebuffer(GL_FRAMEBUFFER, r.radianceTarget.id());
    if (!plan.surfaces) r.pass("background", [&] { r.drawBackground(scene); });
    const std::vector<GoboTableSlot> goboTables =
        r.gobos.tables(goboTableKeys(scene, settings, plan), settings.waitForTables);
    const std::vector<GpuBeam> beams = packBeams(scene, plan, camera, settings, composedLayers, goboTables);
    const LightInputs lights{scene,
                             camera,
                             settings,
                             plan,
                             r.surfaces,
                             beams,
                             usesFeature(plan, kFeatureGobo) ? r.gobos.texture() : 0,
                             r.gobos.tableTexture(),
                             r.shadows.textures(),
                             usesFeature(plan, kFeatureWeb) ? r.webs.texture() : 0};
    if (!plan.surfaceGroups.empty()) r.pass("lit surfaces", [&] { r.drawLitSurfaces(lights); });
    if (!plan.airGroups.empty()) r.pass("beams", [&] { r.drawAir(lights); });
    if (!plan.lenses.empty()) r.pass("lenses", [&] { r.lenses.draw(lights); });
    if (settings.countsIntegrals) r.pass("cost", [&] { r.drawCost(lights); });
    r.pass("block means", [&] { r.grid.measure(r.radiance.id(), r.exposure); });
    if (plan.bloom) r.pass("bloom", [&] { r.bloom.draw(r.grid.means()); });
    r.pass("display grid", [&] { r.grid.judge(plan.bloom ? &r.bloom : nullptr, r.exposure); });
    r.pass("tone map", [&] { r.drawToneMap(); });
    r.pass("antialias", [&] { r.drawAntialias(); });
}

FloatImage Renderer::readRadiance() const {
    const Impl& r = *impl_;
    FloatImage bottomUp{
        r.width, r.height,
        std::vector<float>(3 * static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height))};
    glBindFramebuffer(GL_FRAMEBUFFER, r.radianceTarget.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, r.width, r.height, GL_RGB, GL_FLOAT, bottomUp.rgb.data());
    FloatImage image = bottomUp;
    for (int y = 0; y < r.height; ++y) {
        const float* from = bottomUp.rgb.data() + flippedRow(y, r.height, r.width);
        float* to = image.rgb.data() + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(r.width);
        for (int x = 0; x < r.width; ++x, from += 3, to += 3) {
            const glm::vec3 color = rec709FromRec2020({from[0], from[1], from[2]});
            for (int c = 0; c < 3; ++c) to[c] = color[c];
        }
    }
    return image;
}

ByteImage Renderer::readDisplay() {
    const Impl& r = *impl_;
    const std::size_t row = 3 * static_cast<std::size_t>(r.width);
    ByteImage bottomUp{r.width, r.height,
                       std::vector<std::uint8_t>(row * static_cast<std::size_t>(r.height))};
    glBindFramebuffer(GL_FRAMEBUFFER, r.displayTarget.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, r.width, r.height, GL_RGB, GL_UNSIGNED_BYTE, bottomUp.rgb.data());
    ByteImage image = bottomUp;
    for (int y = 0; y < r.height; ++y) {
        std::copy_n(bottomUp.rgb.data() + flippedRow(y, r.height, r.width), row,
                    image.rgb.data() + static_cast<std::size_t>(y) * row);
    }
    return image;
}

void Renderer::present(unsigned framebuffer, int width, int height) {
    const Impl& r = *impl_;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, r.displayTarget.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, r.width, r.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

std::vector<PassTime> Renderer::passTimes() const {
    return named(impl_->timer.latest());
}

std::vector<PassTime> Renderer::lastPassTimes() const {
    return named(impl_->timer.last());
}

Resources Renderer::resources() const {
    const Impl& r = *impl_;
    Resources all;
    gl::listTexture(all, "radiance", GL_TEXTURE_2D, r.radiance);
    gl::listTexture(all, "tone mapped", GL_TEXTURE_2D, r.toneMapped);
    gl::listTexture(all, "display", GL_TEXTURE_2D, r.display);
    r.meshes.list(all);
    r.gobos.list(all);
    r.webs.list(all);
    r.apertures.list(all);
    r.surfaces.list(all);
    r.shadows.list(all);
    r.air.list(all);
    r.airGrid.list(all);
    r.litSurfaces.list(all);
    r.stillSurfaces.list(all);
    r.lenses.list(all);
    r.bloom.list(all);
    r.grid.list(all);
    r.toneMap.list(all);
    r.antialias.list(all);
    return all;
}

Mesh Renderer::readMesh(MeshId mesh) const {
    return impl_->meshes.read(mesh);
}

const IesWeb& Renderer::readWeb(WebId web) const {
    return impl_->webs.webs()[static_cast<std::size_t>(web)];
}

const std::vector<std::uint8_t>& Renderer::readGobo(GoboId gobo) const {
    return impl_->gobos.texels(gobo);
}

}  // namespace hazer::render
