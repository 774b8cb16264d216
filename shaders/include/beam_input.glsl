// One beam as an instance; the C++ twin is render/gpu_beam.h.
//     row0..2  lamp space from view space (rotation), w: camera in lamp space [m]
//     light    peak intensity rgb [cd], w: distance apex - lens [m]
//     cone     cos and sin of the half angle of the cut, half angle of 50 % [rad], exponent (0: flat)
//     gobo     layer, cos and sin of the gobo's turn / tan(field half angle), 1 / focus distance [1/m] (< 0: sharp everywhere)
//     shadow   first record of its shadow faces (-1: none), surfaces: nearest, farthest, deepest below the apex [m]; lenses: where it faces, lamp space
//     lens     radius [m], row of the soft profile's rule (render/profile_rule.h; < 0: none; GOBO: tangent of what frost scatters), layer of the web (< 0: none; LINE: flux over peak [sr]), table of the gobo: twice its first layer, + 1 if it is coloured (< 0: none)
