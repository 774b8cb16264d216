// Light through a gobo. Where a beam is crossed from side to side, one look at the gobo's table gives the integral; elsewhere, and where bodies
// stand in the way, the gobo is looked at in even cells along the line that the ray draws on it, with a cubic for all that is smooth.
// Needs beam_shade.glsl, gobo_table.glsl, gobo.glsl and the beam's input (beam_pixel.glsl).

// Rays that pass close by the lamp are the brightest and weigh most in the picture's error: the root of how much brighter they are than one a tenth
// of a radian beside it, 1..8.
float nearLamp(LampRay ray) {
    float lampPerH = sqrt(1.0 + ray.tClosest * ray.tClosest / (ray.h * ray.h));
    return clamp(sqrt(0.1 * lampPerH), 1.0, 8.0);
}

// What is smooth along a part of the line, as a cubic.
struct GoboCubic {
    float even0;
    float even2;
    float odd1;
    float odd3;
};

// Through values at the nodes of four-node Gauss-Legendre quadrature, in y = -1..1.
GoboCubic cubicThrough(vec4 values) {
    const float INNER = 0.33998104358485626;
    const float OUTER = 0.86113631159405258;
    const float PER_SQUARES = 1.0 / (OUTER * OUTER - INNER * INNER);
    float inner = 0.5 * (values.y + values.z);
    float outer = 0.5 * (values.x + values.w);
    float innerSlope = (values.z - values.y) * (0.5 / INNER);
    float outerSlope = (values.w - values.x) * (0.5 / OUTER);
    GoboCubic cubic;
    cubic.even2 = (outer - inner) * PER_SQUARES;
    cubic.even0 = inner - cubic.even2 * INNER * INNER;
    cubic.odd3 = (outerSlope - innerSlope) * PER_SQUARES;
    cubic.odd1 = innerSlope - cubic.odd3 * INNER * INNER;
    return cubic;
}

// How much the cubic leaves out, as a share of its mean: Legendre coefficients of what is smooth fall like powers, so that the fourth is to the
// mean as the second and third together, squared, are to the mean's square.
float cubicTail(GoboCubic cubic) {
    float mean = cubic.even0 + cubic.even2 / 3.0;
    float high = abs(cubic.even2) * (2.0 / 3.0) + abs(cubic.odd3) * 0.4;
    return high * high / max(mean * mean, 1e-30);
}

float cubicAt(GoboCubic cubic, float y) {
    float y2 = y * y;
    return cubic.even0 + cubic.even2 * y2 + y * (cubic.odd1 + cubic.odd3 * y2);
}

// xi of a place on the ray, s [m].
float goboXi(LampRay ray, GoboLine line, float s) {
    return (s * line.middle.x - ray.h * line.middle.y) / ((ray.h * line.middle.x + s * line.middle.y) * line.endTangent);
}

// What a ray meets on the gobo at a place of its line: where (the unit disc is the field), and how blurred it is looked at.
struct GoboTrace {
    vec2 closest;
    vec2 along;  // a unit of tangent further
};

vec2 onGobo(vec2 tangent) { return vec2(gobo.y * tangent.x + gobo.z * tangent.y, gobo.y * tangent.y - gobo.z * tangent.x); }

GoboTrace goboTrace(LampRay ray, GoboLine line) {
    float onAxis = inversesqrt(ray.axisAcross * ray.axisAcross + ray.axisAlong * ray.axisAlong);
    vec2 closest = ray.across.xy * line.middle.x + ray.along.xy * line.middle.y;
    vec2 along = ray.along.xy * line.middle.x - ray.across.xy * line.middle.y;
    return GoboTrace(onGobo(closest * onAxis), onGobo(along * onAxis));
}

// Blur at a place of the line, as mip level of the gobo's picture. `tangent` is that of the angle from the line's middle.
float goboLevel(LampRay ray, GoboLine line, float tangent) {
    float perDepth = 1.0 / (line.middle.x - line.middle.y * tangent);
    float axialM = ray.h * length(vec2(ray.axisAcross, ray.axisAlong)) * perDepth;
    float toEyeM = ray.tClosest + ray.h * (line.middle.y + line.middle.x * tangent) * perDepth;
    return log2(goboBlurTexels(axialM, pixelAngle() * toEyeM));
}

// How much of what the swirls of uneven haze hold beyond a cubic comes back, at most, in an integral through a gobo.
const float SWIRLS_SHARE = 0.35;

// A part of a pixel's line on its gobo, and what is smooth along it.
struct GoboPart {
    GoboLine line;
    GoboTrace trace;
    float xiFrom;
    float xiTo;
    GoboCubic smoothPart;  // in y = -1..1 from xiFrom to xiTo, over `spread`
    float spread;
    int cells;
    float cellLevel;  // mip level at which a texel is as long as what a look at a cell stands for
    float fieldTangent;
    float fieldHalfAngle;
    bool asTabled;    // profile as the table has it: smoothPart holds the ratio of the true one to it
    bool steep;       // the cubic does not follow: all is looked at in each cell
};

// What is smooth along the line, at xi: light that the haze scatters towards the eye per xi, but for gobo and profile.
float goboKernel(LampRay ray, BeamOptics optics, HazeMedium haze, GoboLine line, float xi, bool asTabled) {
    float jacobian;
    LampSample here = goboLineSample(ray, line, xi, optics.apexToLensM, jacobian);
    return jacobian * hazeKernel(here, haze) * (asTabled ? goboProfileRatio(optics, here, gobo.yz) : 1.0);
}

// Haze density at a place of the line, for looks that are `apart` from each other [m of tangent at the ray's distance].
float densityOnLine(LampRay ray, GoboLine line, float tangent, float apart) {
    float perDepth = 1.0 / (line.middle.x - line.middle.y * tangent);
    return densityAround(ray.tClosest + ray.h * (line.middle.y + line.middle.x * tangent) * perDepth, apart * perDepth * perDepth);
}

// Profile at a place on the gobo, of which the field is the unit disc.
float goboProfile(BeamOptics optics, GoboPart part, float place) {
    return softProfile(part.asTabled ? place * part.fieldHalfAngle : atan(place * part.fieldTangent), optics.beamHalfAngle, optics.exponent);
}

// Texels of a look over those of its cell: the means over squares that mip levels are hold more than the line, and less would leave gaps.
const float CELL_BLUR = 0.42;

vec3 goboCell(LampRay ray, BeamOptics optics, HazeMedium haze, GoboPart part, float y) {
    float xi = mix(part.xiFrom, part.xiTo, 0.5 + 0.5 * y);
    float tangent = xi * part.line.endTangent;
    vec2 place = part.trace.closest + part.trace.along * tangent;
    vec3 through = goboTexel(0.5 + 0.5 * vec2(place.x, -place.y), max(goboLevel(ray, part.line, tangent), part.cellLevel));
#if defined(WEB)
    through *= webAt(ray.across * (part.line.middle.x - part.line.middle.y * tangent) +
                     ray.along * (part.line.middle.y + part.line.middle.x * tangent));
#elif !defined(FLAT_PROFILE)
    through *= goboProfile(optics, part, length(place));
#endif
    float kernel = cubicAt(part.smoothPart, y / part.spread);
    // A loop, since it is loops alone that skip work where pixels are drawn in step.
    for (bool once = part.steep; once; once = false) {
        float apart = ray.h * abs(part.line.endTangent * (part.xiTo - part.xiFrom)) / float(part.cells);
        kernel = goboKernel(ray, optics, haze, part.line, xi, part.asTabled) * densityOnLine(ray, part.line, tangent, apart);
    }
    return through * kernel;
}

// The integral from one share of the part to another, 0..1: even cells, each in proportion to what of it lies between. At least one cell is
// looked at.
vec3 goboCells(LampRay ray, BeamOptics optics, HazeMedium haze, GoboPart part, float shareFrom, float shareTo) {
    float count = float(part.cells);
    float cell = floor(shareFrom * count);
    vec3 sum = vec3(0.0);
    do {
        float share = min(cell + 1.0, shareTo * count) - max(cell, shareFrom * count);
        sum += max(share, 0.0) * goboCell(ray, optics, haze, part, 2.0 * (cell + 0.5) / count - 1.0);
        cell += 1.0;
    } while (cell < shareTo * count);
    return sum * (abs(part.xiTo - part.xiFrom) / count);
}

#ifdef NOISE
// The haze's density along a part of the line, y = -1..1, as the cubic closest to even looks at it: what varies more slowly than the gobo's own
// edges. A gobo that lights but a part of the line meets the density of that part. Powers of y come back,
// and in `missed` the root mean square of what they leave out, which is perpendicular to them.
vec4 densityAlong(LampRay ray, GoboLine line, float xiFrom, float xiTo, out float missed) {
    vec4 sum = vec4(0.0);
    float squares = 0.0;
    float apart = ray.h * abs(line.endTangent * (xiTo - xiFrom)) / float(noiseNodes);
    int node = 0;
    do {
        float y = 2.0 * (float(node) + 0.5) / float(noiseNodes) - 1.0;
        float density = densityOnLine(ray, line, mix(xiFrom, xiTo, 0.5 + 0.5 * y) * line.endTangent, apart);
        squares += density * density;
        sum += density * vec4(1.0, y, y * y, y * y * y);
        ++node;
    } while (node < noiseNodes);
    vec4 means = sum / float(noiseNodes);
    vec4 powers = evenCubic(means, float(noiseNodes));
    missed = sqrt(max(squares / float(noiseNodes) - dot(powers, means), 0.0));
    return powers;
}
#endif

// The part of the line between two places of the ray, or all of it.
GoboPart goboPart(LampRay ray, BeamOptics optics, HazeMedium haze, GoboLine line, bool whole, float sFrom, float sTo, int cells, out vec4 values) {
    GoboPart part;
    part.line = line;
    part.trace = goboTrace(ray, line);
    part.xiFrom = whole ? -1.0 : clamp(goboXi(ray, line, sFrom), -1.0, 1.0);
    part.xiTo = whole ? 1.0 : clamp(goboXi(ray, line, sTo), -1.0, 1.0);
    part.spread = whole ? goboNodeSpread(optics.exponent) : 1.0;
    for (int i = 0; i < 4; ++i) {
        values[i] = goboKernel(ray, optics, haze, line, mix(part.xiFrom, part.xiTo, 0.5 + 0.5 * goboNode(i, part.spread)), whole);
    }
    GoboCubic cubic = cubicThrough(values);
    // What is steep at an end passes by the nodes.
    float steepEnd = values.w > values.x ? 1.0 : -1.0;
    float atEnd = goboKernel(ray, optics, haze, line, mix(part.xiFrom, part.xiTo, 0.5 + 0.5 * part.spread * steepEnd), whole);
    float missed = max(cubicTail(cubic), 0.1 * abs(cubicAt(cubic, steepEnd) - atEnd) / max(cubic.even0 + cubic.even2 / 3.0, 1e-30));
    float finer = clamp(sqrt(missed / goboTolerance), 1.0, 4.0);
#ifdef NOISE
    float xiMiddle = 0.5 * (part.xiFrom + part.xiTo);
    float xiReach = 0.5 * (part.xiTo - part.xiFrom) * part.spread;
    float swirlsMissed;
    vec4 swirls = densityAlong(ray, line, xiMiddle - xiReach, xiMiddle + xiReach, swirlsMissed);
    missed += SWIRLS_SHARE * swirlsMissed;
    for (int i = 0; i < 4; ++i) values[i] *= cubicPower(swirls, goboNode(i, 1.0));
#endif
    part.smoothPart = cubicThrough(values);
    part.fieldTangent = 1.0 / length(gobo.yz);
    part.fieldHalfAngle = atan(part.fieldTangent);
    part.asTabled = whole;
    // A part of the line has its edges where the light is.
    float near = nearLamp(ray);
    part.steep = missed * near * near > (whole ? 1.0 : 0.4) * goboTolerance;
    // Cells are as long as those of a chord through the middle, shorter where much changes along them.
    float length = 0.5 * abs(part.xiTo - part.xiFrom) * sqrt((1.0 - line.distance) * (1.0 + line.distance));
    float share = finer * (!whole ? 1.4 : part.steep ? 1.0 : 0.75);
    part.cells = clamp(int(ceil(float(cells) * length * share)), 4, 4 * cells);
    float cellTexels = goboTexels(abs((part.xiTo - part.xiFrom) * line.endTangent)) / float(part.cells);
    part.cellLevel = log2(CELL_BLUR * max(cellTexels, 1.0));
    return part;
}

// The integral over what is lit between two places of the ray [m]; `whole` if the ray crosses all of the beam. What does not see the lamp in
// `intervals` of the shade line is taken off.
vec3 integrateGobo(LampRay ray, BeamOptics optics, HazeMedium haze, bool whole, float sFrom, float sTo, int cells, ShadeLine shade,
                   int intervals) {
    GoboLine line;
    bool meets = goboLine(ray, gobo.yz, optics.exponent, line);
    vec4 values;
    // The table takes a blur that changes evenly along the line: enough unless the focus runs through it.
    float levelFrom = max(goboLevel(ray, line, -0.7 * line.endTangent), 0.0);
    float levelTo = max(goboLevel(ray, line, 0.7 * line.endTangent), 0.0);
    bool byTable = whole && lens.w >= 0.0 && abs(levelFrom - levelTo) < goboLevelsApart;
#ifdef WEB
    // A table holds the gobo alone, and a web is not smooth enough to be multiplied at four nodes.
    byTable = false;
#endif
    GoboPart part = goboPart(ray, optics, haze, line, byTable, sFrom, sTo, cells, values);
    byTable = byTable && !part.steep;
    vec3 sum = goboCells(ray, optics, haze, part, 0.0, byTable ? 0.0 : 1.0);
    int table = max(int(lens.w), 0);
    GoboBlur blur = GoboBlur(0.5 * (levelFrom + levelTo), (levelTo - levelFrom) / 1.4);
    vec3 tabled = throughGobo(values, part.spread, line, float(table / 2), table % 2 == 1, blur);
    sum = byTable ? tabled : sum;
#ifdef SHADOW
    int pieces = shadePieces(intervals);
    int each = (intervals + pieces - 1) / pieces;
    int piece = 0;
    do {
        ShadeLine stretch = shadePiece(shade, piece, pieces);
        int dark = darkPlaces(stretch, each);
        do {
            float darkFrom;
            float darkTo;
            bool some = nextDarkRun(stretch, each, dark, darkFrom, darkTo);
            float xiFrom = goboXi(ray, line, shadeLinePlace(stretch, darkFrom));
            float xiTo = goboXi(ray, line, shadeLinePlace(stretch, darkTo));
            vec2 shares = clamp((vec2(xiFrom, xiTo) - part.xiFrom) / (part.xiTo - part.xiFrom), 0.0, 1.0);
            // The table's line may run against the ray.
            float shareFrom = min(shares.x, shares.y);
            sum -= goboCells(ray, optics, haze, part, shareFrom, some ? max(shares.x, shares.y) : shareFrom);
        } while (dark != 0);
        ++piece;
    } while (piece < pieces);
#endif
    return meets ? max(sum, vec3(0.0)) : vec3(0.0);
}
