#include "app/demo_programme.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

namespace hazer::app {
namespace {

constexpr double kBeatS = 0.5;
constexpr double kBarS = 4.0 * kBeatS;

/// Sharp at 10 m from the lens, where most gobos meet a surface.
constexpr double kSpotFocus = 0.8;

/// How long a section takes to become the next one [s]. The new look is complete on its downbeat.
constexpr double kCrossfadeS = 1.5;

// Slots of the colour wheel that the moving spot and the moving beam share.
constexpr int kOpen = 1;
constexpr int kWarmWhite = 2;
constexpr int kRed = 3;
constexpr int kAmber = 4;
constexpr int kCyan = 6;
constexpr int kBlue = 7;
constexpr int kMagenta = 8;

// Slots of the moving spot's gobo wheel.
constexpr int kConeDots = 2;
constexpr int kTriangleFan = 3;
constexpr int kStars = 5;
constexpr int kBars = 6;
constexpr int kLeaves = 8;
constexpr int kSwirl = 10;
constexpr int kBurst = 11;

enum class Kind { kSpot, kBeam, kWash, kBlinder, kFresnel, kPar };

/// A fixture's place in its row.
struct Place {
    int index = 0;            ///< From 0, audience left to right.
    double across = 0.0;      ///< -1 audience left .. 1 audience right.
    bool isStanding = false;  ///< On the floor, and shines up at pan = tilt = 0.

    bool isOdd() const { return index % 2 == 1; }
    double alternating() const { return isOdd() ? -1.0 : 1.0; }
};

/// Levels 0..1 of the emitters of an LED fixture.
struct Emitters {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double white = 0.0;
};

constexpr Emitters kDeepBlue{0.02, 0.08, 1.0, 0.0};
constexpr Emitters kViolet{0.35, 0.0, 1.0, 0.0};
constexpr Emitters kPink{1.0, 0.05, 0.45, 0.05};
constexpr Emitters kOrange{1.0, 0.28, 0.0, 0.05};
constexpr Emitters kDeepRed{1.0, 0.02, 0.0, 0.0};
constexpr Emitters kTurquoise{0.0, 0.7, 0.75, 0.0};

/// What a fixture of any kind does; each kind uses what it has.
struct Look {
    double dimmer = 0.0;       ///< 0..1.
    double sideDeg = 0.0;      ///< How far the beam leans towards audience right.
    double forwardDeg = 10.0;  ///< How far it leans towards the audience. Above 0, or pan would turn over.
    double zoomDeg = 20.0;
    Emitters emitters{};
    double strobeHz = 0.0;  ///< 0: shutter open.
    int color = kOpen;      ///< Slot of the colour wheel.
    int gobo = kOpen;       ///< Slot of the gobo wheel.
    double goboSpeedDegPerS = 0.0;
};

// ---- rhythm ---------------------------------------------------------------------------------------------

double wave(double timeS, double periodS, double phaseTurns = 0.0) {
    return std::sin(glm::two_pi<double>() * (timeS / periodS + phaseTurns));
}

double smooth(double share) {
    const double s = std::clamp(share, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

int barAt(double timeS) {
    return static_cast<int>(std::floor(timeS / kBarS));
}

/// 1 on each multiple of `periodS`, then falling with the time constant `decayS`.
double hit(double timeS, double periodS, double decayS) {
    const double sinceS = timeS - periodS * std::floor(timeS / periodS);
    return std::exp(-sinceS / decayS);
}

/// The side lean that brings a row which reaches `halfWidthM` to either side together at the centre line,
/// `depthM` below or above it.
double sideTowardsCenterDeg(const Place& place, double halfWidthM, double depthM) {
    return -glm::degrees(std::atan(place.across * halfWidthM / depthM));
}

// ---- looks that several sections share ------------------------------------------------------------------

Look dark(const Place&, double) {
    return {};
}

Look washed(const Place& place, double dimmer, const Emitters& emitters, double zoomDeg = 45.0) {
    return {.dimmer = dimmer,
            .sideDeg = 12.0 * place.across,
            .forwardDeg = 32.0,
            .zoomDeg = zoomDeg,
            .emitters = emitters};
}

Look lit(double dimmer, const Emitters& emitters = {}) {
    return {.dimmer = dimmer, .emitters = emitters};
}

// ---- dawn: deep blue, light rises from the floor --------------------------------------------------------

Look dawnSpot(const Place& place, double timeS) {
    return {.dimmer = 0.35 + 0.5 * smooth(timeS / 3.0),
            .sideDeg = place.across * (14.0 + 8.0 * smooth(timeS / 4.0)),
            .forwardDeg = 42.0,
            .zoomDeg = 24.0,
            .color = kCyan,
            .gobo = kConeDots,
            .goboSpeedDegPerS = 25.0 * place.alternating()};
}

Look dawnBeam(const Place& place, double timeS) {
    if (!place.isStanding) return {.sideDeg = 20.0 * place.across, .forwardDeg = 30.0, .color = kBlue};
    return {.dimmer = 0.9,
            .sideDeg = place.across * (8.0 + 26.0 * smooth(timeS / 4.0)),
            .forwardDeg = 12.0,
            .color = kOpen};
}

Look dawnWash(const Place& place, double timeS) {
    return washed(place, 0.75 + 0.15 * wave(timeS, 4.0, 0.25 * place.across), kDeepBlue);
}

Look dawnFresnel(const Place&, double) {
    return lit(0.03);
}

Look dawnPar(const Place&, double) {
    return lit(0.5, kViolet);
}

// ---- crossing: spots sweep through each other, the chord changes every bar ------------------------------

struct Chord {
    int evenColor;
    int oddColor;
    Emitters wash;
};

constexpr std::array<Chord, 4> kChords{{{kMagenta, kCyan, kDeepBlue},
                                        {kAmber, kMagenta, kViolet},
                                        {kCyan, kAmber, kDeepBlue},
                                        {kAmber, kRed, kPink}}};

/// Before its section a look already has the chord of the first bar.
const Chord& chordAt(double timeS) {
    return kChords[static_cast<std::size_t>(std::max(barAt(timeS), 0)) % kChords.size()];
}

Look crossingSpot(const Place& place, double timeS) {
    const Chord& chord = chordAt(timeS);
    return {.dimmer = 1.0,
            .sideDeg = -38.0 * place.across * wave(timeS, 8.0, 0.08),
            .forwardDeg = 45.0 + 10.0 * wave(timeS, 4.0, 0.5 * std::abs(place.across)),
            .zoomDeg = 23.0,
            .color = place.isOdd() ? chord.oddColor : chord.evenColor,
            .gobo = place.isOdd() ? kTriangleFan : kBurst,
            .goboSpeedDegPerS = 50.0 * place.alternating()};
}

Look crossingBeam(const Place& place, double timeS) {
    // The upper row joins after two bars.
    const double dimmer = place.isStanding ? 0.9 : smooth((timeS - 3.5) / 0.5);
    return {.dimmer = dimmer,
            .sideDeg = place.across * (4.0 - 30.0 * wave(timeS, 8.0)),
            .forwardDeg = (place.isStanding ? 14.0 : 36.0) + 8.0 * wave(timeS, 4.0),
            .color = place.isStanding ? kOpen : kCyan};
}

Look crossingWash(const Place& place, double timeS) {
    return washed(place, 0.8, chordAt(timeS).wash);
}

Look crossingPar(const Place&, double timeS) {
    return lit(0.5, barAt(timeS) % 2 == 1 ? kPink : kViolet);
}

// ---- wave: one movement runs through all beams ----------------------------------------------------------

Look waveSpot(const Place& place, double timeS) {
    // A chase: one spot each half beat, audience left to right.
    return {.dimmer = 0.12 + 0.88 * hit(timeS - 0.5 * kBeatS * place.index, 3.0 * kBeatS, 0.35),
            .sideDeg = 24.0 * place.across,
            .forwardDeg = 48.0,
            .zoomDeg = 12.0,
            .color = kOpen,
            .gobo = kOpen};
}

Look waveBeam(const Place& place, double timeS) {
    const double phase = 0.14 * place.index + (place.isStanding ? 0.5 : 0.0);
    return {.dimmer = 1.0,
            .sideDeg = 14.0 * place.across,
            .forwardDeg = 34.0 + 24.0 * wave(timeS, 4.0, -phase),
            .color = barAt(timeS) < 2 ? kCyan : kMagenta};
}

Look waveWash(const Place& place, double timeS) {
    const Emitters& emitters = barAt(timeS) < 2 ? kTurquoise : kViolet;
    return washed(place, 0.35 + 0.4 * hit(timeS, kBarS, 0.8), emitters, 38.0);
}

Look wavePar(const Place& place, double timeS) {
    return lit(0.2 + 0.6 * hit(timeS - kBeatS * place.index, kBarS, 0.6), kDeepBlue);
}

// ---- ballad: warm, still, the band is seen --------------------------------------------------------------

Look balladSpot(const Place& place, double timeS) {
    return {.dimmer = 0.65,
            .sideDeg = 0.5 * sideTowardsCenterDeg(place, 4.5, 4.0),
            .forwardDeg = 30.0 + 4.0 * wave(timeS, 8.0),
            .zoomDeg = 30.0,
            .color = kWarmWhite,
            .gobo = place.isOdd() ? kLeaves : kStars,
            .goboSpeedDegPerS = 12.0 * place.alternating()};
}

Look balladBeam(const Place& place, double timeS) {
    if (!place.isStanding) return {.sideDeg = 20.0 * place.across, .forwardDeg = 30.0, .color = kAmber};
    return {.dimmer = 0.45,
            .sideDeg = 24.0 * place.across + 6.0 * wave(timeS, 8.0),
            .forwardDeg = 10.0,
            .color = kAmber};
}

Look balladWash(const Place& place, double timeS) {
    return washed(place, 0.5 + 0.1 * wave(timeS, 8.0), place.isOdd() ? kPink : kOrange, 55.0);
}

Look balladFresnel(const Place&, double) {
    return lit(0.55);
}

Look balladPar(const Place&, double) {
    return lit(0.45, kOrange);
}

// ---- drive: beat by beat --------------------------------------------------------------------------------

/// The last bar, which strobes.
bool isDriveEnd(double timeS) {
    return timeS >= 3.0 * kBarS;
}

Look driveSpot(const Place& place, double timeS) {
    const double share = hit(timeS - (place.isOdd() ? kBeatS : 0.0), 2.0 * kBeatS, 0.45);
    return {.dimmer = 0.2 + 0.8 * share,
            .sideDeg = 26.0 * place.across * wave(timeS, 4.0, 0.25),
            .forwardDeg = 46.0 + 14.0 * place.alternating() * wave(timeS, 2.0 * kBarS),
            .zoomDeg = 22.0,
            .color = place.isOdd() ? kOpen : kRed,
            .gobo = kSwirl,
            .goboSpeedDegPerS = 140.0 * place.alternating()};
}

Look driveBeam(const Place& place, double timeS) {
    const double phase = 0.25 * place.index;
    return {.dimmer = 1.0,
            .sideDeg = 20.0 * wave(timeS, 4.0, phase + 0.25),
            .forwardDeg = 34.0 + 19.0 * wave(timeS, 4.0, phase),
            .strobeHz = isDriveEnd(timeS) ? 8.0 : 0.0,
            .color = kOpen};
}

Look driveWash(const Place& place, double timeS) {
    const bool isTurn = (static_cast<int>(std::floor(timeS / kBeatS)) % 2 == 0) != place.isOdd();
    return washed(place, isTurn ? 0.9 : 0.35, kDeepRed, 40.0);
}

Look driveBlinder(const Place&, double timeS) {
    // A hit every second bar; the glow of tungsten takes a moment to fade.
    return lit(0.5 * hit(timeS, 2.0 * kBarS, 0.3));
}

Look driveFresnel(const Place&, double) {
    return lit(0.2);
}

Look drivePar(const Place&, double timeS) {
    return lit(0.3 + 0.5 * hit(timeS, kBeatS, 0.2), kDeepRed);
}

// ---- landing: everything meets over the singer ----------------------------------------------------------

Look landingSpot(const Place& place, double timeS) {
    return {.dimmer = 1.0 - 0.5 * smooth(timeS / 4.0),
            .sideDeg = sideTowardsCenterDeg(place, 4.5, 4.2),
            .forwardDeg = 30.0,
            .zoomDeg = 14.0,
            .color = kOpen,
            .gobo = kBars,
            .goboSpeedDegPerS = 20.0 * place.alternating()};
}

Look landingBeam(const Place& place, double timeS) {
    return {.dimmer = 0.9 - 0.4 * smooth(timeS / 4.0),
            .sideDeg = sideTowardsCenterDeg(place, 4.2, 4.2),
            .forwardDeg = place.isStanding ? 16.0 : 40.0,
            .color = kBlue};
}

Look landingBlinder(const Place&, double timeS) {
    return lit(0.5 * hit(timeS, kDemoLoopS, 0.5));
}

Look landingFresnel(const Place&, double timeS) {
    return lit(0.35 - 0.25 * smooth(timeS / 4.0));
}

// ---- the programme --------------------------------------------------------------------------------------

using LookFunction = Look (*)(const Place&, double sectionTimeS);

struct Section {
    double startS;
    std::array<LookFunction, 6> looks;  ///< In the order of Kind.
};

constexpr std::array<Section, 6> kSections{{
    {0.0, {dawnSpot, dawnBeam, dawnWash, dark, dawnFresnel, dawnPar}},
    {4.0, {crossingSpot, crossingBeam, crossingWash, dark, dawnFresnel, crossingPar}},
    {12.0, {waveSpot, waveBeam, waveWash, dark, dawnFresnel, wavePar}},
    {20.0, {balladSpot, balladBeam, balladWash, dark, balladFresnel, balladPar}},
    {28.0, {driveSpot, driveBeam, driveWash, driveBlinder, driveFresnel, drivePar}},
    {36.0, {landingSpot, landingBeam, dawnWash, landingBlinder, landingFresnel, dawnPar}},
}};

Emitters blended(const Emitters& from, const Emitters& to, double share) {
    return {std::lerp(from.red, to.red, share), std::lerp(from.green, to.green, share),
            std::lerp(from.blue, to.blue, share), std::lerp(from.white, to.white, share)};
}

/// Between two looks. Wheels cannot fade: where they differ, the light dips to black and they turn in the
/// dark.
Look blended(const Look& from, const Look& to, double share) {
    Look look = share < 0.5 ? from : to;
    const bool turnsWheel = from.color != to.color || from.gobo != to.gobo;
    const double dip = turnsWheel ? std::abs(1.0 - 2.0 * share) : 1.0;
    look.dimmer = dip * std::lerp(from.dimmer, to.dimmer, share);
    look.sideDeg = std::lerp(from.sideDeg, to.sideDeg, share);
    look.forwardDeg = std::lerp(from.forwardDeg, to.forwardDeg, share);
    look.zoomDeg = std::lerp(from.zoomDeg, to.zoomDeg, share);
    look.emitters = blended(from.emitters, to.emitters, share);
    return look;
}

Look lookAt(Kind kind, const Place& place, double timeS) {
    const double loopTimeS = timeS - kDemoLoopS * std::floor(timeS / kDemoLoopS);
    const auto next = std::find_if(kSections.begin(), kSections.end(),
                                   [&](const Section& section) { return section.startS > loopTimeS; });
    const Section& now = *std::prev(next);
    const bool wraps = next == kSections.end();
    const Section& following = wraps ? kSections.front() : *next;
    const double untilNextS = (wraps ? kDemoLoopS : next->startS) - loopTimeS;

    const auto look = static_cast<std::size_t>(kind);
    const Look current = now.looks[look](place, loopTimeS - now.startS);
    if (untilNextS >= kCrossfadeS) return current;
    return blended(current, following.looks[look](place, -untilNextS),
                   smooth(1.0 - untilNextS / kCrossfadeS));
}

// ---- from names to looks, and from looks to attributes --------------------------------------------------

struct Row {
    std::string_view kindName;
    Kind kind;
    int count;  ///< How many the demo show has.
};

constexpr std::array<Row, 6> kRows{{{"spot", Kind::kSpot, 6},
                                    {"beam", Kind::kBeam, 8},
                                    {"wash", Kind::kWash, 4},
                                    {"blinder", Kind::kBlinder, 2},
                                    {"fresnel", Kind::kFresnel, 4},
                                    {"par", Kind::kPar, 4}}};

Place placeInRow(int index, int count) {
    return {.index = index, .across = 2.0 * index / (count - 1.0) - 1.0};
}

Place placeOf(const Row& row, int index) {
    if (row.kind != Kind::kBeam) return placeInRow(index, row.count);
    // The second half of the beams stands on the deck, below the first half.
    const int half = row.count / 2;
    Place place = placeInRow(index % half, half);
    place.isStanding = index >= half;
    return place;
}

struct Role {
    Kind kind;
    Place place;
};

std::optional<Role> roleOf(std::string_view fixtureName) {
    for (const Row& row : kRows) {
        if (!fixtureName.starts_with(row.kindName)) continue;
        const std::string_view digits = fixtureName.substr(row.kindName.size());
        int number = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        const bool isWhole = error == std::errc() && end == digits.data() + digits.size();
        if (!isWhole || number < 1 || number > row.count) return std::nullopt;
        return Role{row.kind, placeOf(row, number - 1)};
    }
    return std::nullopt;
}

/// Pan and tilt that lean the beam as the look says: Rz(pan) Rx(tilt) turns -Z that way, and a fixture that
/// stands is turned over about its X axis.
void appendAim(const Look& look, bool isStanding, std::vector<AttributeValue>& values) {
    const double side = std::tan(glm::radians(look.sideDeg));
    const double forward = std::tan(glm::radians(look.forwardDeg));
    const double panDeg = glm::degrees(std::atan2(side, forward));
    const double tiltDeg = glm::degrees(std::atan(std::hypot(side, forward)));
    values.push_back({"Pan", isStanding ? -panDeg : panDeg});
    values.push_back({"Tilt", isStanding ? tiltDeg : -tiltDeg});
}

void appendShutter(const Look& look, std::vector<AttributeValue>& values) {
    const bool strobes = look.strobeHz > 0.0;
    values.push_back(strobes ? AttributeValue{"Shutter1Strobe", look.strobeHz}
                             : AttributeValue{"Shutter1", 1.0});
}

void appendEmitters(const Emitters& emitters, std::vector<AttributeValue>& values) {
    values.push_back({"ColorAdd_R", emitters.red});
    values.push_back({"ColorAdd_G", emitters.green});
    values.push_back({"ColorAdd_B", emitters.blue});
    values.push_back({"ColorAdd_W", emitters.white});
}

void appendSpot(const Look& look, std::vector<AttributeValue>& values) {
    values.push_back({"Zoom", look.zoomDeg});
    values.push_back({"Focus1", kSpotFocus});
    values.push_back({"Color1", static_cast<double>(look.color)});
    values.push_back({"Gobo1", static_cast<double>(look.gobo)});
    values.push_back({"Gobo1PosRotate", look.goboSpeedDegPerS});
}

bool isMovingHead(Kind kind) {
    return kind == Kind::kSpot || kind == Kind::kBeam || kind == Kind::kWash;
}

bool hasEmitters(Kind kind) {
    return kind == Kind::kWash || kind == Kind::kPar;
}

}  // namespace

std::vector<AttributeValue> demoLook(std::string_view fixtureName, double timeS) {
    const std::optional<Role> role = roleOf(fixtureName);
    if (!role) return {};
    const Look look = lookAt(role->kind, role->place, timeS);
    std::vector<AttributeValue> values{{"Dimmer", look.dimmer}};
    if (isMovingHead(role->kind)) appendAim(look, role->place.isStanding, values);
    if (isMovingHead(role->kind) || hasEmitters(role->kind)) appendShutter(look, values);
    if (hasEmitters(role->kind)) appendEmitters(look.emitters, values);
    if (role->kind == Kind::kSpot) appendSpot(look, values);
    if (role->kind == Kind::kBeam) values.push_back({"Color1", static_cast<double>(look.color)});
    if (role->kind == Kind::kWash) values.push_back({"Zoom", look.zoomDeg});
    return values;
}

void writeDemoLook(const fixtures::Fixture& fixture, double timeS, std::span<std::uint8_t> slots) {
    for (const AttributeValue& value : demoLook(fixture.name(), timeS)) {
        fixture.encode(value.attribute, value.value, slots);
    }
}

}  // namespace hazer::app
