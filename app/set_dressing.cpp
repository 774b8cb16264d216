#include "app/set_dressing.h"

#include <fmt/format.h>

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <string>

#include "render/error.h"
#include "render/mesh.h"

namespace hazer::app {
namespace {

constexpr double kPersonHeightM = 1.75;  // of render::makePerson()

/// Two objects with the same key have the same mesh.
std::string meshKey(const ShowObject& object) {
    switch (object.shape) {
        case ObjectShape::kFloor:
        case ObjectShape::kWall:
            return "plane";
        case ObjectShape::kBox:
        case ObjectShape::kDeck:
            return "box";
        case ObjectShape::kTruss:
            return fmt::format("truss {} {}", object.sizeM.x, object.sizeM.y);
        case ObjectShape::kModel:
            return "model " + object.modelFile.string();
        default:
            return fmt::format("shape {}", static_cast<int>(object.shape));
    }
}

render::Mesh makeMesh(const ShowObject& object) {
    switch (object.shape) {
        case ObjectShape::kFloor:
        case ObjectShape::kWall:
            return render::makePlane();
        case ObjectShape::kBox:
        case ObjectShape::kDeck:
            return render::makeBox();
        case ObjectShape::kCylinder:
            return render::makeCylinder();
        case ObjectShape::kSphere:
            return render::makeSphere();
        case ObjectShape::kTeapot:
            return render::makeTeapot();
        case ObjectShape::kPerson:
            return render::makePerson();
        case ObjectShape::kTruss:
            return render::makeTruss(object.sizeM.x, object.sizeM.y);
        case ObjectShape::kModel:
            return render::loadMesh(object.modelFile);
    }
    return {};
}

render::Mesh makeMeshOf(const Show& show, const ShowObject& object) {
    try {
        return makeMesh(object);
    } catch (const render::RenderError& error) {
        throw ShowError(fmt::format("{}:{}: {}", show.file.string(), object.line, error.what()));
    }
}

/// From the unit mesh to its size, about the place that the object's position names.
glm::dmat4 placedFromMesh(const ShowObject& object) {
    const glm::dmat4 same(1.0);
    const glm::dvec3& size = object.sizeM;
    switch (object.shape) {
        case ObjectShape::kFloor:
            return glm::scale(same, {size.x, size.y, 1.0});
        case ObjectShape::kWall:
            return glm::scale(glm::rotate(same, glm::radians(90.0), {1.0, 0.0, 0.0}), {size.x, size.y, 1.0});
        case ObjectShape::kDeck:
            return glm::scale(glm::translate(same, {0.0, 0.0, size.z / 2.0}), size);
        case ObjectShape::kTeapot:
            return glm::scale(same, glm::dvec3(size.z));
        case ObjectShape::kPerson:
            return glm::scale(same, glm::dvec3(size.z / kPersonHeightM));
        case ObjectShape::kTruss:
            return same;
        case ObjectShape::kBox:
        case ObjectShape::kCylinder:
        case ObjectShape::kSphere:
        case ObjectShape::kModel:
            break;
    }
    return glm::scale(same, size);
}

}  // namespace

glm::dmat4 worldFromMesh(const ShowObject& object) {
    return worldFromPlaced(object.positionM, object.rotationDeg) * placedFromMesh(object);
}

SetDressing dressSet(const Show& show, render::AssetSink& assets) {
    std::map<std::string, render::MeshId> meshes;
    SetDressing dressing;
    for (const ShowObject& object : show.objects) {
        const auto [mesh, isNew] = meshes.try_emplace(meshKey(object), -1);
        if (isNew) mesh->second = assets.addMesh(makeMeshOf(show, object));
        dressing.push_back(
            {{mesh->second, worldFromMesh(object), object.material, object.castsShadow}, object.isFurther});
    }
    return dressing;
}

}  // namespace hazer::app
