// A linked shader program with its uniforms by name.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/gl/handle.h"

namespace hazer::render::gl {

/// Compiles and links on construction; throws RenderError with the compiler's words. Setting a uniform that
/// the variant does not have is fine: features decide what a shader needs.
class Program {
 public:
    Program(const std::filesystem::path& shaderFolder, const std::string& vertexFile,
            const std::string& fragmentFile, const std::vector<std::string>& features = {});

    void use() const { glUseProgram(program_.id()); }

    /// As render::shaderName() has it.
    const std::string& name() const { return name_; }

    // The program must be in use.
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const glm::vec2& value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::vec4& value) const;
    void set(const char* name, const glm::mat3& value) const;
    void set(const char* name, const glm::mat4& value) const;

 private:
    GLint location(const char* name) const;

    std::string name_;
    ProgramHandle program_;
    mutable std::map<std::string, GLint, std::less<>> locations_;
};

/// A program that is compiled when it is first asked for: what no frame needs is not there.
class LazyProgram {
 public:
    LazyProgram(std::filesystem::path shaderFolder, std::string vertexFile, std::string fragmentFile,
                std::vector<std::string> features = {});

    /// Throws what the constructor of Program throws.
    const Program& get();

    /// Empty until get() was called.
    const std::optional<Program>& compiled() const { return program_; }

 private:
    std::filesystem::path shaderFolder_;
    std::string vertexFile_, fragmentFile_;
    std::vector<std::string> features_;
    std::optional<Program> program_;
};

}  // namespace hazer::render::gl
