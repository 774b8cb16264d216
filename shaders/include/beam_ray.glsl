// A view ray seen from a lamp, and the part of it that the beam lights. Compiled as GLSL and as C++.
//
// Frame: the virtual apex of the beam at the origin; the axis is the unit vector `axis`. Points on the ray are written
//     h e1 + s d,  s = h tan u,
// with h the distance of the ray from the apex, e1 the unit vector to its closest point, d the unit ray direction, and u the angle at the
// lamp. Over u the inverse-square law cancels: dt / r^2 = du / h (equi-angular substitution; Kulla and Fajardo 2012).
// Everything comes from the moment m = origin x d: a quadratic in t would lose all digits for narrow beams.
//
// Places on the ray are told as s [m], or as T = tan(phi / 2), phi = u + 90 degrees the angle by which the light is scattered towards the eye:
// T = (r + s) / h with r the distance from the apex, from 0 to infinity along the ray.

struct LampRay {
    Real h;        // distance apex - ray [m], > 0
    Real tClosest; // ray parameter of the closest point [m]
    Real3 across;  // e1
    Real3 along;   // d
    Real axisAcross;  // axis . e1
    Real axisAlong;   // axis . d
    Real axisNormal;  // |axis . n|, n = e1 x d
};

// origin: camera in the lamp's frame [m]; direction: of any length but 0.
LampRay lampRay(Real3 origin, Real3 direction, Real3 axis) {
    Real3 moment = cross(origin, direction);
    Real direction2 = dot(direction, direction);
    // A ray through the apex has no closest direction of its own; any perpendicular serves, a hair's breadth away.
    Real smallest = Real(1e-6) * length(origin) + Real(1e-9);
    bool slanted = direction.z * direction.z < Real(0.5) * direction2;
    Real3 other = slanted ? Real3(-direction.y, direction.x, Real(0.0)) : Real3(Real(0.0), -direction.z, direction.y);
    moment = dot(moment, moment) < smallest * smallest * direction2 ? other * smallest : moment;
    Real moment2 = dot(moment, moment);
    Real perDirection = inversesqrt(direction2);
    Real perMoment = inversesqrt(moment2);
    Real3 normal = moment * perMoment;
    LampRay ray;
    ray.h = moment2 * perMoment * perDirection;
    ray.tClosest = -dot(origin, direction) * perDirection;
    ray.along = direction * perDirection;
    ray.across = cross(ray.along, normal);
    ray.axisAcross = dot(axis, ray.across);
    ray.axisAlong = dot(axis, ray.along);
    ray.axisNormal = abs(dot(axis, normal));
    return ray;
}

Real tangentAt(LampRay ray, Real s) {
    Real r = sqrt(ray.h * ray.h + s * s);
    return (s > Real(0.0) ? r + s : ray.h) / (s > Real(0.0) ? ray.h : r - s);
}

Real placeAt(LampRay ray, Real tangent) { return Real(0.5) * ray.h * (tangent - Real(1.0) / tangent); }

// T of a direction in the ray's plane, length * (cos u, sin u) with |u| < 90 degrees.
Real tangentTowards(Real cosU, Real sinU, Real length) {
    return (sinU > Real(0.0) ? length + sinU : cosU) / (sinU > Real(0.0) ? cosU : length - sinU);
}

// Where a cone reaches to infinity along the ray.
const Real FARTHEST_TANGENT = Real(1e9);

// The part of the ray inside the cone of half angle below 90 degrees: false if there is none. Ends without limit are 0 and
// FARTHEST_TANGENT. The mirrored cone behind the apex never appears.
bool coneTangents(LampRay ray, Real cosHalf, Real sinHalf, OUT(Real) from, OUT(Real) to) {
    Real discriminant = (sinHalf - ray.axisNormal) * (sinHalf + ray.axisNormal);
    Real root = sqrt(max(discriminant, Real(0.0)));
    // Vectors at u = uAxis -+ delta, tan delta = root / cosHalf, by rotating (axisAcross, axisAlong); both have this length.
    Real length = ray.axisAcross * ray.axisAcross + ray.axisAlong * ray.axisAlong;
    Real cosFrom = ray.axisAcross * cosHalf + ray.axisAlong * root;
    Real sinFrom = ray.axisAlong * cosHalf - ray.axisAcross * root;
    Real cosTo = ray.axisAcross * cosHalf - ray.axisAlong * root;
    Real sinTo = ray.axisAlong * cosHalf + ray.axisAcross * root;
    bool ahead = ray.axisAcross > Real(0.0);  // |uAxis| < 90 degrees
    bool rising = ray.axisAlong > Real(0.0);
    from = cosFrom > Real(0.0) && (ahead || rising) ? tangentTowards(cosFrom, sinFrom, length) : Real(0.0);
    to = cosTo > Real(0.0) && (ahead || !rising) ? tangentTowards(cosTo, sinTo, length) : FARTHEST_TANGENT;
    return discriminant > Real(0.0) && (ahead || (rising ? cosFrom : cosTo) > Real(0.0));
}

// Keeps what lies in front of the lens: axial distance from the apex at least apexToLens [m].
void clipToLens(LampRay ray, Real apexToLens, INOUT(Real) sFrom, INOUT(Real) sTo) {
    Real missing = apexToLens - ray.h * ray.axisAcross;
    Real place = missing / ray.axisAlong;
    if (ray.axisAlong > Real(0.0)) sFrom = max(sFrom, place);
    if (ray.axisAlong < Real(0.0)) sTo = min(sTo, place);
    if (ray.axisAlong == Real(0.0) && missing > Real(0.0)) sTo = sFrom;
}

// What a sample needs to know. The angle is told as cos u and sin u, which stay exact near +-90 degrees.
struct LampSample {
    Real3 direction;   // unit, from the apex
    Real cosAxis;      // cosine of the angle psi from the axis
    Real sinAxis;
    Real distanceM;    // r, from the apex
    Real cosScatter;   // between the light's way and the way to the eye
    Real pathM;        // lens to sample to eye
};

LampSample lampSample(LampRay ray, Real cosU, Real sinU, Real apexToLens) {
    LampSample here;
    here.direction = ray.across * cosU + ray.along * sinU;
    here.cosAxis = ray.axisAcross * cosU + ray.axisAlong * sinU;
    Real side = ray.axisAlong * cosU - ray.axisAcross * sinU;
    here.sinAxis = sqrt(ray.axisNormal * ray.axisNormal + side * side);
    here.distanceM = ray.h / cosU;
    here.cosScatter = -sinU;
    // t + r is one sum before it meets the exponential: exp(-a) exp(-b) overflows for a lamp behind the camera.
    Real fromApexToLens = apexToLens > Real(0.0) ? apexToLens / here.cosAxis : Real(0.0);
    here.pathM = max(ray.tClosest + (ray.h * sinU + ray.h) / cosU - fromApexToLens, Real(0.0));
    return here;
}

// The sample at T = at.y / at.x, `at` of any length, without a square root and with one division for all that the light needs:
// cos u = 2 T / (1 + T^2), sin u = (T^2 - 1) / (1 + T^2), t + r = tClosest + h T. 1 / |at|^2 comes back, too.
LampSample lampSampleAt(LampRay ray, Real2 at, Real apexToLens, OUT(Real) perSquare) {
    Real square = at.x * at.x + at.y * at.y;
    Real ahead = Real(2.0) * at.x * at.y;
    Real up = at.y * at.y - at.x * at.x;
    Real axial = ray.axisAcross * ahead + ray.axisAlong * up;
    Real divisor = apexToLens > Real(0.0) ? axial : Real(1.0);
    Real inverse = Real(1.0) / (square * at.x * divisor);
    perSquare = inverse * at.x * divisor;
    Real cosU = ahead * perSquare;
    Real sinU = up * perSquare;
    LampSample here;
    here.direction = ray.across * cosU + ray.along * sinU;
    here.cosAxis = axial * perSquare;
    Real side = ray.axisAlong * cosU - ray.axisAcross * sinU;
    here.sinAxis = sqrt(ray.axisNormal * ray.axisNormal + side * side);
    here.distanceM = ray.h / cosU;
    here.cosScatter = -sinU;
    here.pathM = max(ray.tClosest + ray.h * at.y * (inverse * square * divisor) - apexToLens * square * (inverse * square * at.x), Real(0.0));
    return here;
}
