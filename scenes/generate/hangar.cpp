#include "scenes/generate/hangar.h"

#include "scenes/generate/hangar_aircraft.h"
#include "scenes/generate/hangar_hall.h"
#include "scenes/generate/hangar_materials.h"
#include "scenes/generate/hangar_props.h"
#include "scenes/generate/noise.h"

namespace dirt::generate {
namespace {

using namespace hangar;

constexpr Vec3 aircraft(-1.8, 0, -0.5);

/// Around the aircraft: what is being worked with.
void addWorkshop(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    const Mesh platform = makeWorkPlatform(detail);
    const Mesh chest = makeToolChest(detail);
    mesh.append(platform, place(aircraft + Vec3(7.6, 0, -0.3), 84));
    mesh.append(platform, place(aircraft + Vec3(-3.2, 0, 9.6), 170), {0.7, 0.2});
    mesh.append(chest, place({8.1, 0, 10.6}, -12));
    mesh.append(chest, place({-7.6, 0, 5.4}, -30), {0.4, 0.9});
    mesh.append(makeEngineStand(detail), place({5.9, 0, 9.6}, 24));
    const Mesh chocks = makeChocks(detail);
    mesh.append(chocks, place(aircraft + Vec3(2.9, 0, 0)));
    mesh.append(chocks, place(aircraft + Vec3(-2.9, 0, 0)), {0.3, 0.1});
    mesh.append(makeHose(detail), place({0.6, 0, 11.2}, 200));
    mesh.append(makeGasTrolley(detail), place({10.4, 0, 4.2}, -40));
}

/// Along the walls: what is kept.
void addStores(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    const int paints[3] = {DrumBlue, DrumRust, GreenSteel};
    const Mesh drums[3] = {makeDrum(detail, paints[0]), makeDrum(detail, paints[1]),
                           makeDrum(detail, paints[2])};
    const auto drum = [&](double x, double y, double z, std::uint32_t id) {
        const double r = 0.05;
        mesh.append(drums[hashBits(id, 7) % 3],
                    place({x + hashRange(-r, r, id, 1), y, z + hashRange(-r, r, id, 2)},
                          360 * hashUnit(id, 3)),
                    {3 * hashUnit(id, 4), hashUnit(id, 5)});
    };
    for (std::uint32_t k = 0; k < 9; ++k) drum(10.9 + 0.68 * (k % 3), 0, 8.0 - 0.68 * (k / 3), k);
    for (std::uint32_t k = 0; k < 3; ++k)
        drum(11.25 + 0.62 * (k % 2), 0.88, 7.7 - 0.6 * (k / 2), 20 + k);
    for (std::uint32_t k = 0; k < 16; ++k) {
        drum(-17.4 + 0.66 * (k % 4), 0, -9.0 - 0.66 * (k / 4), 40 + k);
    }
    const Vec3 sizes[4] = {{1.6, 1.1, 1.1}, {1.0, 0.8, 0.9}, {2.4, 1.3, 1.2}, {0.8, 0.6, 0.8}};
    Mesh crates[4] = {Mesh(detail), Mesh(detail), Mesh(detail), Mesh(detail)};
    for (std::uint32_t k = 0; k < 4; ++k) crates[k] = makeCrate(detail, sizes[k], 60 + k);
    mesh.append(crates[0], place({14.6, 0, 0.6}, 8));
    mesh.append(crates[1], place({14.5, 1.1, 0.5}, -14));
    mesh.append(crates[2], place({15.2, 0, -2.4}, 94));
    mesh.append(crates[3], place({12.9, 0, 1.5}, 31));
    mesh.append(crates[2], place({-16.5, 0, 7.0}, 86), {1, 2});
    mesh.append(crates[0], place({-16.4, 1.3, 6.7}, 97), {2, 1});
    mesh.append(crates[1], place({-16.0, 0, 9.4}, 60), {3, 1});
    for (std::uint32_t k = 0; k < 4; ++k) {
        mesh.append(crates[k], place({16.8 - 0.3 * k, 0, -12.0 - 3.0 * k}, 90 + 4.0 * k), {4, 1});
    }
    const Mesh benches[2] = {makeWorkbench(detail, 1), makeWorkbench(detail, 2)};
    for (int k = 0; k < 3; ++k) {
        const double z = -3.5 + 6.4 * k - 6.0;
        mesh.append(benches[k % 2], place({-18.8, 0, z}, 90), {0.3 * k, 0});
        mesh.append(benches[(k + 1) % 2], place({18.8, 0, z - 4}, -90), {0.3 * k, 1});
    }
    mesh.append(makeToolChest(detail), place({-18.6, 0, -6.4}, 90), {0.5, 0.5});
    mesh.append(makeGasTrolley(detail), place({-18.7, 0, 1.2}, 75), {0.1, 0.5});
}

} // namespace

Model makeHangar(const Detail& detail) {
    Model model{hangarMaterials(), Mesh(detail)};
    addHallShell(model.mesh);
    addHallSteel(model.mesh);
    model.mesh.append(makeAirliner(detail), place(aircraft));
    addWorkshop(model.mesh);
    addStores(model.mesh);
    return model;
}

} // namespace dirt::generate
