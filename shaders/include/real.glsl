// The number types of the shared formulas. In C++ (render/glsl_as_cpp.h) they are float or double instead.
// Shared files keep to three rules: literals in Real(), no swizzles of more than one component, OUT(T) for results.
#define Real float
#define Real2 vec2
#define Real3 vec3
#define Real4 vec4
#define OUT(T) out T
#define INOUT(T) inout T
const float PI = 3.14159265358979;
