// A ray, and where it hits a triangle.

struct Ray {
    vec3 origin, direction;
    uint skip;
};

struct TriangleHit {
    float t, u, v;
};
