#include "render/gl/shader_source.h"

#include <fmt/format.h>

#include <fstream>
#include <set>

#include "render/error.h"

namespace hazer::render::gl {
namespace {

class Expander {
 public:
    Expander(const std::filesystem::path& folder, const std::vector<std::string>& features)
        : folder_(folder), features_(features) {}

    void add(const std::string& file, const std::string& wantedBy) {
        if (!seen_.insert(file).second) return;
        std::ifstream in(folder_ / file);
        if (!in) {
            throw RenderError(
                fmt::format("Shader {} is missing{}; set HAZER_DATA to the folder that holds shaders/",
                            (folder_ / file).string(), wantedBy));
        }
        const auto fileNumber = seen_.size();
        std::string line;
        for (int number = 1; std::getline(in, line); ++number) {
            if (line.starts_with("#version")) {
                addVersion(line);
            } else if (const auto name = includedFile(line); !name.empty()) {
                add(name, fmt::format(" ({}:{} includes it)", file, number));
                text_ += fmt::format("#line {} {}\n", number + 1, fileNumber);
            } else {
                text_ += line + '\n';
            }
        }
    }

    std::string take() { return std::move(text_); }

 private:
    void addVersion(const std::string& line) {
        text_ += line + '\n';
        for (const std::string& feature : features_) text_ += fmt::format("#define {} 1\n", feature);
        text_ += "#line 2 1\n";
    }

    static std::string includedFile(const std::string& line) {
        if (!line.starts_with("#include")) return {};
        const auto open = line.find('"');
        const auto close = line.rfind('"');
        return open == std::string::npos || close <= open ? std::string()
                                                          : line.substr(open + 1, close - open - 1);
    }

    const std::filesystem::path& folder_;
    const std::vector<std::string>& features_;
    std::set<std::string> seen_;
    std::string text_;
};

}  // namespace

std::string expandShader(const std::filesystem::path& folder, const std::string& file,
                         const std::vector<std::string>& features) {
    Expander expander(folder, features);
    expander.add(file, "");
    return expander.take();
}

}  // namespace hazer::render::gl
