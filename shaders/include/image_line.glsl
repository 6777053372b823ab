// The part of a ray in one view as a line in its image, in float: 1/w changes along it as evenly as
// the column and the row do, so that a step of the walk takes no division. Of trace_fast.comp, which
// promises nothing: errors are bounded by where they come from, not to the last bit.

#include "include/views.glsl"

/// Part of 1/w that it may be off by, or of what it is at the line's beginning where that is more:
/// some roundings of 2^-24.
const float kNearnessError = 1e-6;

/// Lengths of a line by which the place of a hit may be off, or more where the line is longer than
/// it is deep. Too much costs steps; too little loses hits.
const float kPlaceError = 1e-5;

/// A ray o + t d as homogeneous points (1 - s) o + s d, s = t / (1 + t) from 0 to 1, in the frame of
/// the view. The direction is scaled to size 1, so that what is in the scene is well within s.
struct ImageLine {
    vec2 from, along;       // column and row at its beginning; from there to its end
    vec2 perTile;           // parts of the line between two columns, and two rows; 0: it meets none
    ivec2 step;             // to the next column and row
    float nearness, change; // 1/w at its beginning; from there to its end
    float begin, end;       // s
    float wBegin, wEnd;     // of the homogeneous points there
    int side;               // through which it leaves: +x, +y, -x, -y; -1: it does not
};

/// False if there is no such part.
bool lineInView(int view, vec3 origin, vec3 direction, out ImageLine line) {
    vec3 a = toView(view, origin), b = toView(view, direction);
    vec2 rim = grid.tilesOfSlope.zw / grid.tilesOfSlope.xy;
    vec4 insideA = vec4(rim * a.z - a.xy, rim * a.z + a.xy);
    vec4 insideB = vec4(rim * b.z - b.xy, rim * b.z + b.xy);
    vec4 crossing = insideA / (insideA - insideB);
    line.begin = 1e-20; // from the eye a ray has its direction's place
    line.end = 1.0;
    line.side = -1;
    for (int side = 0; side < 4; ++side) {
        bool begins = insideA[side] >= 0.0, ends = insideB[side] >= 0.0;
        if (!begins && !ends) return false;
        if (!begins) line.begin = max(line.begin, crossing[side]);
        if (!ends && crossing[side] < line.end) {
            line.end = crossing[side];
            line.side = side;
        }
    }
    vec3 p = mix(a, b, line.begin), q = mix(a, b, line.end);
    if (line.begin > line.end || !(p.z > 0.0)) return false;
    line.wBegin = p.z;
    line.wEnd = q.z;
    line.from = p.xy / p.z * grid.tilesOfSlope.xy + grid.tilesOfSlope.zw;
    line.nearness = (1.0 - line.begin) / p.z;
    // At the end of a ray that goes to the eye the place is that of its beginning.
    vec2 to = line.from;
    float nearnessEnd = 1e30;
    if (q.z > 0.0) {
        to = q.xy / q.z * grid.tilesOfSlope.xy + grid.tilesOfSlope.zw;
        nearnessEnd = (1.0 - line.end) / q.z;
    }
    line.along = to - line.from;
    line.step = ivec2(sign(line.along));
    line.perTile = mix(1.0 / line.along, vec2(0.0), equal(line.step, ivec2(0)));
    line.change = nearnessEnd - line.nearness;
    return true;
}

/// Where parameter \p t of the ray is on the line: 0 and 1 at its ends, and beyond.
float placeOf(ImageLine line, float t) {
    float part = (t / (1.0 + t) - line.begin) / (line.end - line.begin);
    float near = (1.0 - part) * line.wBegin, far = part * line.wEnd;
    return t >= 3e38 || !(near + far > 0.0) ? 2.0 : far / (near + far);
}

/// 1/w between two places on the line: the least and the greatest.
vec2 nearnessBetween(ImageLine line, float from, float to) {
    float a = line.nearness + from * line.change, b = line.nearness + to * line.change;
    float least = min(a, b), most = max(a, b);
    return vec2(least - kNearnessError * max(least, line.nearness),
                most + kNearnessError * max(most, line.nearness));
}

/// The view behind the side through which a line leaves a cube's face (core/grid/view.h: for axis a
/// w is ±p[a], x is p[a + 1], y is p[a + 2]).
int viewBehind(int view, int side) {
    int axis = (view / 2 + 1 + side % 2) % 3;
    return 2 * axis + side / 2;
}
