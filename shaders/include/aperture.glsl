// What lets light through at a place of a beam's cross-section, of which the field is the unit disc (render/aperture.h). Compiled as GLSL and
// as C++. Edges are ramps of a width, half of it on either side.

// The share of light at a signed distance from an edge, above 0 on the open side.
Real throughEdge(Real distance, Real width) { return clamp(Real(0.5) + distance / max(width, Real(1e-6)), Real(0.0), Real(1.0)); }

// edge: a unit normal that points at the blade, and its distance from the middle.
Real throughBlade(Real2 place, Real3 edge, Real width) {
    return throughEdge(edge.z - edge.x * place.x - edge.y * place.y, width);
}

// Both sides of each pair of edges, so that a slit narrower than the ramp is dimmer, not wider.
Real throughSlit(Real place, Real halfSize, Real width) {
    return throughEdge(halfSize - place, width) + throughEdge(halfSize + place, width) - Real(1.0);
}

Real throughRectangle(Real2 place, Real2 halfSize, Real width) {
    return max(throughSlit(place.x, halfSize.x, width), Real(0.0)) * max(throughSlit(place.y, halfSize.y, width), Real(0.0));
}

// In the middle of a hole smaller than the ramp it is dimmer, as in a slit; nothing passes one that is shut.
Real throughIris(Real2 place, Real radius, Real width) {
    return radius > Real(0.0) ? max(throughSlit(length(place), radius, width), Real(0.0)) : Real(0.0);
}

// A place on a picture, of which the disc is the unit disc. turn: cos and sin of its rotation; disc: middle and radius.
Real2 onApertureImage(Real2 place, Real2 turn, Real3 disc) {
    Real x = (place.x - disc.x) / disc.z;
    Real y = (place.y - disc.y) / disc.z;
    return Real2(turn.x * x + turn.y * y, turn.x * y - turn.y * x);
}
