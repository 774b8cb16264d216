#include "app/rig_types.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/fixture_library.h"
#include "app/stand_in.h"
#include "fixtures/gdtf.h"
#include "fixtures/parse_error.h"
#include "fixtures/text.h"

namespace hazer::app {
namespace {

using fixtures::DmxMode;
using fixtures::FixtureType;
using fixtures::FixtureTypePtr;
using fixtures::inQuotes;

constexpr std::size_t kMaxGdtfBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxWarnings = 200;

/// No rig has as many, and each takes time even where it is broken.
constexpr std::size_t kMaxTypes = 1000;

/// The file's own name alone, so that a rig cannot reach out of its folder.
std::filesystem::path besideRig(const std::filesystem::path& folder, const std::string& spec) {
    std::error_code ignored;
    const std::string name = spec.substr(spec.find_last_of("/\\") + 1);
    if (name.empty()) return {};
    for (const std::string& spelling : {name, name + ".gdtf"}) {
        const std::filesystem::path path = folder / spelling;
        if (path.extension() == ".gdtf" && std::filesystem::is_regular_file(path, ignored)) return path;
    }
    return {};
}

}  // namespace

RigTypes::RigTypes(fixtures::MvrArchive& archive, std::filesystem::path folder)
    : archive_(archive), folder_(std::move(folder)) {}

RigType RigTypes::typeOf(const fixtures::MvrDevice& device, const std::string& name, bool isFixture) {
    if (device.gdtfSpec.empty()) return standIn("the GDTF of some fixtures", "is not named", nullptr, name);
    const std::string described = fmt::format("the GDTF {}", inQuotes(device.gdtfSpec));
    const Loaded& loaded = load(device.gdtfSpec);
    if (loaded.type == nullptr) {
        return isFixture ? standIn(described, loaded.fault, nullptr, device.gdtfSpec + " " + name)
                         : RigType{};
    }
    if (loaded.type->modes.empty()) {
        if (isFixture) warn(fmt::format("{} has no DMX mode; its fixtures are left out.", described));
        return {};
    }
    const DmxMode* const mode = modeOf(*loaded.type, device.gdtfMode, described);
    if (!isFixture || !isDummy(*mode)) return {loaded.type, mode->name};
    return standIn(
        fmt::format("{}, mode {},", described, inQuotes(mode->name)),
        fmt::format("says nothing of its light ({} slots without beam or meaning)", mode->footprint), mode,
        loaded.type->name + " " + device.gdtfSpec + " " + name);
}

const RigTypes::Loaded& RigTypes::load(const std::string& spec) {
    const std::optional<std::size_t> entry = archive_.find(spec, {".gdtf"});
    const auto [known, isNew] = loaded_.try_emplace(entry ? archive_.nameOf(*entry) : spec);
    if (isNew)
        known->second =
            loaded_.size() > kMaxTypes ? Loaded{nullptr, "comes after too many others"} : read(spec, entry);
    return known->second;
}

RigTypes::Loaded RigTypes::read(const std::string& spec, const std::optional<std::size_t>& entry) {
    try {
        FixtureTypePtr type;
        if (entry) {
            type = fixtures::parseGdtfArchive(archive_.read(*entry, kMaxGdtfBytes), archive_.nameOf(*entry),
                                              &budget_);
        } else if (const std::filesystem::path file = besideRig(folder_, spec); !file.empty()) {
            type = fixtures::loadGdtf(file, &budget_);
        } else {
            return {nullptr, "is neither in the rig nor beside it"};
        }
        return {type, ""};
    } catch (const fixtures::ParseError& error) {
        return {nullptr, fmt::format("cannot be read ({})", error.what())};
    }
}

FixtureTypePtr RigTypes::libraryType(const std::string& name) {
    FixtureTypePtr& type = library_[name];
    if (type == nullptr) type = fixtures::loadGdtf(resolveGdtf(name, {}));
    return type;
}

RigType RigTypes::standIn(const std::string& description, const std::string& reason, const DmxMode* mode,
                          const std::string& name) {
    std::string library = standInFor(name, mode);
    const int slots = mode == nullptr ? 0 : mode->footprint;
    if (modeFitting(*libraryType(library), slots) == nullptr) library = smallestStandIn();
    const FixtureTypePtr type = libraryType(library);
    const DmxMode* const fitting = modeFitting(*type, slots);
    if (fitting == nullptr) {
        warn(fmt::format("{} {}, and none of hazer's is as small; its fixtures are left out.", description,
                         reason));
        return {};
    }
    warn(fmt::format("{} {}; hazer's '{}', mode '{}', stands in for it.", description, reason, library,
                     fitting->name));
    return {type, fitting->name};
}

const DmxMode* RigTypes::modeOf(const FixtureType& type, const std::string& mode,
                                const std::string& described) {
    auto found = std::ranges::find(type.modes, mode, &DmxMode::name);
    if (found == type.modes.end()) {
        found = std::ranges::find_if(
            type.modes, [&](const DmxMode& m) { return fixtures::equalsIgnoringCase(m.name, mode); });
    }
    if (found != type.modes.end()) return &*found;
    warn(fmt::format("{} has no mode {}; its first, {}, is taken.", described, inQuotes(mode),
                     inQuotes(type.modes.front().name)));
    return &type.modes.front();
}

void RigTypes::warn(const std::string& sentence) {
    if (warnings_.size() >= kMaxWarnings) return;
    if (std::ranges::find(warnings_, sentence) == warnings_.end()) warnings_.push_back(sentence);
}

}  // namespace hazer::app
