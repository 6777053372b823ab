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

/// Whether two triangles have exactly the same three vertices, in any order.
bool sameVertices(Triangle x, Triangle y) {
    return (x.a == y.a && (x.b == y.b && x.c == y.c || x.b == y.c && x.c == y.b)) ||
           (x.a == y.b && (x.b == y.c && x.c == y.a || x.b == y.a && x.c == y.c)) ||
           (x.a == y.c && (x.b == y.a && x.c == y.b || x.b == y.b && x.c == y.a));
}
