// core/trace/view_cone.h in GLSL: where a ray in single mode ends.

#include "include/view_ray.glsl"

/// Nothing is hit before the first or after the second parameter.
vec2 partInView(Ray ray) {
    SeenSpan span;
    if (!clipToView(seenRay(0, ray), span)) return vec2(0.0, -1.0);
    precise double begin = span.begin * (1.0LF + kConeInset);
    precise double end = span.end * (1.0LF - kConeInset);
    return vec2(roundUp(begin), roundDown(end));
}
