#include "render/asset_list.h"

#include "render/gobo_picture.h"

namespace hazer::render {

MeshId AssetList::addMesh(const Mesh& mesh) {
    bounds_.push_back({boundingSphere(mesh), boundingBox(mesh)});
    meshBytes_ += mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * sizeof(std::uint32_t);
    return static_cast<MeshId>(bounds_.size()) - 1;
}

GoboId AssetList::addGobo(const std::uint8_t* rgba, int width, int height) {
    layersOfGoboTables_.push_back(makeGoboPicture(rgba, width, height).grey ? 1 : 3);
    return static_cast<GoboId>(layersOfGoboTables_.size()) - 1;
}

WebId AssetList::addWeb(const IesWeb& web) {
    webs_.push_back(web);
    return static_cast<WebId>(webs_.size()) - 1;
}

}  // namespace hazer::render
