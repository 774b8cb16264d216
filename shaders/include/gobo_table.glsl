// Light through a gobo along a whole view ray with one look, from a table of line integrals: the gobo's Radon transform with Legendre
// moments, built by render/gobo_table.cpp. Compiled as GLSL and as C++. The equations: docs/rendering.md.
//
// On the gobo, where the field of the beam is the unit disc, a view ray is a straight line. Inside the table's disc it is a chord with
// xi = -1..1 from end to end. What the gobo lets through, T, has edges; the rest of the integrand, W, is smooth, and a cubic follows it:
//     integral T W dxi = sum c_k M_k,    M_k = integral T P_k dxi   (k = 0..3, P_k Legendre's polynomials)
// The M_k are the table. T holds the gobo, and the beam's soft profile as if tangents were angles, so that zoom changes nothing in it.
//
// Whoever includes this provides:
//     Real4 goboTableTexel(Real2 place, Real layer);   the table, bilinear; place in texels, the middle of the first is 0.5
// Needs beam_profile.glsl, beam_ray.glsl, beam_medium.glsl, gauss_legendre.glsl.

const int GOBO_TABLE_LEVELS = 8;
const int GOBO_TABLE_WIDTH = 1156;
const int GOBO_TABLE_HEIGHT = 260;

// Where a blur level lies in the table: first column and row, columns (turns of the line; one more repeats the first), rows (distance from
// the middle, the first is 0, the last the radius). Level l is as blurred as mip level l of the gobo's picture.
Real4 goboTableLevel(int level) {
    if (level == 0) return Real4(Real(0.0), Real(0.0), Real(512.0), Real(257.0));
    if (level == 1) return Real4(Real(513.0), Real(0.0), Real(512.0), Real(129.0));
    if (level < 4) return Real4(Real(257 * level - 1), Real(129.0), Real(256.0), Real(129.0));
    return Real4(Real(1027.0), Real(65 * (level - 4)), Real(level < 6 ? 128 : 64), Real(65.0));
}

// Radius of the table's disc. A flat beam ends at its field angle; a soft one reaches beyond, and so does a blurred gobo in it.
Real goboTableRadius(Real exponent) { return exponent > Real(0.0) ? Real(1.125) : Real(1.0); }

// The part of the profile that is in the table, at q = tan(psi) / tan(field half angle).
Real goboTableProfile(Real q, Real beamOverField, Real exponent) {
    return exponent > Real(0.0) ? softProfile(q, beamOverField, exponent) : Real(1.0);
}

// A view ray on the gobo.
struct GoboLine {
    Real turn;          // where the line's normal points, counter-clockwise from the gobo's +X, in turns: 0..1
    Real distance;      // from the middle, over the table's radius: 0..1
    Real2 middle;       // cos u and sin u at the point closest to the beam's axis, xi = 0
    Real endTangent;    // tangent of the angle at the lamp from there to xi = 1; below 0 where xi runs against the ray
};

// The line of a ray; false if it misses the table's disc. goboTurn: cos and sin of the gobo's turn, over tan(field half angle). The axis
// is (0, 0, -1).
bool goboLine(LampRay ray, Real2 goboTurn, Real exponent, OUT(GoboLine) line) {
    Real onAxis = sqrt(ray.axisAcross * ray.axisAcross + ray.axisAlong * ray.axisAlong);
    Real perTangent = length(goboTurn);
    Real radius = goboTableRadius(exponent) * onAxis / perTangent;
    line.turn = Real(0.0);
    line.distance = ray.axisNormal / max(radius, Real(1e-12));
    line.middle = Real2(Real(1.0), Real(0.0));
    line.endTangent = Real(0.0);
    if (line.distance >= Real(1.0)) return false;
    line.middle = Real2(ray.axisAcross, ray.axisAlong) / onAxis;
    // The line's point closest to the axis, and its direction: the ray's plane turned so that the latter is perpendicular to the axis.
    Real2 closest = Real2(ray.across.x, ray.across.y) * line.middle.x + Real2(ray.along.x, ray.along.y) * line.middle.y;
    Real2 along = Real2(ray.along.x, ray.along.y) * line.middle.x - Real2(ray.across.x, ray.across.y) * line.middle.y;
    // The normal (along.y, -along.x) points away from the middle: that decides which way xi runs.
    Real way = closest.x * along.y - closest.y * along.x < Real(0.0) ? Real(-1.0) : Real(1.0);
    Real2 normal = Real2(along.y, -along.x) * way;
    Real angle = atan(goboTurn.x * normal.y - goboTurn.y * normal.x, goboTurn.x * normal.x + goboTurn.y * normal.y);
    line.turn = angle / (Real(2.0) * PI);
    if (line.turn < Real(0.0)) line.turn += Real(1.0);
    line.endTangent = way * radius * sqrt((Real(1.0) - line.distance) * (Real(1.0) + line.distance));
    return true;
}

// The stretch of the ray on the chord, as s [m] (beam_ray.glsl): the table holds for a ray that is lit along all of it. False if an end is
// nowhere on the ray.
bool goboLineStretch(LampRay ray, GoboLine line, OUT(Real) sFrom, OUT(Real) sTo) {
    Real reach = abs(line.endTangent);
    Real cosFrom = line.middle.x + line.middle.y * reach;
    Real cosTo = line.middle.x - line.middle.y * reach;
    bool ahead = cosFrom > Real(0.0) && cosTo > Real(0.0);
    sFrom = ahead ? ray.h * (line.middle.y - line.middle.x * reach) / cosFrom : Real(0.0);
    sTo = ahead ? ray.h * (line.middle.y + line.middle.x * reach) / cosTo : Real(0.0);
    return ahead;
}

// The sample at xi; du/dxi > 0 comes back in `jacobian`.
LampSample goboLineSample(LampRay ray, GoboLine line, Real xi, Real apexToLensM, OUT(Real) jacobian) {
    Real tangent = xi * line.endTangent;
    Real cosine = Real(1.0) / sqrt(Real(1.0) + tangent * tangent);
    jacobian = abs(line.endTangent) * cosine * cosine;
    Real cosU = (line.middle.x - line.middle.y * tangent) * cosine;
    Real sinU = (line.middle.y + line.middle.x * tangent) * cosine;
    return lampSample(ray, cosU, sinU, apexToLensM);
}

// Where W is looked at lies within +-spread. A soft profile leaves little light near the ends of the chord: the cubic had better be true
// where the light is.
Real goboNodeSpread(Real exponent) { return exponent > Real(0.0) ? Real(0.8) : Real(1.0); }

// The four places xi at which W is wanted.
Real goboNode(int i, Real spread) { return spread * (Real(2.0) * gaussNode4(i) - Real(1.0)); }

// The c_k from W at goboNode(0..3): Legendre's expansion of the cubic through them.
Real4 goboCoefficients(Real4 values, Real spread) {
    // By Gauss-Legendre in y = xi / spread, b_k = (2k + 1) / 2 * sum w_j W_j P_k(y_j), with P_k at the outer and inner nodes.
    Real outer = values.x + values.w;
    Real inner = values.y + values.z;
    Real outerOdd = values.w - values.x;
    Real innerOdd = values.z - values.y;
    Real b0 = Real(0.17392742256872693) * outer + Real(0.32607257743127307) * inner;
    Real b1 = Real(0.44932565746768105) * outerOdd + Real(0.33257548547784642) * innerOdd;
    Real b2 = Real(0.53250804201891131) * (outer - inner);
    Real b3 = Real(0.37102700340194705) * outerOdd - Real(0.93977247037775312) * innerOdd;
    // As powers of xi, and back.
    Real p1 = (b1 - Real(1.5) * b3) / spread;
    Real p2 = Real(1.5) * b2 / (spread * spread);
    Real p3 = Real(2.5) * b3 / (spread * spread * spread);
    return Real4(b0 - Real(0.5) * b2 + p2 / Real(3.0), p1 + Real(0.6) * p3, p2 * Real(2.0 / 3.0), Real(0.4) * p3);
}

// The true profile at a sample over the one in the table: what W has of it. (The pedestal, 0.5 % of the peak, is left to the table.)
Real goboProfileRatio(BeamOptics optics, LampSample here, Real2 goboTurn) {
#ifdef FLAT_PROFILE
    return Real(1.0);
#else
    if (optics.exponent <= Real(0.0)) return Real(1.0);
    Real perTangent = length(goboTurn);
    Real fieldHalfAngle = atan(Real(1.0), perTangent);
    Real asTangent = here.sinAxis / here.cosAxis * perTangent * fieldHalfAngle / optics.beamHalfAngle;
    Real asAngle = atan(here.sinAxis, here.cosAxis) / optics.beamHalfAngle;
    return exp2(pow(asTangent, optics.exponent) - pow(asAngle, optics.exponent));
#endif
}

Real2 goboTablePlace(GoboLine line, int level) {
    Real4 at = goboTableLevel(level);
    return Real2(at.x + line.turn * at.z + Real(0.5), at.y + line.distance * (at.w - Real(1.0)) + Real(0.5));
}

// M_0..M_3 of a line in one layer of the table, blurred as a mip level of the gobo's picture.
Real4 goboMoments(GoboLine line, Real layer, int level) { return goboTableTexel(goboTablePlace(line, level), layer); }

// How blurred the gobo is along a line, as mip level of its picture: middle + slope xi, at least 0.
struct GoboBlur {
    Real middle;
    Real slope;
};

// integral T W dxi, from W at goboNode(0..3). Between two mip levels T is mixed in proportion: each level gets its share of W, so that the blur may
// change along the line. A grey gobo has one layer, a coloured one three: red, green, blue.
Real3 throughGobo(Real4 values, Real spread, GoboLine line, Real firstLayer, bool coloured, GoboBlur blur) {
    int level = clamp(int(blur.middle), 0, GOBO_TABLE_LEVELS - 2);
    Real4 blurrier;
    for (int i = 0; i < 4; ++i) {
        blurrier[i] = values[i] * clamp(blur.middle + blur.slope * goboNode(i, spread) - Real(level), Real(0.0), Real(1.0));
    }
    Real4 ofSharper = goboCoefficients(values - blurrier, spread);
    Real4 ofBlurrier = goboCoefficients(blurrier, spread);
    Real3 sum = Real3(Real(0.0));
    int channels = coloured ? 3 : 1;
    int channel = 0;
    do {
        Real layer = firstLayer + Real(channel);
        Real through = dot(ofSharper, goboMoments(line, layer, level)) + dot(ofBlurrier, goboMoments(line, layer, level + 1));
        sum = channel == 0 ? Real3(through) : channel == 1 ? Real3(sum.x, through, through) : Real3(sum.x, sum.y, through);
        ++channel;
    } while (channel < channels);
    return sum;
}
