// The part of a view ray that a shadow map covers. Compiled as GLSL and as C++. Needs beam_ray.glsl.

// What a map shows, in the frame of its face (apex at the origin, looking along -Z): from nearM on, between tangents x / -z and y / -z.
struct ShadowWindow {
    Real nearM;
    Real lowX;
    Real lowY;
    Real highX;
    Real highY;
};

// Cuts a stretch to where start + s * along is not below 0.
void cutToPositive(Real start, Real along, INOUT(Real) sFrom, INOUT(Real) sTo) {
    if (along > Real(0.0)) {
        sFrom = max(sFrom, -start / along);
    } else if (along < Real(0.0)) {
        sTo = min(sTo, -start / along);
    } else if (start < Real(0.0)) {
        sTo = sFrom;
    }
}

// Cuts a stretch of the ray start + s * along [m] to the pyramid of a map: five half spaces, each linear in s. False if nothing is left.
bool cutToWindow(Real3 start, Real3 along, ShadowWindow window, INOUT(Real) sFrom, INOUT(Real) sTo) {
    cutToPositive(-start.z - window.nearM, -along.z, sFrom, sTo);
    cutToPositive(start.x + window.lowX * start.z, along.x + window.lowX * along.z, sFrom, sTo);
    cutToPositive(-start.x - window.highX * start.z, -along.x - window.highX * along.z, sFrom, sTo);
    cutToPositive(start.y + window.lowY * start.z, along.y + window.lowY * along.z, sFrom, sTo);
    cutToPositive(-start.y - window.highY * start.z, -along.y - window.highY * along.z, sFrom, sTo);
    return sFrom < sTo;
}

// A point or direction of the lamp's frame in the frame of a face: the twin of faceFromLamp in render/shadow_plan.h.
Real3 toShadowFace(Real3 v, int face) {
    if (face == 0) return v;
    if (face == 1) return Real3(v.z, v.y, -v.x);
    if (face == 2) return Real3(-v.z, v.y, v.x);
    if (face == 3) return Real3(v.x, v.z, -v.y);
    if (face == 4) return Real3(v.x, -v.z, v.y);
    return Real3(-v.x, v.y, -v.z);
}

// The face that looks where a direction points.
int shadowFaceOf(Real3 direction) {
    Real x = abs(direction.x);
    Real y = abs(direction.y);
    Real z = abs(direction.z);
    if (z >= x && z >= y) return direction.z <= Real(0.0) ? 0 : 5;
    if (x >= y) return direction.x > Real(0.0) ? 1 : 2;
    return direction.y > Real(0.0) ? 3 : 4;
}
