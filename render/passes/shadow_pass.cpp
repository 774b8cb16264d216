#include "render/passes/shadow_pass.h"

#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {
namespace {

/// What each map of the plan has to hold, map after map, face after face.
std::vector<ShadowRequest> requestsOf(const Scene& scene, const ScenePlan& plan) {
    std::vector<ShadowRequest> requests;
    for (const ShadowMapPlan& map : plan.shadowMaps) {
        const auto beam = static_cast<std::size_t>(map.beam);
        for (const ShadowFacePlan& face : map.faces) {
            ShadowRequest request{face.sizeTexels, {}};
            request.content.clipFromWorld =
                clipFromWorld(scene.beams[beam], plan.shapes[beam], face.face, shadowProjection(face));
            for (const int caster : face.casters) {
                const MeshInstance& instance = scene.instances[static_cast<std::size_t>(caster)];
                request.content.casters.emplace_back(instance.mesh, instance.worldFromMesh);
            }
            requests.push_back(std::move(request));
        }
    }
    return requests;
}

std::vector<ShadowFaceRecord> recordsOf(const ScenePlan& plan, const std::vector<ShadowTile>& tiles) {
    std::vector<ShadowFaceRecord> records;
    std::size_t tile = 0;
    for (const ShadowMapPlan& map : plan.shadowMaps) {
        const std::size_t first = records.size();
        records.resize(first + static_cast<std::size_t>(faceRecordCount(map)), emptyFaceRecord());
        for (const ShadowFacePlan& face : map.faces) {
            records[first + static_cast<std::size_t>(face.face)] =
                faceRecord(shadowProjection(face), tiles[tile++]);
        }
    }
    return records;
}

}  // namespace

ShadowPass::ShadowPass(const std::filesystem::path& shaderFolder)
    : program_(shaderFolder, "shadow.vert", "shadow.frag") {}

void ShadowPass::allocate(int edge) {
    if (edge == allocatedEdge_) return;
    allocatedEdge_ = edge;
    atlas_ = gl::makeTexture2d(GL_DEPTH_COMPONENT32F, edge, edge, GL_NEAREST);
    framebuffer_ = gl::makeFramebufferFor({}, atlas_.id());
    glDrawBuffer(GL_NONE);
}

void ShadowPass::uploadFaces(const std::vector<ShadowFaceRecord>& records) {
    if (faceBuffer_.id() == 0) faceBuffer_ = gl::makeBuffer();
    glBindBuffer(GL_TEXTURE_BUFFER, faceBuffer_.id());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(records.size() * sizeof(ShadowFaceRecord)),
                 records.data(), GL_STREAM_DRAW);
    if (faces_.id() != 0) return;
    faces_ = gl::makeTexture();
    glBindTexture(GL_TEXTURE_BUFFER, faces_.id());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, faceBuffer_.id());
}

void ShadowPass::drawTile(const ShadowTile& tile, const ShadowContent& content, const gl::Program& program,
                          const MeshStore& meshes) {
    static constexpr float kLit = 0.0f;
    glScissor(tile.originPx.x, tile.originPx.y, tile.sizeTexels, tile.sizeTexels);
    glClearBufferfv(GL_DEPTH, 0, &kLit);
    const glm::ivec2 origin = tile.originPx + kShadowRimTexels;
    const int window = tile.sizeTexels - 2 * kShadowRimTexels;
    glViewport(origin.x, origin.y, window, window);
    glScissor(origin.x, origin.y, window, window);
    for (const auto& [mesh, worldFromMesh] : content.casters) {
        program.set("clipFromMesh", glm::mat4(content.clipFromWorld * worldFromMesh));
        meshes.draw(mesh);
    }
}

void ShadowPass::draw(const Scene& scene, const ScenePlan& plan, const MeshStore& meshes) {
    redrawn_ = 0;
    if (plan.shadowMaps.empty()) return;
    const std::vector<ShadowRequest> requests = requestsOf(scene, plan);
    const std::vector<ShadowTile> tiles = tiles_.place(requests);
    allocate(tiles_.edge());
    uploadFaces(recordsOf(plan, tiles));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    const gl::Program& program = program_.get();
    program.use();
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (!tiles[i].isFresh) continue;
        drawTile(tiles[i], requests[i].content, program, meshes);
        ++redrawn_;
    }
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

void ShadowPass::list(Resources& resources) const {
    gl::listProgram(resources, program_);
    gl::listTexture(resources, "shadow maps", GL_TEXTURE_2D, atlas_);
    gl::listBufferTexture(resources, "shadow faces", faceBuffer_, sizeof(glm::vec4));
}

}  // namespace hazer::render
