#include "tests/bench/hostile_files.h"

#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <cstdint>
#include <stdexcept>
#include <utility>

#include "tests/fixtures/description.h"
#include "tests/support/mesh_bytes.h"

namespace hazer::bench {
namespace {

using fixtures::testing::Description;
using test::bytesOf;
using test::chunk3ds;
using test::file3ds;

using Entries = std::vector<std::pair<std::string, std::string>>;

constexpr std::size_t kMiB = std::size_t{1} << 20;

std::string zip(const Entries& entries) {
    const std::vector<std::uint8_t> bytes = fixtures::testing::zipOf(entries);
    return {bytes.begin(), bytes.end()};
}

std::string repeated(std::string_view part, std::size_t count) {
    std::string text;
    text.reserve(part.size() * count);
    for (std::size_t i = 0; i < count; ++i) text += part;
    return text;
}

/// `count` parts, with {} as their number.
std::string numbered(fmt::format_string<std::size_t&> part, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += fmt::format(part, i);
    return text;
}

// ---- GDTF

std::string gdtf(const std::string& description) {
    return zip({{"description.xml", description}});
}

std::string gdtfOf(const Description& description) {
    return gdtf(description.xml());
}

std::string dimmer(const std::string& geometry = "Beam") {
    return fixtures::testing::simpleChannelXml(geometry, "1", "Dimmer", 0, 1);
}

std::string plainGdtf() {
    Description description;
    description.channels = dimmer();
    return gdtfOf(description);
}

std::string gdtfWithDefinitions(const std::string& definitions) {
    Description description;
    description.definitions = definitions;
    description.channels = dimmer();
    return gdtfOf(description);
}

std::string gdtfOfGeometries(const std::string& geometries, const std::string& channels, int modes) {
    Description description;
    description.geometries = geometries;
    description.channels = channels;
    std::string xml = description.xml();
    const std::size_t begin = xml.find("<DMXMode ");
    const std::size_t end = xml.find("</DMXModes>");
    const std::string mode = xml.substr(begin, end - begin);
    std::string all;
    for (int i = 0; i < modes; ++i) all += mode;
    return gdtf(xml.replace(begin, end - begin, all));
}

/// Each level refers `fan` times to the next.
std::string referenceTree(int levels, int fan) {
    std::string geometries;
    for (int level = 0; level < levels; ++level) {
        geometries += fmt::format(R"(<Geometry Name="{}">)", level == 0 ? "Base" : fmt::format("L{}", level));
        for (int i = 0; i < fan; ++i)
            geometries += fmt::format(R"(<GeometryReference Name="r{}" Geometry="L{}"/>)", i, level + 1);
        geometries += "</Geometry>";
    }
    return geometries + fmt::format(R"(<Beam Name="L{}"/>)", levels);
}

std::string functions(int count, int sets) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += fixtures::testing::functionXml(
            "Gobo1", fmt::format(R"(Name="F{}" DMXFrom="{}/1")", i, i % 256),
            repeated(R"(<ChannelSet Name="a rather long name of a set" DMXFrom="0/1"/>)",
                     static_cast<std::size_t>(sets)));
    }
    return text;
}

std::string png(int size, bool isNoisy) {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4);
    std::uint32_t random = 1;
    for (std::uint8_t& byte : rgba) {
        random = random * 1664525 + 1013904223;
        byte = isNoisy ? static_cast<std::uint8_t>(random >> 24) : 0x80;
    }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = static_cast<png_uint_32>(size);
    image.format = PNG_FORMAT_RGBA;
    png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string result(bytes, '\0');
    if (png_image_write_to_memory(&image, result.data(), &bytes, 0, rgba.data(), 0, nullptr) == 0)
        throw std::runtime_error(image.message);
    result.resize(bytes);
    return result;
}

/// A picture whose header says `width` x `height`, with nothing after it.
std::string lyingPng(std::uint32_t width, std::uint32_t height) {
    std::string picture = png(1, false);
    for (int i = 0; i < 4; ++i) {
        picture[16 + static_cast<std::size_t>(i)] = static_cast<char>(width >> (24 - 8 * i));
        picture[20 + static_cast<std::size_t>(i)] = static_cast<char>(height >> (24 - 8 * i));
    }
    // The checksum of the header is that of another one; libpng's readers only warn of some.
    return picture;
}

std::string packed(const std::string& content) {
    uLongf size = compressBound(content.size());
    std::string result(size, '\0');
    compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
              content.size(), Z_BEST_COMPRESSION);
    result.resize(size);
    return result;
}

/// A picture of one pixel with a further chunk `count` times.
std::string pngWith(const std::string& type, const std::string& content, std::size_t count) {
    constexpr std::size_t kBeforeChunks = 8 + 12 + 13;
    const auto number = [](std::size_t value) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
        return bytes;
    };
    const std::string named = type + content;
    const uLong checksum =
        crc32(0, reinterpret_cast<const Bytef*>(named.data()), static_cast<uInt>(named.size()));
    return png(1, false).insert(kBeforeChunks,
                                repeated(number(content.size()) + named + number(checksum), count));
}

std::string wheels(int pictures) {
    std::string slots;
    for (int i = 0; i < pictures; ++i) slots += fmt::format(R"(<Slot Name="s" MediaFileName="{}"/>)", i);
    return "<Wheels><Wheel Name=\"W\">" + slots + "</Wheel></Wheels>";
}

std::string gdtfWithFiles(const std::string& definitions, int count, std::string_view nameEnd,
                          const std::string& folder, const std::string& content) {
    Description description;
    description.definitions = definitions;
    description.channels = dimmer();
    Entries entries{{"description.xml", description.xml()}};
    for (int i = 0; i < count; ++i) entries.emplace_back(fmt::format("{}{}{}", folder, i, nameEnd), content);
    return zip(entries);
}

std::string gdtfOfPictures(int count, int size) {
    return gdtfWithFiles(wheels(count), count, ".png", "wheels/", png(size, false));
}

std::string models(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += fmt::format(R"(<Model Name="m{0}" File="{0}" Length="1" Width="1" Height="1"/>)", i);
    return "<Models>" + text + "</Models>";
}

// ---- Meshes

/// One object of this many vertices and faces, all of them in one place or on a line.
std::string mesh3ds(int vertices, int faces, bool isPoint) {
    std::string places = bytesOf<std::uint16_t>({static_cast<std::uint16_t>(vertices)});
    for (int i = 0; i < vertices; ++i) {
        const auto place = isPoint ? 1.0f : static_cast<float>(i);
        places += bytesOf<float>({place, place * place, 0.0f});
    }
    std::string list = bytesOf<std::uint16_t>({static_cast<std::uint16_t>(faces)});
    for (int i = 0; i < faces; ++i) {
        const auto corner = [&](int offset) { return static_cast<std::uint16_t>((i + offset) % vertices); };
        list += bytesOf<std::uint16_t>({corner(0), corner(1), corner(2), 7});
    }
    return chunk3ds(0x4100, chunk3ds(0x4110, places) + chunk3ds(0x4120, list));
}

std::string objects3ds(int count, int vertices, int faces, bool isPoint) {
    const std::string mesh = mesh3ds(vertices, faces, isPoint);
    std::string objects;
    for (int i = 0; i < count; ++i) objects += chunk3ds(0x4000, std::string("o\0", 2) + mesh);
    return file3ds(objects);
}

/// A glTF of which `nodes` show one mesh of `count` triangles; `extra` is more JSON of its root.
std::string fileGlb(int nodes, int count, const std::string& extra = "") {
    std::string list;
    std::string places;
    for (int i = 0; i < nodes; ++i) {
        list += fmt::format("{}{{\"mesh\":0}}", i == 0 ? "" : ",");
        places += fmt::format("{}{}", i == 0 ? "" : ",", i);
    }
    const int vertices = 3 * count;
    std::string buffer;
    for (int i = 0; i < vertices; ++i)
        buffer += bytesOf<float>({static_cast<float>(i % 3 == 1), static_cast<float>(i % 3 == 2), 2.0f});
    return test::glbOf(
        fmt::format(
            R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],)"
            R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],"buffers":[{{"byteLength":{}}}],)"
            R"("bufferViews":[{{"buffer":0,"byteLength":{}}}],"accessors":[{{"bufferView":0,"componentType":5126,)"
            R"("count":{},"type":"VEC3","min":[0,0,0],"max":[1,2,2]}}]{}}})",
            places, list, buffer.size(), buffer.size(), vertices, extra),
        buffer);
}

// ---- MVR

std::string sceneXml(const std::string& objects, const std::string& auxData = "") {
    return R"(<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><AUXData>)" + auxData +
           "</AUXData><Layers><Layer><ChildList>" + objects +
           "</ChildList></Layer></Layers></Scene></GeneralSceneDescription>";
}

std::string mvr(const std::string& objects, const std::string& auxData = "", Entries entries = {}) {
    entries.emplace_back("GeneralSceneDescription.xml", sceneXml(objects, auxData));
    return zip(entries);
}

/// `count` fixtures, each with the GDTF of its number modulo `types`.
std::string fixturesOf(int count, int types, const std::string& mode = "Mode") {
    std::string objects;
    for (int i = 0; i < count; ++i) {
        objects +=
            fmt::format(R"(<Fixture name="F"><GDTFSpec>{}.gdtf</GDTFSpec><GDTFMode>{}</GDTFMode></Fixture>)",
                        i % types, mode);
    }
    return objects;
}

std::string mvrOfGdtf(int fixtures, int types, const std::string& gdtf) {
    Entries entries;
    for (int i = 0; i < types; ++i) entries.emplace_back(fmt::format("{}.gdtf", i), gdtf);
    return mvr(fixturesOf(fixtures, types), "", std::move(entries));
}

std::string mvrOfMeshes(int count, std::string_view end, const std::string& mesh) {
    Entries entries;
    std::string objects = "<SceneObject><Geometries>";
    for (int i = 0; i < count; ++i) {
        const std::string name = fmt::format("{}{}", i, end);
        objects += fmt::format(R"(<Geometry3D fileName="{}"/>)", name);
        entries.emplace_back(name, mesh);
    }
    return mvr(objects + "</Geometries></SceneObject>", "", std::move(entries));
}

std::string symbols(int levels, int fan) {
    std::string text;
    for (int level = 0; level < levels; ++level) {
        text += fmt::format(R"(<Symdef uuid="{}"><ChildList>)", level);
        text += repeated(fmt::format(R"(<Symbol symdef="{}"/>)", level + 1), static_cast<std::size_t>(fan));
        text += "</ChildList></Symdef>";
    }
    return text +
           fmt::format(R"(<Symdef uuid="{}"><ChildList><Geometry3D fileName="a"/></ChildList></Symdef>)",
                       levels);
}

constexpr const char* kFirstSymbol =
    R"(<SceneObject><Geometries><Symbol symdef="0"/></Geometries></SceneObject>)";

/// A directory of entries that all name the same few bytes, which no writer of archives would make.
std::string zipOfManyEntries(std::uint32_t count) {
    std::string directory;
    for (std::uint32_t i = 0; i < count; ++i) {
        directory += "PK\1\2" + std::string(24, '\0') + bytesOf<std::uint16_t>({1, 0, 0, 0, 0}) +
                     bytesOf<std::uint32_t>({0, 0}) + "a";
    }
    const std::string local = "PK\3\4" + std::string(22, '\0') + bytesOf<std::uint16_t>({1, 0}) + "a";
    const auto start = static_cast<std::uint64_t>(local.size());
    const auto size = static_cast<std::uint64_t>(directory.size());
    const std::string end64 = "PK\6\6" + bytesOf<std::uint64_t>({44}) + bytesOf<std::uint16_t>({45, 45}) +
                              bytesOf<std::uint32_t>({0, 0}) +
                              bytesOf<std::uint64_t>({count, count, size, start});
    const std::string locator = "PK\6\7" + bytesOf<std::uint32_t>({0}) +
                                bytesOf<std::uint64_t>({start + size}) + bytesOf<std::uint32_t>({1});
    return local + directory + end64 + locator + "PK\5\6" + bytesOf<std::uint16_t>({0, 0, 0xFFFF, 0xFFFF}) +
           bytesOf<std::uint32_t>({0xFFFFFFFF, 0xFFFFFFFF}) + bytesOf<std::uint16_t>({0});
}

void appendGdtf(std::vector<HostileFile>& files) {
    files.push_back({"plain.gdtf", plainGdtf});
    files.push_back({"description_bomb.gdtf", [] { return gdtf(std::string(800 * kMiB, ' ')); }});
    files.push_back({"elements.gdtf", [] { return gdtf(repeated("<a/>", 15 * kMiB / 4)); }});
    files.push_back(
        {"attributes.gdtf", [] { return gdtf("<GDTF " + numbered("a{}=\"\" ", 1'400'000) + "/>"); }});
    files.push_back({"nested_elements.gdtf", [] { return gdtf(repeated("<a>", 15 * kMiB / 3)); }});
    files.push_back(
        {"entities.gdtf", [] { return gdtf("<GDTF a='" + repeated("&amp;", 3 * kMiB) + "'/>"); }});
    files.push_back({"modes.gdtf", [] { return gdtfOfGeometries("<Beam Name=\"Base\"/>", "", 80'000); }});
    files.push_back({"emitters.gdtf", [] {
                         return gdtfWithDefinitions(
                             "<PhysicalDescriptions><Emitters>" +
                             repeated(R"(<Emitter Name="x" Color="0.3,0.3,1"/>)", 350'000) +
                             "</Emitters></PhysicalDescriptions>");
                     }});
    files.push_back({"warnings.gdtf", [] {
                         return gdtfWithDefinitions("<PhysicalDescriptions><Emitters>" +
                                                    numbered(R"(<Emitter Name="x" Color="{}"/>)", 400'000) +
                                                    "</Emitters></PhysicalDescriptions>");
                     }});
    files.push_back({"geometries.gdtf", [] {
                         return gdtfOfGeometries("<Geometry Name=\"Base\">" +
                                                     repeated("<Beam Name=\"B\"/>", 19'000) + "</Geometry>",
                                                 dimmer("B"), 25);
                     }});
    files.push_back(
        {"references.gdtf", [] { return gdtfOfGeometries(referenceTree(3, 26), dimmer("L3"), 25); }});
    files.push_back({"channels.gdtf", [] {
                         return gdtfOfGeometries(
                             referenceTree(2, 63),
                             fixtures::testing::channelXml("L2", "1", "Gobo1", functions(60, 1)), 1);
                     }});
    files.push_back({"sets.gdtf", [] {
                         Description description;
                         description.channels =
                             fixtures::testing::channelXml("Beam", "1", "Gobo1", functions(1, 200'000));
                         return gdtfOf(description);
                     }});
    files.push_back({"masters.gdtf", [] {
                         Description description;
                         for (int i = 0; i < 4096; ++i) {
                             description.channels += fixtures::testing::channelXml(
                                 "Beam", "1", "Gobo1",
                                 fixtures::testing::functionXml(
                                     "Gobo1", R"(ModeMaster="Beam_Gobo1" ModeFrom="0/1" ModeTo="1/1")"));
                         }
                         return gdtfOf(description);
                     }});
    files.push_back({"facets.gdtf", [] {
                         return gdtfWithDefinitions(
                             "<Wheels><Wheel Name=\"W\">" +
                             repeated("<Slot>" + repeated("<Facet/>", 60) + "</Slot>", 7000) +
                             "</Wheel></Wheels>");
                     }});
    files.push_back({"big_pictures.gdtf", [] { return gdtfOfPictures(20, 4096); }});
    files.push_back({"pictures.gdtf", [] { return gdtfOfPictures(4000, 128); }});
    files.push_back({"broken_pictures.gdtf", [] {
                         return gdtfWithFiles(wheels(4000), 4000, ".png", "wheels/", lyingPng(4096, 4096));
                     }});
    files.push_back(
        {"picture_bombs.gdtf",
         [] { return gdtfWithFiles(wheels(60), 60, ".png", "wheels/", std::string(15 * kMiB, '\0')); }});
    files.push_back(
        {"text_bombs.gdtf", [] {
             const std::string text = std::string("k\0\0", 3) + packed(std::string(7 * kMiB, 'a'));
             return gdtfWithFiles(wheels(1000), 1000, ".png", "wheels/", pngWith("zTXt", text, 20));
         }});
    files.push_back(
        {"model_bombs.gdtf",
         [] { return gdtfWithFiles(models(60), 60, ".3ds", "models/3ds/", std::string(31 * kMiB, '\0')); }});
    files.push_back({"missing_models.gdtf",
                     [] { return gdtfWithFiles(models(90'000), 4000, "_other.3ds", "models/3ds/", "x"); }});
    files.push_back({"body_of_a_point.gdtf", [] {
                         Description description;
                         description.definitions = models(1);
                         description.channels = dimmer();
                         description.geometries = R"(<Beam Name="Base" Model="m0"/>)";
                         return zip({{"description.xml", description.xml()},
                                     {"models/3ds/0.3ds", objects3ds(1, 65535, 65535, true)}});
                     }});
    files.push_back({"many_bodies.gdtf", [] {
                         std::string geometries;
                         for (int i = 0; i < 100; ++i)
                             geometries += fmt::format(R"(<Geometry Name="g" Model="m{}"/>)", i);
                         Description description;
                         description.definitions = models(100);
                         description.geometries = "<Geometry Name=\"Base\">" + geometries + "</Geometry>";
                         Entries entries{{"description.xml", description.xml()}};
                         for (int i = 0; i < 100; ++i)
                             entries.emplace_back(fmt::format("models/3ds/{}.3ds", i),
                                                  objects3ds(1, 33'000, 33'000, false));
                         return zip(entries);
                     }});
    files.push_back({"entries.gdtf", [] { return zipOfManyEntries(1'000'000); }});
    files.push_back({"blank.gdtf", [] { return std::string(250 * kMiB, '\0'); }});
}

void appendMvr(std::vector<HostileFile>& files) {
    files.push_back({"plain.mvr", [] { return mvrOfGdtf(1, 1, plainGdtf()); }});
    files.push_back({"scene_bomb.mvr", [] {
                         return zip({{"GeneralSceneDescription.xml", std::string(800 * kMiB, ' ')}});
                     }});
    files.push_back({"elements.mvr", [] { return mvr(repeated("<a/>", 990'000)); }});
    files.push_back(
        {"long_text.mvr", [] { return mvr("<Fixture name='" + std::string(31 * kMiB, 'x') + "'/>"); }});
    files.push_back({"nested.mvr", [] { return mvr(repeated("<GroupObject><ChildList>", 400'000)); }});
    files.push_back({"objects.mvr", [] { return mvr(repeated("<SceneObject/>", 49'000)); }});
    files.push_back({"named_objects.mvr", [] {
                         return mvr(repeated("<SceneObject name='" + std::string(600, 'x') + "'/>", 49'000));
                     }});
    files.push_back({"fixtures_without_gdtf.mvr", [] { return mvr(repeated("<Fixture/>", 49'000)); }});
    files.push_back({"missing_gdtfs.mvr", [] { return mvr(fixturesOf(45'000, 45'000)); }});
    files.push_back({"meshes.mvr", [] {
                         return mvr("<SceneObject><Geometries>" +
                                    repeated("<Geometry3D fileName='a'/>", 490'000) +
                                    "</Geometries></SceneObject>");
                     }});
    files.push_back({"mesh_names.mvr", [] {
                         return mvr("<SceneObject><Geometries>" +
                                    numbered("<Geometry3D fileName='{}.3ds'/>", 450'000) +
                                    "</Geometries></SceneObject>");
                     }});
    files.push_back({"symbols.mvr", [] { return mvr(kFirstSymbol, symbols(15, 10)); }});
    files.push_back({"symbol_lists.mvr", [] { return mvr(kFirstSymbol, symbols(2, 690)); }});
    files.push_back({"commands.mvr", [] {
                         return mvr(
                             repeated("<Fixture><CustomCommands>" +
                                          repeated("<CustomCommand>A.Pan.Pan,f 1</CustomCommand>", 250) +
                                          "</CustomCommands></Fixture>",
                                      1300));
                     }});
    files.push_back({"many_entries.mvr", [] {
                         Entries entries;
                         for (int i = 0; i < 8000; ++i) entries.emplace_back(fmt::format("{}.bin", i), "");
                         return mvr("", "", std::move(entries));
                     }});
    files.push_back({"entries.mvr", [] { return zipOfManyEntries(1'000'000); }});
    files.push_back({"gdtf_bombs.mvr", [] { return mvrOfGdtf(9, 9, std::string(60 * kMiB, '\0')); }});
    files.push_back({"description_bombs.mvr", [] {
                         return mvrOfGdtf(500, 500,
                                          gdtf("<GDTF><FixtureType/></GDTF>" + std::string(15 * kMiB, ' ')));
                     }});
    files.push_back({"element_bombs.mvr", [] {
                         return mvrOfGdtf(
                             500, 500, gdtf("<GDTF><FixtureType/>" + repeated("<a/>", 200'000) + "</GDTF>"));
                     }});
    files.push_back({"reference_bombs.mvr", [] {
                         return mvrOfGdtf(500, 500, gdtfOfGeometries(referenceTree(3, 26), dimmer("L3"), 1));
                     }});
    files.push_back({"broken_gdtfs.mvr", [] { return mvrOfGdtf(8000, 8000, "x"); }});
    files.push_back({"small_gdtfs.mvr", [] { return mvrOfGdtf(8000, 8000, plainGdtf()); }});
    files.push_back({"picture_gdtfs.mvr", [] { return mvrOfGdtf(500, 500, gdtfOfPictures(1, 2000)); }});
    files.push_back(
        {"model_gdtfs.mvr", [] {
             return mvrOfGdtf(
                 500, 500, gdtfWithFiles(models(1), 1, ".3ds", "models/3ds/", std::string(10 * kMiB, '\0')));
         }});
    files.push_back({"large_fixtures.mvr", [] {
                         return mvrOfGdtf(20'000, 1, gdtfOfGeometries(referenceTree(3, 26), dimmer("L3"), 1));
                     }});
    files.push_back({"large_patch.mvr", [] {
                         return mvrOfGdtf(20'000, 1, gdtfOfGeometries(referenceTree(2, 22), dimmer("L2"), 1));
                     }});
    files.push_back({"points.mvr", [] { return mvrOfMeshes(4, ".3ds", objects3ds(1, 65535, 65535, true)); }});
    files.push_back(
        {"large_meshes.mvr", [] { return mvrOfMeshes(20, ".3ds", objects3ds(4, 60'000, 60'000, false)); }});
    files.push_back({"broken_meshes.mvr", [] { return mvrOfMeshes(8000, ".3ds", "x"); }});
    files.push_back({"small_meshes.mvr", [] { return mvrOfMeshes(8000, ".glb", fileGlb(1, 1)); }});
    files.push_back({"mesh_bombs.mvr", [] { return mvrOfMeshes(9, ".3ds", std::string(60 * kMiB, '\0')); }});
}

void appendMeshes(std::vector<HostileFile>& files) {
    files.push_back({"plain.3ds", [] { return objects3ds(1, 3, 1, false); }});
    files.push_back({"point.3ds", [] { return objects3ds(1, 65535, 65535, true); }});
    files.push_back({"line.3ds", [] { return objects3ds(30, 65535, 65535, false); }});
    files.push_back({"objects.3ds", [] { return objects3ds(400'000, 3, 1, false); }});
    files.push_back({"faces.3ds", [] { return objects3ds(100, 3, 65535, false); }});
    files.push_back(
        {"lying_vertices.3ds", [] {
             return file3ds(
                 chunk3ds(0x4000, std::string("o\0", 2) +
                                      chunk3ds(0x4100, chunk3ds(0x4110, bytesOf<std::uint16_t>({65535})))));
         }});
    files.push_back(
        {"nested.3ds", [] { return repeated(std::string("\x4D\x4D\xFF\xFF\xFF\x7F", 6), 5'000'000); }});
    files.push_back({"materials.3ds", [] {
                         return file3ds(
                             repeated(chunk3ds(0xAFFF, chunk3ds(0xA000, std::string("m\0", 2))), 2'000'000));
                     }});
    files.push_back({"plain.glb", [] { return fileGlb(1, 1); }});
    files.push_back({"nodes.glb", [] { return fileGlb(100'000, 100); }});
    files.push_back({"point.glb", [] { return fileGlb(1, 100'000); }});
    files.push_back({"nested.glb", [] { return test::glbOf(repeated("[", 10'000'000), ""); }});
    files.push_back(
        {"numbers.glb", [] { return fileGlb(1, 1, ",\"extras\":[" + repeated("0,", 15'000'000) + "0]"); }});
    files.push_back({"objects.glb", [] {
                         return fileGlb(1, 1, ",\"extras\":[" + repeated("{\"a\":1},", 3'000'000) + "0]");
                     }});
    files.push_back({"lying_count.glb", [] {
                         std::string glb = fileGlb(1, 1);
                         const std::size_t at = glb.find("\"count\":3,\"type\"");
                         return glb.replace(at, 16, "\"count\":4e8,\"i\":");
                     }});
}

void appendPictures(std::vector<HostileFile>& files) {
    files.push_back({"plain.png", [] { return png(16, true); }});
    files.push_back({"large.png", [] { return png(4096, false); }});
    files.push_back({"noisy.png", [] { return png(2000, true); }});
    files.push_back({"too_large.png", [] { return png(5000, false); }});
    files.push_back({"lying.png", [] { return lyingPng(0x7FFFFFFF, 0x7FFFFFFF); }});
}

}  // namespace

std::vector<HostileFile> hostileFiles() {
    std::vector<HostileFile> files;
    appendGdtf(files);
    appendMvr(files);
    appendMeshes(files);
    appendPictures(files);
    return files;
}

}  // namespace hazer::bench
