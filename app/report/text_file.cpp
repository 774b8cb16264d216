#include "app/report/text_file.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace hazer::app {

void writeText(const std::filesystem::path& file, std::string_view text) {
    std::filesystem::path unfinished = file;
    unfinished += ".part";
    std::ofstream stream(unfinished, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    std::error_code failure;
    if (stream) std::filesystem::rename(unfinished, file, failure);
    if (stream && !failure) return;
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw std::runtime_error(
        fmt::format("{} cannot be written; check that its folder can be written to and the disk has room",
                    file.string()));
}

}  // namespace hazer::app
