// A folder of a test's own that goes away with it.
#pragma once

#include <filesystem>
#include <string_view>

namespace hazer::test {

class TemporaryFolder {
 public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Writes a file into it and returns its path.
    std::filesystem::path write(const std::filesystem::path& name, std::string_view content) const;

 private:
    std::filesystem::path path_;
};

}  // namespace hazer::test
