#version 450 core
// The second part of FillDepth: the largest |coordinate| of a piece of the triangle buffer, as the
// bits of a float. Their order as integers is that of the floats, infinities and NaN come last.

layout(local_size_x = 256) in;
layout(std430, binding = 0) readonly buffer Triangles {
    float coordinates[];
};
layout(std430, binding = 1) buffer Largest {
    uint largest;
};
layout(location = 0) uniform uint count;

const uint kPerInvocation = 16u;

void main() {
    uint found = 0u;
    uint first = gl_WorkGroupID.x * gl_WorkGroupSize.x * kPerInvocation + gl_LocalInvocationID.x;
    for (uint i = 0u; i < kPerInvocation; ++i) {
        uint at = first + i * gl_WorkGroupSize.x;
        if (at < count) found = max(found, floatBitsToUint(coordinates[at]) & 0x7fffffffu);
    }
    if (found > largest) atomicMax(largest, found);
}
