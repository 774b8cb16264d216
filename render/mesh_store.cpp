#include "render/mesh_store.h"

#include "render/gl/inventory.h"

namespace hazer::render {

MeshId MeshStore::add(const Mesh& mesh) {
    GpuMesh gpu;
    gpu.vertexArray = gl::makeVertexArray();
    gpu.vertices = gl::makeBuffer();
    gpu.indices = gl::makeBuffer();
    gpu.indexCount = static_cast<GLsizei>(mesh.indices.size());
    gpu.vertexCount = mesh.vertices.size();
    glBindVertexArray(gpu.vertexArray.id());
    glBindBuffer(GL_ARRAY_BUFFER, gpu.vertices.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
                 mesh.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.indices.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)), mesh.indices.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offsetof(Vertex, normal)));
    glBindVertexArray(0);
    meshes_.push_back(std::move(gpu));
    bounds_.push_back({boundingSphere(mesh), boundingBox(mesh)});
    return static_cast<MeshId>(meshes_.size()) - 1;
}

Mesh MeshStore::read(MeshId mesh) const {
    const GpuMesh& gpu = meshes_[static_cast<std::size_t>(mesh)];
    Mesh copy;
    copy.vertices.resize(gpu.vertexCount);
    copy.indices.resize(static_cast<std::size_t>(gpu.indexCount));
    // The copy target, so that no vertex array's index buffer is replaced.
    glBindBuffer(GL_COPY_READ_BUFFER, gpu.vertices.id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(copy.vertices.size() * sizeof(Vertex)),
                       copy.vertices.data());
    glBindBuffer(GL_COPY_READ_BUFFER, gpu.indices.id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0,
                       static_cast<GLsizeiptr>(copy.indices.size() * sizeof(std::uint32_t)),
                       copy.indices.data());
    return copy;
}

void MeshStore::draw(MeshId mesh) const {
    const GpuMesh& gpu = meshes_[static_cast<std::size_t>(mesh)];
    glBindVertexArray(gpu.vertexArray.id());
    glDrawElements(GL_TRIANGLES, gpu.indexCount, GL_UNSIGNED_INT, nullptr);
}

void MeshStore::list(Resources& resources) const {
    for (const GpuMesh& mesh : meshes_) {
        gl::listBuffer(resources, "meshes", mesh.vertices);
        gl::listBuffer(resources, "meshes", mesh.indices);
    }
}

}  // namespace hazer::render
