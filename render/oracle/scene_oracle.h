// The radiance of single camera rays of a whole scene, by plain geometry in double: what pictures are held
// against. Shares no formula with the shaders, and traces rays through Embree where they look into maps.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "render/ies_web.h"
#include "render/mesh.h"
#include "render/oracle/bodies.h"
#include "render/oracle/gobo_picture.h"
#include "render/oracle/haze_density.h"
#include "render/oracle/lamp.h"
#include "render/oracle/single_beam.h"
#include "render/scene.h"

namespace hazer::render::oracle {

/// What a scene's handles stand for.
struct Library {
    std::vector<Mesh> meshes;        ///< By MeshId.
    std::vector<GoboPicture> gobos;  ///< By GoboId.
    std::vector<IesWeb> webs;        ///< By WebId.
    Density density;                 ///< Empty: even haze.
};

/// Answers for one scene, seen by one camera in a picture of width x height pixels. Colours are linear
/// Rec. 2020, light in cd/m^2. Exact single scattering; lenses do not shine here.
class SceneOracle {
 public:
    /// Throws RenderError if Embree does not start.
    SceneOracle(Scene scene, const Camera& camera, int width, int height, Library library);

    /// Light that the haze scatters into the ray through a place of the picture; pixel x, y (row 0 on top)
    /// has its centre at x + 0.5, y + 0.5.
    glm::dvec3 air(double x, double y) const;

    /// Light of the beams and of the ambient on what the ray meets, or the background, behind haze.
    glm::dvec3 surface(double x, double y) const;

    /// Do rays a hundredth of a pixel apart meet the same? On the outline of a body a picture may show either
    /// side.
    bool isClearOfOutlines(double x, double y) const;

 private:
    Ray worldRay(double x, double y) const;
    glm::dvec3 airOf(const Lamp& lamp, const Ray& ray) const;
    std::vector<Stretch> litPieces(const Lamp& lamp, const Ray& inLamp, int parts) const;
    glm::dvec3 surfaceOf(const Lamp& lamp, const Ray& ray, const BodyPoint& hit) const;
    const GoboPicture* goboOf(const Lamp& lamp) const;

    Scene scene_;
    Camera camera_;
    int width_;
    int height_;
    double pixelRad_;  ///< Angle of one pixel in the middle of the picture.
    Library library_;
    HazeModel haze_;
    Bodies bodies_;
    std::vector<Lamp> lamps_;
};

}  // namespace hazer::render::oracle
