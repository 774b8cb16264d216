#include "render/gl/program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "render/error.h"
#include "render/gl/shader_source.h"
#include "render/resources.h"

namespace hazer::render::gl {
namespace {

template <typename GetParameter, typename GetLog>
std::string infoLog(GLuint id, GetParameter getParameter, GetLog getLog) {
    GLint length = 0;
    getParameter(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    getLog(id, length, nullptr, log.data());
    return log.c_str();
}

Shader compile(GLenum stage, const std::filesystem::path& folder, const std::string& file,
               const std::vector<std::string>& features) {
    const std::string source = expandShader(folder, file, features);
    Shader shader(glCreateShader(stage));
    const char* text = source.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint ok = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
    if (ok != GL_TRUE) {
        throw RenderError(fmt::format("Shader {} [{}] does not compile: {}", file, fmt::join(features, " "),
                                      infoLog(shader.id(), glGetShaderiv, glGetShaderInfoLog)));
    }
    return shader;
}

}  // namespace

Program::Program(const std::filesystem::path& shaderFolder, const std::string& vertexFile,
                 const std::string& fragmentFile, const std::vector<std::string>& features)
    : name_(shaderName(fragmentFile, features)), program_(glCreateProgram()) {
    const Shader vertex = compile(GL_VERTEX_SHADER, shaderFolder, vertexFile, features);
    const Shader fragment = compile(GL_FRAGMENT_SHADER, shaderFolder, fragmentFile, features);
    glAttachShader(program_.id(), vertex.id());
    glAttachShader(program_.id(), fragment.id());
    glLinkProgram(program_.id());
    GLint ok = GL_FALSE;
    glGetProgramiv(program_.id(), GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE) {
        throw RenderError(fmt::format("Shaders {} and {} do not link: {}", vertexFile, fragmentFile,
                                      infoLog(program_.id(), glGetProgramiv, glGetProgramInfoLog)));
    }
}

GLint Program::location(const char* name) const {
    const auto found = locations_.find(name);
    if (found != locations_.end()) return found->second;
    return locations_.emplace(name, glGetUniformLocation(program_.id(), name)).first->second;
}

void Program::set(const char* name, int value) const {
    glUniform1i(location(name), value);
}
void Program::set(const char* name, float value) const {
    glUniform1f(location(name), value);
}
void Program::set(const char* name, const glm::vec2& v) const {
    glUniform2f(location(name), v.x, v.y);
}
void Program::set(const char* name, const glm::vec3& v) const {
    glUniform3f(location(name), v.x, v.y, v.z);
}
void Program::set(const char* name, const glm::vec4& v) const {
    glUniform4f(location(name), v.x, v.y, v.z, v.w);
}
void Program::set(const char* name, const glm::mat3& m) const {
    glUniformMatrix3fv(location(name), 1, GL_FALSE, &m[0][0]);
}
void Program::set(const char* name, const glm::mat4& m) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, &m[0][0]);
}

LazyProgram::LazyProgram(std::filesystem::path shaderFolder, std::string vertexFile, std::string fragmentFile,
                         std::vector<std::string> features)
    : shaderFolder_(std::move(shaderFolder)),
      vertexFile_(std::move(vertexFile)),
      fragmentFile_(std::move(fragmentFile)),
      features_(std::move(features)) {}

const Program& LazyProgram::get() {
    if (!program_) program_.emplace(shaderFolder_, vertexFile_, fragmentFile_, features_);
    return *program_;
}

}  // namespace hazer::render::gl
