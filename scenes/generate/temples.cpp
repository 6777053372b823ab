#include "scenes/generate/temples.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scenes/generate/noise.h"
#include "scenes/generate/temples_doric.h"
#include "scenes/generate/temples_land.h"
#include "scenes/generate/temples_materials.h"
#include "scenes/generate/temples_plants.h"

namespace dirt::generate {
namespace {

using namespace temples;

Vec3 onGround(double x, double z, double sink = 0) {
    return {x, groundHeight(x, z) - sink, z};
}

Transform turnedAbout(double degrees, Vec3 axis) {
    return glm::rotate(Transform(1), glm::radians(degrees), axis);
}

/// Whether a place is under the great temple.
bool underTemple(double x, double z) {
    const glm::dvec4 local = glm::inverse(place({10.5, 0, -21}, -27)) * glm::dvec4(x, 0, z, 1);
    return std::abs(local.x) < 9.4 && local.z < 0.6 && local.z > -29;
}

/// What has fallen from the temple: drums, blocks, a capital.
void addFallen(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    const struct {
        double x, z, length, degrees;
    } drums[] = {{2.9, -10.6, 1.15, 20}, {5.4, -12.2, 0.95, -35}, {-0.6, -15.5, 1.1, 70},
                 {11.5, -12.0, 1.2, 5},  {14.6, -14.6, 0.9, 50},  {-3.4, -21.0, 1.0, 15},
                 {17.2, -11.2, 1.1, -60}};
    std::uint32_t id = 400;
    for (const auto& d : drums) {
        ++id;
        mesh.append(makeFallenDrum(detail, Marble, 0.57 - 0.03 * (id % 4), d.length, id),
                    glm::translate(Transform(1), onGround(d.x, d.z, 0.14)) *
                        place({0, 0, 0}, d.degrees) * turnedAbout(47.0 * id, {1, 0, 0}) *
                        Transform(1),
                    {hashUnit(id, 1) * 5, 0});
    }
    mesh.append(makeDoricCapital(detail, Marble, 0.47, 431),
                glm::translate(Transform(1), onGround(-1.9, -7.4) + Vec3(0, 0.42, 0)) *
                    place({0, 0, 0}, 35) * turnedAbout(152, {0.9, 0, 0.35}) *
                    glm::translate(Transform(1), {0, -0.28, 0}));
    const struct {
        double x, z, degrees, tilt;
        Vec3 size;
    } blocks[] = {{1.5, -8.3, 30, 9, {1.5, 0.55, 0.8}},   {7.6, -10.4, -20, 14, {1.9, 0.6, 0.9}},
                  {-4.2, -12.8, 65, -8, {1.3, 0.5, 0.7}}, {9.2, -8.2, 80, 6, {1.2, 0.5, 0.6}},
                  {13.4, -9.0, 10, -12, {1.7, 0.7, 0.9}}, {4.2, -15.0, -70, 5, {1.4, 0.5, 0.8}},
                  {-6.5, -18.0, 15, 7, {1.5, 0.6, 0.8}}};
    for (const auto& b : blocks) {
        ++id;
        Mesh block(detail);
        addWornBlock(block, Marble, b.size * Vec3(-0.5, 0, -0.5), b.size * Vec3(0.5, 1, 0.5), 0.08,
                     id);
        mesh.append(block, glm::translate(Transform(1), onGround(b.x, b.z, 0.12)) *
                               place({0, 0, 0}, b.degrees) * turnedAbout(b.tilt, {0.4, 0, 1}));
    }
}

void addRocks(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    constexpr std::uint32_t kinds = 5;
    std::vector<Mesh> rocks;
    std::vector<Mesh> pebbles;
    for (std::uint32_t k = 0; k < kinds; ++k) {
        rocks.push_back(makeRock(detail, 500 + k));
        pebbles.push_back(makeRock({0.24 * detail.quality, detail.countOnly}, 500 + k));
    }
    const auto put = [&](const Mesh& rock, double x, double z, double size, std::uint32_t id) {
        const double tilt = hashRange(-18, 18, id, 3);
        mesh.append(rock,
                    glm::translate(Transform(1), onGround(x, z, 0.05 * size)) *
                        place({0, 0, 0}, 360 * hashUnit(id, 4)) * turnedAbout(tilt, {1, 0, 0.4}) *
                        scaled(size * Vec3(1, hashRange(0.7, 1.1, id, 5), 1)),
                    {5 * hashUnit(id, 6), 5 * hashUnit(id, 7)});
    };
    // Large ones frame the picture; the rest lies in swarms.
    put(rocks[0], -5.6, -7.2, 2.2, 1);
    put(rocks[1], -7.4, -9.4, 3.2, 2);
    put(rocks[2], -4.3, -8.6, 1.2, 3);
    put(rocks[3], 5.3, -6.3, 1.3, 4);
    put(rocks[4], 6.6, -7.0, 2.0, 5);
    put(rocks[0], -11, -16, 3.4, 6);
    const int stones = detail.number(520, 40);
    for (int k = 0; k < stones; ++k) {
        const auto id = hashBits(601, static_cast<std::uint32_t>(k));
        const double d = 3.0 * std::pow(18.0, hashUnit(id, 1));
        const double a = (hashUnit(id, 2) - 0.5) * (k % 5 == 0 ? 6.2 : 2.4);
        const double x = d * std::sin(a);
        const double z = -d * std::cos(a);
        if (underTemple(x, z)) continue;
        const double swarm = fractalSolidNoise(Vec3(x, 0, z) * 0.22, 2, 602);
        if (swarm < hashRange(-0.5, 0.5, id, 8)) continue;
        const double size = 0.10 * std::pow(9.0, std::pow(hashUnit(id, 9), 2.6)) * (1 + 0.02 * d);
        put(size > 0.45 ? rocks[id % kinds] : pebbles[id % kinds], x, z, size, id);
    }
}

void addPlants(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    mesh.append(makeOliveTree(detail, 3), place(onGround(-7.9, -13.5), 40) * scaled(Vec3(1.3)));
    mesh.append(makeOliveTree(detail, 5), place(onGround(24, -25), 150) * scaled({1.1, 1.0, 1.1}));
    std::vector<Mesh> shrubs;
    std::vector<Mesh> tufts;
    for (std::uint32_t k = 0; k < 3; ++k) shrubs.push_back(makeShrub(detail, 700 + k));
    for (std::uint32_t k = 0; k < 4; ++k) tufts.push_back(makeGrassTuft(detail, 710 + k));
    const int count = detail.number(2400, 80, 0.5);
    for (int k = 0; k < count; ++k) {
        const auto id = hashBits(721, static_cast<std::uint32_t>(k));
        const double d = 2.6 * std::pow(15.0, std::pow(hashUnit(id, 1), 0.8));
        const double a = (hashUnit(id, 2) - 0.5) * 2.3;
        const double x = d * std::sin(a);
        const double z = -d * std::cos(a);
        if (underTemple(x, z)) continue;
        const double meadow = fractalSolidNoise(Vec3(x, 0, z) * 0.3, 3, 722);
        if (meadow < hashRange(-0.3, 0.5, id, 3)) continue;
        const bool shrub = k % 12 == 0 && d > 5;
        const double size = hashRange(0.7, 1.5, id, 5) * (shrub ? 1.25 : 1.0);
        mesh.append(shrub ? shrubs[id % 3] : tufts[id % 4],
                    place(onGround(x, z), 360 * hashUnit(id, 4)) * scaled(Vec3(size)));
    }
}

} // namespace

Model makeTemples(const Detail& detail) {
    Model model{templesMaterials(), Mesh(detail)};
    Mesh& mesh = model.mesh;
    addGround(mesh);
    addFarView(mesh);
    mesh.append(makeTemple(detail, 0.72, 7), place({10.5, -0.15, -21}, -27));
    // A second one, on the next headland.
    const Detail coarse{0.3 * detail.quality, detail.countOnly};
    mesh.append(makeTemple(coarse, 0.45, 11),
                place(headland + Vec3(8, -0.3, 18), 40) * scaled(Vec3(1.3)));
    addFallen(mesh);
    addRocks(mesh);
    addPlants(mesh);
    return model;
}

} // namespace dirt::generate
