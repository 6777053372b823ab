// A ray for the search that is no path's: the host's, or a shadow ray.

struct RayRecord {
    vec3 origin;
    uint skip;
    vec3 direction;
    float maxT; // any hit: only those before it
};
