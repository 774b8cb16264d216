#include "app/picture_file.h"

#include <fmt/format.h>

#include <regex>
#include <stdexcept>
#include <string>
#include <system_error>

#include "render/image.h"

namespace hazer::app {

OutputKind outputKind(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".mp4") return OutputKind::kFilm;
    if (extension == ".png" || extension == ".exr") return OutputKind::kPicture;
    throw std::runtime_error(fmt::format("{}: the file must end in .png, .exr or .mp4", file.string()));
}

void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error) return;
    throw std::runtime_error(fmt::format("{}: the folder cannot be made ({}); choose another place",
                                         folder.string(), error.message()));
}

void makeFolderOf(const std::filesystem::path& file) {
    if (file.has_parent_path()) makeFolder(file.parent_path());
}

void writePicture(render::Renderer& renderer, const std::filesystem::path& file) {
    makeFolderOf(file);
    if (file.extension() == ".exr") {
        render::writeImage(renderer.readRadiance(), file);
    } else {
        render::writeImage(renderer.readDisplay(), file);
    }
}

std::filesystem::path numberedFile(const std::filesystem::path& file, int index) {
    static const std::regex pattern("%0?([0-9]?)d");
    std::string name = file.filename().string();
    std::smatch found;
    if (std::regex_search(name, found, pattern)) {
        const int digits = found[1].length() == 0 ? 1 : std::stoi(found[1].str());
        name = found.prefix().str() + fmt::format("{:0{}}", index, digits) + found.suffix().str();
    } else {
        name = fmt::format("{}_{:04}{}", file.stem().string(), index, file.extension().string());
    }
    return std::filesystem::path(file).replace_filename(name);
}

}  // namespace hazer::app
