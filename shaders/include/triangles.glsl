// The triangle buffer, by primitive id.

layout(binding = 3) uniform samplerBuffer triangles; // three corners each

struct Triangle {
    vec3 a, b, c;
};

Triangle triangleOf(uint id) {
    int at = int(id) * 3;
    return Triangle(texelFetch(triangles, at).xyz, texelFetch(triangles, at + 1).xyz,
                    texelFetch(triangles, at + 2).xyz);
}
