// A view ray seen from a lamp, and the part of it that the beam lights. Compiled as GLSL and as C++.
//
// Frame: the virtual apex of the beam at the origin; the axis is the unit vector `axis`. Points on the ray are written
//     h e1 + s d,  s = h tan u,
// with h the distance of the ray from the apex, e1 the unit vector to its closest point, d the unit ray direction, and u the angle at the
// lamp. Over u the inverse-square law cancels: dt / r^2 = du / h (equi-angular substitution; Kulla and Fajardo 2012).
// Everything comes from the moment m = origin x d: a quadratic in t would lose all digits for narrow beams.

struct LampRay {
    Real h;        // distance apex - ray [m], > 0
    Real tClosest; // ray parameter of the closest point [m]
    Real3 across;  // e1
    Real3 along;   // d
    Real axisAcross;  // axis . e1
    Real axisAlong;   // axis . d
    Real axisNormal;  // |axis . n|, n = e1 x d
};

// origin: camera in the lamp's frame [m]; direction: unit.
LampRay lampRay(Real3 origin, Real3 direction, Real3 axis) {
    LampRay ray;
    Real3 moment = cross(origin, direction);
    Real h = length(moment);
    // A ray through the apex has no closest direction of its own; any perpendicular serves, a hair's breadth away.
    Real smallest = Real(1e-6) * length(origin) + Real(1e-9);
    if (h < smallest) {
        Real3 other = abs(direction.z) < Real(0.7) ? Real3(Real(0.0), Real(0.0), Real(1.0)) : Real3(Real(1.0), Real(0.0), Real(0.0));
        moment = normalize(cross(other, direction)) * smallest;
        h = smallest;
    }
    Real3 normal = moment / h;
    ray.h = h;
    ray.tClosest = -dot(origin, direction);
    ray.across = cross(direction, normal);
    ray.along = direction;
    ray.axisAcross = dot(axis, ray.across);
    ray.axisAlong = dot(axis, direction);
    ray.axisNormal = abs(dot(axis, normal));
    return ray;
}

// The stretch of the ray inside the cone of half angle below 90 degrees, as s [m]: true if there is one. Ends without limit are -limit
// and +limit. The mirrored cone behind the apex never appears.
bool coneInterval(LampRay ray, Real cosHalf, Real sinHalf, Real limit, OUT(Real) sFrom, OUT(Real) sTo) {
    sFrom = -limit;
    sTo = limit;
    Real discriminant = (sinHalf - ray.axisNormal) * (sinHalf + ray.axisNormal);
    if (discriminant <= Real(0.0)) return false;
    Real root = sqrt(discriminant);
    // Unit vectors (scaled) at u = uAxis -+ delta, tan delta = root / cosHalf, by rotating (axisAcross, axisAlong).
    Real cosFrom = ray.axisAcross * cosHalf + ray.axisAlong * root;
    Real sinFrom = ray.axisAlong * cosHalf - ray.axisAcross * root;
    Real cosTo = ray.axisAcross * cosHalf - ray.axisAlong * root;
    Real sinTo = ray.axisAlong * cosHalf + ray.axisAcross * root;
    bool axisAhead = ray.axisAcross > Real(0.0);  // |uAxis| < 90 degrees
    if (!axisAhead && ray.axisAlong > Real(0.0) && cosFrom <= Real(0.0)) return false;
    if (!axisAhead && ray.axisAlong <= Real(0.0) && cosTo <= Real(0.0)) return false;
    if (cosFrom > Real(0.0) && (axisAhead || ray.axisAlong > Real(0.0))) sFrom = max(ray.h * (sinFrom / cosFrom), -limit);
    if (cosTo > Real(0.0) && (axisAhead || ray.axisAlong <= Real(0.0))) sTo = min(ray.h * (sinTo / cosTo), limit);
    return sFrom < sTo;
}

// Keeps what lies in front of the lens: axial distance from the apex at least apexToLens [m].
void clipToLens(LampRay ray, Real apexToLens, INOUT(Real) sFrom, INOUT(Real) sTo) {
    Real missing = apexToLens - ray.h * ray.axisAcross;
    if (ray.axisAlong > Real(0.0)) {
        sFrom = max(sFrom, missing / ray.axisAlong);
    } else if (ray.axisAlong < Real(0.0)) {
        sTo = min(sTo, missing / ray.axisAlong);
    } else if (missing > Real(0.0)) {
        sTo = sFrom;
    }
}

// In thick haze only the near end of the lit stretch counts: cuts it where the light has fallen to 1e-5 of what it is at sFrom.
void clipToThickHaze(LampRay ray, Real extinctionPerM, Real sFrom, INOUT(Real) sTo) {
    if (extinctionPerM <= Real(0.0)) return;
    // t + r grows by ln(1e5) / extinction: sqrt(h^2 + s^2) + s = reach.
    Real reach = sqrt(ray.h * ray.h + sFrom * sFrom) + sFrom + Real(11.5) / extinctionPerM;
    if (reach <= Real(0.0)) return;
    sTo = min(sTo, Real(0.5) * (reach - ray.h * (ray.h / reach)));
}

// Half of the scattering angle phi = u + 90 degrees at a point of the ray, as an (unnormalised) vector: tan(phi / 2) = (r + s) / h.
Real2 halfScatterAngle(LampRay ray, Real s) {
    Real r = sqrt(ray.h * ray.h + s * s);
    return s > Real(0.0) ? Real2(ray.h, r + s) : Real2(r - s, ray.h);
}

// The angle at the lamp between two points of the ray [rad], in [0, pi).
Real angleBetween(LampRay ray, Real sFrom, Real sTo) {
    return atan(ray.h * (sTo - sFrom), ray.h * ray.h + sFrom * sTo);
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
    here.pathM = max(ray.tClosest + (ray.h * sinU + ray.h) / cosU - apexToLens / here.cosAxis, Real(0.0));
    return here;
}
