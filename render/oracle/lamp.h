// A beam of the scene in its own frame, and what its light passes on the way: gobo and bodies.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/ies_web.h"
#include "render/oracle/bodies.h"
#include "render/oracle/gobo_picture.h"
#include "render/oracle/single_beam.h"
#include "render/photometry.h"
#include "render/scene.h"

namespace hazer::render::oracle {

/// Points "in the lamp" have the virtual apex at the origin and the light along -Z.
struct Lamp {
    Beam beam;
    BeamShape shape;
    BeamModel model;
    glm::dvec3 apexM;  ///< World.
    glm::dmat3 lampFromWorld;

    /// A point or a ray of the world in the lamp.
    glm::dvec3 inLamp(const glm::dvec3& worldM) const { return lampFromWorld * (worldM - apexM); }
    Ray inLamp(const Ray& world) const {
        return {inLamp(world.originM), lampFromWorld * world.direction, world.endM};
    }
};

/// `webs` are indexed by WebId and must outlive the lamp.
Lamp makeLamp(const Beam& beam, std::span<const IesWeb> webs);

/// What the gobo lets through towards a point in the lamp; `footprintM` is the width there of what one pixel
/// sees. The blur is the wider of the footprint and the circle of confusion of a thin lens.
glm::dvec3 throughGobo(const Lamp& lamp, const GoboPicture& gobo, const glm::dvec3& inLampM,
                       double footprintM);

/// Is no body between the lens and the point that lies this share of the way to `inLampM`?
bool isLit(const Lamp& lamp, const Bodies& bodies, const glm::dvec3& inLampM, double shareOfWay);

/// The lit parts of a smooth stretch of a ray in the lamp: looked for in 512 places, even over the angle at
/// the lamp, and narrowed down by halving.
std::vector<Stretch> litParts(const Lamp& lamp, const Bodies& bodies, const Ray& inLamp,
                              const Stretch& stretch);

}  // namespace hazer::render::oracle
