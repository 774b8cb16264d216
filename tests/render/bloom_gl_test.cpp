// Bloom moves light, and makes or loses none.
#include <epoxy/gl.h>

#include <numeric>
#include <vector>

#include "render/gl/texture.h"
#include "render/passes/bloom_pass.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

constexpr glm::ivec2 kBlocks{96, 80};

class BloomGl : public GlTest {
 protected:
    /// The red channel of what is blurred from `blocks`.
    static std::vector<float> blurred(const std::vector<float>& blocks) {
        const render::gl::Texture source =
            render::gl::makeTexture2d(GL_RGBA32F, kBlocks.x, kBlocks.y, GL_LINEAR);
        glBindTexture(GL_TEXTURE_2D, source.id());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kBlocks.x, kBlocks.y, GL_RED, GL_FLOAT, blocks.data());
        render::BloomPass bloom(shaderFolder());
        bloom.resize(kBlocks);
        bloom.draw(source.id());
        std::vector<float> result(static_cast<std::size_t>(bloom.size().x * bloom.size().y));
        glBindTexture(GL_TEXTURE_2D, bloom.texture());
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, result.data());
        return result;
    }

    static std::vector<float> dark() { return std::vector<float>(kBlocks.x * kBlocks.y, 0.0f); }
};

TEST_F(BloomGl, EvenLightStaysAsItIs) {
    std::vector<float> even = dark();
    std::fill(even.begin(), even.end(), 7.0f);
    for (const float value : blurred(even)) EXPECT_NEAR(value, 7.0f, 1e-4f);
}

TEST_F(BloomGl, ASpotKeepsItsLightWhereverItStands) {
    for (int offset = 0; offset < 4; ++offset) {
        std::vector<float> spot = dark();
        spot[static_cast<std::size_t>((40 + offset) * kBlocks.x + 48 - offset)] = 1000.0f;
        const std::vector<float> result = blurred(spot);
        // A texel stands for four blocks. What leaves the picture is held by its border.
        EXPECT_NEAR(4.0f * std::accumulate(result.begin(), result.end(), 0.0f), 1000.0f, 60.0f) << offset;
        EXPECT_LT(*std::max_element(result.begin(), result.end()), 100.0f);
    }
}

}  // namespace
}  // namespace hazer::test
