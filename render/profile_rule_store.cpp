#include "render/profile_rule_store.h"

#include <cmath>

#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {

void ProfileRuleStore::beginFrame() {
    if (rows_.size() > kProfileRuleRows / 2) rows_.clear();
}

int ProfileRuleStore::row(const BeamShape& shape) {
    if (!hasProfileRules(shape)) return -1;
    const Key key(static_cast<float>(shape.exponent),
                  static_cast<int>(std::lround(1000.0 * std::log(shape.cutHalfAngleRad))));
    const auto found = rows_.find(key);
    if (found != rows_.end()) return found->second;
    if (rows_.size() == kProfileRuleRows) return -1;
    if (texture_.id() == 0) {
        texture_ = gl::makeTexture2d(GL_RGBA32F, kProfileRuleColumns, kProfileRuleRows, GL_LINEAR);
    }
    const int row = static_cast<int>(rows_.size());
    const std::vector<glm::vec4> rules = profileRules(shape);
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, row, kProfileRuleColumns, 1, GL_RGBA, GL_FLOAT, rules.data());
    rows_.emplace(key, row);
    return row;
}

void ProfileRuleStore::list(Resources& resources) const {
    gl::listTexture(resources, "profile rules", GL_TEXTURE_2D, texture_);
}

}  // namespace hazer::render
