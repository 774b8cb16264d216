// Tables of gobos on the GPU: where they are put, and that shaders see what the formulas in C++ see.
#include "render/gobo_store.h"

#include <epoxy/gl.h>

#include <chrono>
#include <span>
#include <thread>

#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/gobo_table_formulas.h"
#include "tests/render/gobo_pictures.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

using render::GoboStore;
using render::GoboTableKey;
using render::GoboTableSlot;

/// A gobo of one colour, open where x > 0.
std::vector<std::uint8_t> halfGobo(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    constexpr int kSize = 64;
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < kSize * kSize; ++i) {
        const bool open = i % kSize >= kSize / 2;
        for (const std::uint8_t value : {red, green, blue}) rgba.push_back(open ? value : 0);
        rgba.push_back(255);
    }
    return rgba;
}

class GoboStoreGl : public GlTest {
 protected:
    render::GoboId add(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
        return store_.add(halfGobo(red, green, blue).data(), 64, 64);
    }

    std::vector<GoboTableSlot> tables(const std::vector<GoboTableKey>& keys, bool waits = true) {
        return store_.tables(keys, waits);
    }

    /// What lies in the texture's layers.
    std::vector<std::uint16_t> layersOnGpu(const GoboTableSlot& slot) const {
        glBindTexture(GL_TEXTURE_2D_ARRAY, store_.tableTexture());
        GLint layers = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_DEPTH, &layers);
        std::vector<std::uint16_t> all(render::kGoboTableLayerHalves * static_cast<std::size_t>(layers));
        glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA, GL_HALF_FLOAT, all.data());
        const auto first =
            all.begin() + static_cast<std::ptrdiff_t>(render::kGoboTableLayerHalves) * slot.firstLayer;
        return {first, first + static_cast<std::ptrdiff_t>(render::kGoboTableLayerHalves) * slot.layers};
    }

    std::vector<std::uint16_t> expectedLayers(const std::vector<std::uint8_t>& rgba,
                                              const GoboTableKey& key) const {
        return render::buildGoboTable(render::makeGoboPicture(rgba.data(), 64, 64), key.profile).halves;
    }

    GoboStore store_;
};

TEST_F(GoboStoreGl, TablesLieInTheirSlots) {
    const GoboTableKey grey{add(255, 255, 255), {}};
    const GoboTableKey red{add(255, 0, 0), {0.75, 4.0}};
    const auto slots = tables({{}, grey, red, grey});
    EXPECT_EQ(slots[0], GoboTableSlot{});
    EXPECT_EQ(slots[1], (GoboTableSlot{0, 1}));
    EXPECT_EQ(slots[2], (GoboTableSlot{1, 3}));
    EXPECT_EQ(slots[3], slots[1]);
    EXPECT_EQ(layersOnGpu(slots[1]), expectedLayers(halfGobo(255, 255, 255), grey));
    EXPECT_EQ(layersOnGpu(slots[2]), expectedLayers(halfGobo(255, 0, 0), red));
}

TEST_F(GoboStoreGl, TablesStayWhereMoreCome) {
    const GoboTableKey first{add(255, 255, 255), {}};
    const auto before = tables({first});
    const GoboTableKey second{add(128, 128, 128), {}};
    const GoboTableKey third{add(0, 255, 255), {}};
    const auto slots = tables({third, second, first});
    EXPECT_EQ(slots[2], before[0]);
    EXPECT_EQ(layersOnGpu(slots[2]), expectedLayers(halfGobo(255, 255, 255), first));
    EXPECT_EQ(layersOnGpu(slots[0]), expectedLayers(halfGobo(0, 255, 255), third));
    EXPECT_EQ(layersOnGpu(slots[1]), expectedLayers(halfGobo(128, 128, 128), second));
}

TEST_F(GoboStoreGl, WhoDoesNotWaitGetsTablesLater) {
    const GoboTableKey key{add(255, 255, 255), {}};
    EXPECT_EQ(tables({key}, false)[0], GoboTableSlot{});
    const auto giveUp = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (tables({key}, false)[0] == GoboTableSlot{}) {
        ASSERT_LT(std::chrono::steady_clock::now(), giveUp);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const auto slots = tables({key}, false);
    EXPECT_EQ(slots[0], (GoboTableSlot{0, 1}));
    EXPECT_EQ(layersOnGpu(slots[0]), expectedLayers(halfGobo(255, 255, 255), key));
}

TEST_F(GoboStoreGl, NoTableIsBuiltBeforeOneIsAskedFor) {
    add(255, 255, 255);
    tables({{}, {}});
    EXPECT_EQ(store_.tableTexture(), 0u);
    render::Resources resources;
    store_.list(resources);
    EXPECT_TRUE(resources.textures.empty());
}

TEST_F(GoboStoreGl, AFrameThatWantsMoreThanThereIsRoomForGoesWithout) {
    GoboStore small(5);
    const std::vector<std::uint8_t> rgba = halfGobo(255, 0, 0);
    const render::GoboId gobo = small.add(rgba.data(), 64, 64);
    const std::vector<GoboTableKey> keys{{gobo, {0.5, 3.0}}, {gobo, {0.6, 3.0}}};
    const std::vector<GoboTableSlot> expected{{0, 3}, {}};
    EXPECT_EQ(small.tables(keys, true), expected);
    // In the next frame the other one may have the room.
    EXPECT_EQ(small.tables(std::span(keys).subspan(1), true)[0], (GoboTableSlot{0, 3}));
}

TEST_F(GoboStoreGl, ShadersSeeWhatTheFormulasSee) {
    const std::vector<std::uint8_t> letter = letterGobo().levels[0];
    const GoboTableKey key{store_.add(letter.data(), render::kGoboSize, render::kGoboSize), {0.8, 5.4}};
    const auto slots = tables({{add(255, 0, 0), {}}, key});
    const render::GoboTable table = render::buildGoboTable(
        render::makeGoboPicture(letter.data(), render::kGoboSize, render::kGoboSize), key.profile);
    render::glsl::GoboTableFormulas<float> formulas{&table};
    const render::gl::Program program(shaderFolder(), "fullscreen.vert",
                                      "../tests/render/gobo_table_probe.frag");
    constexpr int kSize = 96;
    const render::gl::Texture target = render::gl::makeTexture2d(GL_RGBA32F, kSize, kSize, GL_NEAREST);
    const render::gl::Framebuffer framebuffer = render::gl::makeFramebufferFor({target.id()});
    const render::gl::VertexArray corners = render::gl::makeVertexArray();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glBindVertexArray(corners.id());
    glViewport(0, 0, kSize, kSize);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    program.use();
    program.set("viewportPx", glm::vec2(kSize));
    program.set("layer", static_cast<float>(slots[1].firstLayer));
    program.set("goboTables", 0);
    render::gl::bindTexture(0, GL_TEXTURE_2D_ARRAY, store_.tableTexture());
    for (int level = 0; level < formulas.GOBO_TABLE_LEVELS; ++level) {
        program.set("level", level);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<glm::vec4> drawn(std::size_t{kSize} * kSize);
        glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_FLOAT, drawn.data());
        for (int i = 0; i < kSize * kSize; ++i) {
            const float turn = (static_cast<float>(i % kSize) + 0.5f) / kSize;
            const float distance = (static_cast<float>(i / kSize) + 0.5f) / kSize;
            const glm::vec4 expected = formulas.goboMoments({turn, distance, {}, 0.0f}, 0.0f, level);
            for (int k = 0; k < 4; ++k) {
                // Texture units blend in steps of 1/256.
                ASSERT_NEAR(drawn[static_cast<std::size_t>(i)][k], expected[k], 4e-3f)
                    << "level " << level << ", turn " << turn << ", distance " << distance;
            }
        }
    }
}

}  // namespace
}  // namespace hazer::test
