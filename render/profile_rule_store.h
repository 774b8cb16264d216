// Rules for soft profiles on the GPU.
#pragma once

#include <map>
#include <utility>

#include "render/gl/handle.h"
#include "render/profile_rule.h"
#include "render/resources.h"

namespace hazer::render {

/// One row of a texture for each profile in use. Rules of a tenth of a percent of the angle's own size are
/// shared, so that a zoom in motion makes few of them.
class ProfileRuleStore {
 public:
    /// Makes room for a frame's profiles; rows given out before may be given to others.
    void beginFrame();

    /// The row of a soft profile; -1 if it has none, being too wide or one too many. Needs the GL context.
    int row(const BeamShape& shape);

    /// A GL_TEXTURE_2D of kProfileRuleColumns x kProfileRuleRows; 0 while no row has been asked for.
    GLuint texture() const { return texture_.id(); }

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    using Key = std::pair<float, int>;  ///< Exponent, and logarithm of the cut.

    gl::Texture texture_;
    std::map<Key, int> rows_;
};

}  // namespace hazer::render
