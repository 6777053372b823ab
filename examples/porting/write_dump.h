// What an engine writes out for `dirt replay`; docs/porting.md shows it.
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <iomanip>
#include <string>
#include <tuple>
#include <vector>

/// Stands for an engine: what its passes left, read back.
struct Engine {
    struct Tile {
        float near, far; ///< depth bounds; near above far where there is nothing
        std::vector<std::vector<uint32_t>> bins; ///< triangle ids
    };
    struct Hit {
        uint32_t triangle; ///< 4294967295: none
        float t, u, v;
    };
    int tiles = 0;                               ///< along a view
    std::vector<std::array<float, 9>> triangles; ///< a, b and c
    std::array<std::vector<Tile>, 6> views;      ///< row-major
    std::vector<std::array<float, 6>> rays;      ///< origin and direction, one a pixel
    std::vector<Hit> hits;
    std::vector<std::array<float, 7>> shadowRays; ///< origin, direction, and t of the light
    std::vector<bool> occluded;                   ///< of each
};

//! write
template <class... Values>
void line(std::ostream& out, const Values&... values) {
    const char* comma = "";
    ((out << comma << values, comma = ","), ...);
    out << '\n';
}

inline void writeDump(const Engine& engine, const std::string& folder) {
    const auto open = [&](const char* file, const char* names) {
        std::ofstream out(folder + "/" + file);
        out << std::setprecision(9) << names << '\n';
        return out;
    };
    auto triangles = open("triangles.csv", "a.X,a.Y,a.Z,b.X,b.Y,b.Z,c.X,c.Y,c.Z");
    for (const auto& t : engine.triangles) std::apply([&](auto... x) { line(triangles, x...); }, t);
    auto depth = open("depth.csv", "view,level,column,row,near,far");
    auto ids = open("ids.csv", "view,column,row,bin,id");
    for (size_t view = 0; view < 6; ++view)
        for (int i = 0; i < engine.tiles * engine.tiles; ++i) {
            const Engine::Tile& tile = engine.views[view][(size_t) i];
            const int column = i % engine.tiles, row = i / engine.tiles;
            line(depth, view, 0, column, row, tile.near, tile.far);
            for (size_t bin = 0; bin < tile.bins.size(); ++bin)
                for (const uint32_t id : tile.bins[bin]) line(ids, view, column, row, bin, id);
        }
    auto rays =
        open("rays.1.csv", "origin.X,origin.Y,origin.Z,direction.X,direction.Y,direction.Z");
    for (const auto& ray : engine.rays) std::apply([&](auto... x) { line(rays, x...); }, ray);
    auto hits = open("hits.1.csv", "primitive,t,u,v");
    for (const Engine::Hit& hit : engine.hits) line(hits, hit.triangle, hit.t, hit.u, hit.v);
    auto shadows =
        open("shadowrays.1.csv",
             "origin.X,origin.Y,origin.Z,direction.X,direction.Y,direction.Z,tMax,occluded");
    for (size_t i = 0; i < engine.shadowRays.size(); ++i)
        std::apply([&](auto... x) { line(shadows, x..., (bool) engine.occluded[i]); },
                   engine.shadowRays[i]);
}
//! end
