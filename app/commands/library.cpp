// hazer library: the fixtures that come with hazer, and pictures of them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/commands/size_option.h"
#include "app/library_listing.h"
#include "app/library_thumbnail.h"
#include "app/picture_file.h"
#include "app/progress.h"
#include "app/report/text_file.h"
#include "render/gl/headless_context.h"

namespace hazer::app {
namespace {

struct LibraryOptions {
    std::vector<std::string> fixtures;
    bool isJson = false;
    std::string thumbnails;
    std::string page;
    Size size{192, 108};
};

void drawThumbnails(const std::vector<LibraryEntry>& library, const Size& size,
                    const std::filesystem::path& folder) {
    makeFolder(folder);
    const render::gl::HeadlessContext context;
    Progress progress("drawing fixture", static_cast<int>(library.size()));
    int number = 0;
    for (const LibraryEntry& entry : library) {
        drawThumbnail(entry, number++, size.width, size.height, folder / (entry.folder + ".png"));
        progress.show(number);
    }
}

int runLibrary(const LibraryOptions& options) {
    const std::vector<LibraryEntry> library = readLibrary(options.fixtures);
    if (!options.page.empty()) {
        const std::filesystem::path page = options.page;
        const std::string pictures = "images/library";
        drawThumbnails(library, options.size, page.parent_path() / pictures);
        writeText(page, libraryPage(library, pictures));
    }
    if (!options.thumbnails.empty()) drawThumbnails(library, options.size, options.thumbnails);
    fmt::print("{}", options.isJson ? describeLibrary(library).dump(2) + "\n" : summarizeLibrary(library));
    return kExitOk;
}

}  // namespace

void addLibraryCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<LibraryOptions>();
    CLI::App* command = program.add_subcommand("library", "List the fixtures that come with hazer.");
    beginHelpWith(*command,
                  "  hazer library                               what there is and what it can\n"
                  "  hazer library --json                        the same for machines\n"
                  "  hazer library --thumbnails pictures         a small picture of each\n"
                  "  hazer library scanner --thumbnails . --size 960x540\n"
                  "  hazer library --page docs/library.md        a page with pictures\n");
    command->add_option("FIXTURE", options->fixtures, "Only these; all unless given");
    command->add_flag("--json", options->isJson, "Print JSON");
    command->add_option("--thumbnails", options->thumbnails,
                        "Folder to draw a picture of each fixture into, FIXTURE.png");
    command->add_option("--page", options->page,
                        "Markdown file to write; its pictures go to images/library beside it");
    addSizeOption(*command, options->size);
    command->callback([options, &chosen] { chosen = [options] { return runLibrary(*options); }; });
}

}  // namespace hazer::app
