// The tables of gobos as a texture.
uniform sampler2DArray goboTables;

vec4 goboTableTexel(vec2 place, float layer);

#include "include/gobo_table.glsl"

vec4 goboTableTexel(vec2 place, float layer) {
    return textureLod(goboTables, vec3(place / vec2(GOBO_TABLE_WIDTH, GOBO_TABLE_HEIGHT), layer), 0.0);
}
