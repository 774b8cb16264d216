// Where bodies stand in a beam's way: the parts of the ray that do not see the lamp, to be taken off what it would get without them. Compiled as
// GLSL and as C++.
//
// A shadow map sees the ray as a straight line, and its depth (one over the axial distance) is linear along that line, too: after two
// projections a look at any place costs one fetch and no division.
//
// Whoever includes this provides
//     Real3 shadePlace(Real3 pointM);    what a point (lamp space) is to the shadow map: straight lines stay straight
//     Real placeWeight(Real3 place);     how much shorter the map draws what is there, as 1 / axial distance; 1 if it does not
//     bool placeSeesLamp(Real3 place);   does it see the lamp?
// Needs beam_integral.glsl, with NOISE beam_density.glsl.

// A part of the ray that something may shade, seen by the shadow map, x = 0..1.
struct ShadeLine {
    Real sFrom;
    Real sTo;
    Real3 from;
    Real3 to;
    int bisections;  // of an interval at an edge of a shadow
};

ShadeLine makeShadeLine(LampRay ray, Real sFrom, Real sTo, int bisections) {
    Real3 closest = ray.across * ray.h;
    return ShadeLine(sFrom, sTo, shadePlace(closest + ray.along * sFrom), shadePlace(closest + ray.along * sTo), bisections);
}

bool seesLampFrom(ShadeLine line, Real x) { return placeSeesLamp(line.from + (line.to - line.from) * x); }

// x as s [m]: what is even on the map is not on the ray.
Real shadeLinePlace(ShadeLine line, Real x) {
    Real from = (Real(1.0) - x) * placeWeight(line.from);
    Real to = x * placeWeight(line.to);
    return (from * line.sFrom + to * line.sTo) / (from + to);
}

// An integer has marks for the ends of so many.
const int MOST_INTERVALS = 29;

// Into how many pieces a line of more intervals is cut.
int shadePieces(int intervals) { return max((intervals + MOST_INTERVALS - 1) / MOST_INTERVALS, 1); }

// One of even pieces of a line.
ShadeLine shadePiece(ShadeLine line, int piece, int pieces) {
    Real from = Real(piece) / Real(pieces);
    Real to = Real(piece + 1) / Real(pieces);
    Real3 way = line.to - line.from;
    return ShadeLine(shadeLinePlace(line, from), shadeLinePlace(line, to), line.from + way * from, line.from + way * to, line.bisections);
}

// Bit i: place i of an even division does not see the lamp. At most MOST_INTERVALS; with none, nothing is looked at.
int darkPlaces(ShadeLine line, int intervals) {
    Real apart = Real(1.0) / Real(max(intervals, 1));
    int dark = 0;
    int i = 0;
    // Two at a time; what that is beyond the last place does not count.
    do {
        dark |= seesLampFrom(line, Real(i) * apart) ? 0 : 1 << i;
        dark |= seesLampFrom(line, min(Real(i + 1) * apart, Real(1.0))) ? 0 : 2 << i;
        i += 2;
    } while (i <= intervals);
    return intervals > 0 ? dark & ((2 << intervals) - 1) : 0;
}

// As findLSB, which graphics drivers that have no instruction for it make slow; -127 if there is none. Bits are below the 30th.
int lowestBit(int bits) { return (floatBitsToInt(float(bits & -bits)) >> 23) - 127; }

// The first run of dark places, taken out of `dark`: from where to where, in x, its ends found by bisection. False if there is none.
bool nextDarkRun(ShadeLine line, int intervals, INOUT(int) dark, OUT(Real) from, OUT(Real) to) {
    Real apart = Real(1.0) / Real(max(intervals, 1));
    int first = lowestBit(dark);
    bool some = first >= 0;
    first = max(first, 0);
    int last = first + max(lowestBit(~(dark >> first)), 1) - 1;
    dark &= -(2 << last);
    // The ends take turns, one look at a time.
    Real lit = Real(max(first - 1, 0)) * apart;
    Real unlit = Real(first) * apart;
    Real nextLit = Real(min(last + 1, intervals)) * apart;
    Real nextUnlit = Real(last) * apart;
    int looks = some ? 2 * line.bisections : 1;
    int look = 0;
    do {
        Real middle = Real(0.5) * (lit + unlit);
        bool sees = seesLampFrom(line, middle);
        Real litHere = sees ? middle : lit;
        Real unlitHere = sees ? unlit : middle;
        lit = nextLit;
        unlit = nextUnlit;
        nextLit = litHere;
        nextUnlit = unlitHere;
        ++look;
    } while (look < looks);
    from = Real(0.5) * (lit + unlit);
    to = Real(0.5) * (nextLit + nextUnlit);
    return some;
}

// The integral over what is lit but for the bodies in the way, within sFrom..sTo [m]. With NOISE, uneven haze is looked at in `looks` places of the
// whole arc, three at least in each dark run: so that runs end where shadows do, not at the nearest look.
Real integrateDark(LampRay ray, BeamOptics optics, HazeMedium haze, Arc arc, Real sFrom, Real sTo, int intervals,
                   int bisections, Real looks) {
    ShadeLine line = makeShadeLine(ray, sFrom, sTo, bisections);
    int pieces = shadePieces(intervals);
    int each = (intervals + pieces - 1) / pieces;
    Real sum = Real(0.0);
    int piece = 0;
    do {
        ShadeLine part = shadePiece(line, piece, pieces);
        int dark = darkPlaces(part, each);
        do {
            Real from;
            Real to;
            bool some = nextDarkRun(part, each, dark, from, to);
            Real shareFrom = arcShare(arc, tangentAt(ray, shadeLinePlace(part, from)));
            Real shareTo = arcShare(arc, tangentAt(ray, shadeLinePlace(part, to)));
            Real run = Real(0.0);
            for (int i = 0; i < 4; ++i) {
                Real jacobian;
                LampSample here = arcSample(ray, arc, shareFrom + gaussNode4(i) * (shareTo - shareFrom), optics.apexToLensM, jacobian);
                run += gaussWeight4(i) * jacobian * beamKernel(here, optics, haze);
            }
#ifdef NOISE
            run *= densityOf(ray, optics, haze, arc, shareFrom, shareTo, some ? max(looks * (shareTo - shareFrom), Real(3.0)) : Real(1.0));
#endif
            sum += some ? run * (shareTo - shareFrom) : Real(0.0);
        } while (dark != 0);
        ++piece;
    } while (piece < pieces);
    return sum;
}
