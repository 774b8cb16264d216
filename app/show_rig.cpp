#include "app/show_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/rig_mount.h"
#include "app/rig_stage.h"
#include "app/rig_types.h"
#include "fixtures/parse_error.h"
#include "fixtures/text.h"
#include "fixtures/wheel_image.h"

namespace hazer::app {
namespace {

using fixtures::DmxMode;
using fixtures::MvrDevice;
using fixtures::MvrObject;
using fixtures::MvrScene;

constexpr std::size_t kMaxGoboBytes = std::size_t{16} << 20;
constexpr std::size_t kMostMeshUses = 20'000;  // Each is drawn by a call of its own.
constexpr std::size_t kMostFixtures = 20'000;
/// Channels and geometries of all fixtures together: some hundred bytes and nanoseconds a frame each.
constexpr std::size_t kMostPatchedParts = 500'000;
constexpr int kMaxPortAddress = 32767;

/// Where an MVR universe, which is a number from 1, is heard.
std::vector<protocol::UniverseId> universesFor(int universe, RigProtocol protocol) {
    std::vector<protocol::UniverseId> universes;
    const auto number = static_cast<std::uint16_t>(universe);
    const auto portAddress = static_cast<std::uint16_t>(universe - 1);
    if (protocol != RigProtocol::kArtNet) universes.push_back({protocol::Transport::kSacn, number});
    if (protocol != RigProtocol::kSacn && portAddress <= kMaxPortAddress)
        universes.push_back({protocol::Transport::kArtNet, portAddress});
    return universes;
}

std::size_t countGeometries(const fixtures::Geometry& geometry) {
    std::size_t count = 1;
    for (const fixtures::Geometry& child : geometry.children) count += countGeometries(child);
    return count;
}

/// Adds what a rig holds to a show.
class RigReader {
 public:
    RigReader(fixtures::MvrArchive& archive, Show& show)
        : archive_(archive), show_(show), types_(archive, show.rig.file.parent_path()) {
        for (const ShowFixture& fixture : show.fixtures) names_.insert(fixture.name);
        for (const ShowLight& light : show.lights) names_.insert(light.name);
    }

    void read() {
        const MvrScene scene = archive_.readScene();
        show_.scenery.archive = show_.rig.file;
        show_.scenery.files = scene.meshFiles;
        show_.warnings = scene.warnings;
        for (std::size_t i = 0; i < scene.objects.size(); ++i) readObject(scene, static_cast<int>(i));
        if (fixturesLeftOut_ > 0)
            warn(fmt::format("{} fixtures are left out: {} are enough, with {} channels and parts.",
                             fixturesLeftOut_, kMostFixtures, kMostPatchedParts));
        if (meshesLeftOut_ > 0)
            warn(fmt::format("{} meshes more than {} are left out.", meshesLeftOut_, kMostMeshUses));
        show_.warnings.insert(show_.warnings.end(), types_.warnings().begin(), types_.warnings().end());
    }

 private:
    void readObject(const MvrScene& scene, int index) {
        const MvrObject& object = scene.objects[static_cast<std::size_t>(index)];
        bool isFound = true;
        const glm::dmat4 moved = mounts_.worldFromScene(scene, index, isFound);
        if (!isFound) {
            warn(fmt::format("{} hangs on {}, which is no part of what it is in; it is drawn at its origin.",
                             fixtures::inQuotes(object.name),
                             fixtures::inQuotes(object.device->childPosition)));
        }
        if (object.device) {
            const DmxMode* const mode = readFixture(object, *object.device, moved);
            if (mode != nullptr) mounts_.add(index, *mode);
        }
        for (const fixtures::MvrMesh& mesh : object.meshes) {
            if (show_.scenery.uses.size() < kMostMeshUses) {
                show_.scenery.uses.push_back(
                    {static_cast<std::size_t>(mesh.file), moved * mesh.worldFromMesh});
            } else {
                ++meshesLeftOut_;
            }
        }
    }

    /// Its mode; null if it is left out.
    const DmxMode* readFixture(const MvrObject& object, const MvrDevice& device, const glm::dmat4& moved) {
        if (count_ == kMostFixtures || parts_ > kMostPatchedParts) {
            ++fixturesLeftOut_;
            return nullptr;
        }
        const bool isFixture = object.kind == fixtures::MvrKind::kFixture;
        const RigType type = types_.typeOf(device, object.name, isFixture);
        if (type.type == nullptr) return nullptr;
        const DmxMode& mode = *std::ranges::find(type.type->modes, type.mode, &fixtures::DmxMode::name);
        parts_ += mode.channels.size() + countGeometries(mode.geometry);
        if (parts_ > kMostPatchedParts) {
            ++fixturesLeftOut_;
            return nullptr;
        }
        ++count_;
        ShowFixture& fixture = show_.fixtures.emplace_back();
        fixture.name = uniqueName(object, device, *type.type);
        fixture.gdtf = device.gdtfSpec;
        fixture.mode = type.mode;
        const glm::dmat4 world = moved * object.worldFromObject;
        fixture.positionM = glm::dvec3(world[3]);
        fixture.line = show_.rig.line;
        fixture.rig = RigFixture{type.type, world, {}, {}, device.focusM};
        addAddresses(device, mode, fixture);
        followCommands(device, mode, *fixture.rig);
        fixture.rig->fittings.gel = device.gel;
        fixture.rig->fittings.invertsPan = device.invertsPan;
        fixture.rig->fittings.invertsTilt = device.invertsTilt;
        if (device.gobo) putGobo(*device.gobo, fixture);
        return &mode;
    }

    // A fixture is named by its number where the name alone says too little.
    std::string uniqueName(const MvrObject& object, const MvrDevice& device,
                           const fixtures::FixtureType& type) {
        const std::string base = object.name.empty() ? type.name : object.name;
        std::string name = base;
        if (names_.contains(name) && !device.fixtureId.empty())
            name = fmt::format("{} #{}", base, device.fixtureId);
        for (int& number = numbers_[base]; names_.contains(name);)
            name = fmt::format("{} ({})", base, ++number + 1);
        names_.insert(name);
        return name;
    }

    void addAddresses(const MvrDevice& device, const DmxMode& mode, ShowFixture& fixture) {
        for (const fixtures::MvrAddress& address : device.addresses) {
            const int footprint = fixtures::footprintOf(mode, address.dmxBreak);
            if (footprint == 0) continue;
            if (address.slot + footprint - 1 > fixtures::kSlotsPerUniverse) {
                warn(fmt::format(
                    "fixture {} runs past slot 512 of universe {}; what is beyond is not patched.",
                    fixtures::inQuotes(fixture.name), address.universe));
            }
            fixture.addresses.push_back(
                {address.dmxBreak, universesFor(address.universe, show_.rig.protocol), address.slot});
        }
    }

    // "Base_Zoom.Zoom.Zoom 1": of the path, the attribute counts. A zoom that the channel does not reach is
    // nevertheless what the lamp has.
    static void followCommands(const MvrDevice& device, const DmxMode& mode, RigFixture& rig) {
        for (const fixtures::MvrCommand& command : device.commands) {
            const std::vector<std::string_view> path = fixtures::split(command.function, '.');
            const std::string attribute(path[path.size() > 1 ? 1 : 0]);
            const std::optional<Range> range = rangeOf(mode, attribute);
            const bool isAngle = fixtures::equalsIgnoringCase(attribute, "Zoom") && !command.isPercent;
            if (isAngle && !(range && contains(*range, command.value))) {
                rig.fittings.zoomDeg = command.value;
            } else if (range) {
                const double share = 0.01 * command.value;
                const double value =
                    command.isPercent ? range->first + share * (range->second - range->first) : command.value;
                rig.presets.emplace_back(attribute, value);
            }
        }
    }

    using Range = std::pair<double, double>;

    static std::optional<Range> rangeOf(const DmxMode& mode, const std::string& attribute) {
        for (const fixtures::DmxChannel& channel : mode.channels) {
            for (const fixtures::LogicalChannel& logical : channel.logicalChannels) {
                for (const fixtures::ChannelFunction& function : logical.functions) {
                    if (fixtures::equalsIgnoringCase(function.attribute, attribute))
                        return Range{function.physicalFrom, function.physicalTo};
                }
            }
        }
        return std::nullopt;
    }

    static bool contains(const Range& range, double value) {
        const auto [low, high] = std::minmax(range.first, range.second);
        return value >= low && value <= high;
    }

    void putGobo(const fixtures::MvrGobo& gobo, ShowFixture& fixture) {
        const auto [known, isNew] = gobos_.try_emplace(gobo.fileName);
        if (isNew) known->second = readGobo(gobo.fileName);
        fixture.rig->fittings.gobo = known->second;
        fixture.rig->fittings.goboRotationDeg = gobo.rotationDeg;
    }

    std::shared_ptr<const fixtures::WheelImage> readGobo(const std::string& name) {
        const auto entry = archive_.find(name, {".png"});
        if (!entry || gobos_.size() > kMostGobos) {
            warn(fmt::format("the gobo {} is not in the rig; it is left out.", fixtures::inQuotes(name)));
            return nullptr;
        }
        try {
            return std::make_shared<const fixtures::WheelImage>(
                fixtures::decodeWheelImage(archive_.read(*entry, kMaxGoboBytes), name));
        } catch (const fixtures::ParseError& error) {
            warn(error.what());
            return nullptr;
        }
    }

    void warn(const std::string& sentence) { show_.warnings.push_back(sentence); }

    fixtures::MvrArchive& archive_;
    Show& show_;
    RigTypes types_;
    std::set<std::string> names_;
    std::map<std::string, int> numbers_;  // How often a name had to be numbered.
    std::map<std::string, std::shared_ptr<const fixtures::WheelImage>> gobos_;
    RigMounts mounts_;
    std::size_t count_ = 0;
    std::size_t parts_ = 0;
    std::size_t fixturesLeftOut_ = 0;
    std::size_t meshesLeftOut_ = 0;
    static constexpr std::size_t kMostGobos = 16;
};

}  // namespace

bool isRig(const std::filesystem::path& file) {
    return fixtures::equalsIgnoringCase(file.extension().string(), ".mvr");
}

void addRig(Show& show) {
    try {
        fixtures::MvrArchive archive(show.rig.file);
        RigReader(archive, show).read();
    } catch (const fixtures::ParseError& error) {
        throw ShowError(error.what());
    }
}

Show showOfRig(const std::filesystem::path& file) {
    Show show;
    show.file = file;
    show.title = file.stem().string();
    show.rig.file = file;
    addRig(show);
    setStage(show);
    return show;
}

}  // namespace hazer::app
