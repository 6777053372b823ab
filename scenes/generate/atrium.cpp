#include "scenes/generate/atrium.h"

#include <cmath>

#include "scenes/generate/arch.h"
#include "scenes/generate/atrium_materials.h"
#include "scenes/generate/balustrade.h"
#include "scenes/generate/block.h"
#include "scenes/generate/column.h"
#include "scenes/generate/drape.h"
#include "scenes/generate/entablature.h"
#include "scenes/generate/floor.h"
#include "scenes/generate/fountain.h"
#include "scenes/generate/gallery.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/vault.h"
#include "scenes/generate/vegetation.h"

namespace dirt::generate {
namespace {

// The plan, in metres: columns stand on a grid of bays around the court.
constexpr double bay = 3.2;
constexpr int baysAcross = 4;
constexpr int baysAlong = 7;
constexpr double halfX = bay * baysAcross / 2;
constexpr double halfZ = bay * baysAlong / 2;
constexpr double wall = 0.56; // thickness of the arcades
constexpr double archRadius = 1.24;

// Heights.
constexpr double aisleFloor = 0.16;
constexpr double lowerSpringing = 4.0;
constexpr double lowerTop = 5.72;
constexpr double upperFloor = 6.42;
constexpr double parapet = 0.98;
constexpr double upperSpringing = 9.75;
constexpr double upperTop = 11.35;
constexpr double eaves = 12.05;

/// A bay of the arcade seen from the court: its middle on the column line, z towards the court.
struct BayPlace {
    Transform transform;
    int side;  ///< 0 right (+x), 1 far (-z), 2 left, 3 near
    int index; ///< along the side
    std::uint32_t id;
};

std::vector<BayPlace> bays() {
    std::vector<BayPlace> result;
    for (int side = 0; side < 4; ++side) {
        const bool across = side % 2 == 1;
        const int count = across ? baysAcross : baysAlong;
        const double depth = across ? halfZ : halfX;
        for (int k = 0; k < count; ++k) {
            const double along = (k + 0.5) * bay - count * bay / 2;
            const Transform turn = place({0, 0, 0}, 90.0 * side);
            result.push_back({turn * place({depth, 0, along}, -90), side, k,
                              static_cast<std::uint32_t>(side * 16 + k)});
        }
    }
    return result;
}

Vec2 quarry(std::uint32_t id, std::uint32_t salt) {
    return {hashUnit(id, salt, 1) * 5, hashUnit(id, salt, 2) * 5};
}

void addArcades(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    const Mesh lowerColumn = makeColumn(detail, {3.66, 0.235, 0.56, 20, 0, WhiteMarble, Limestone});
    const Mesh upperColumn = makeColumn(detail, {upperSpringing - upperFloor - parapet - 0.12,
                                                 0.165, 0.42, 12, 0.35, RedMarble, WhiteMarble});
    const Mesh lowerArch = makeArchBay(
        detail,
        {archRadius, bay / 2, lowerTop - lowerSpringing, wall, 15, Ashlar, Limestone, RedMarble},
        GreenMarble);
    const Mesh upperArch = makeArchBay(detail,
                                       {archRadius, bay / 2, upperTop - upperSpringing, wall - 0.08,
                                        13, Ashlar, Limestone, Limestone},
                                       RedMarble);
    const Mesh rail = makeBalustrade(detail, {bay - 0.52, parapet, 0.3, Limestone, WhiteMarble});
    const Mesh pedestal = makePedestal(detail, Limestone, 0.27, parapet);
    const Mesh vault = makeGroinVault(detail, Brick, bay / 2, 1.45);
    const Mesh rib = makeRib(detail, Limestone, bay / 2, 1.45, 0.4);
    Mesh impost(detail);
    const bool stepped = detail.shows(0.125);
    addBlock(impost, Limestone, {-0.37, 0, -0.33}, {0.37, stepped ? 0.12 : 0.18, 0.33}, 0.012);
    if (stepped) addBlock(impost, Limestone, {-0.34, 0.12, -0.30}, {0.34, 0.18, 0.30}, 0.008);
    for (const BayPlace& place0 : bays()) {
        const auto& at = place0.transform;
        const auto id = place0.id;
        mesh.append(lowerArch, at * place({0, lowerSpringing, 0}), quarry(id, 1));
        mesh.append(upperArch, at * place({0, upperSpringing, 0}), quarry(id, 2));
        mesh.append(rail, at * place({0, upperFloor, 0}), quarry(id, 3));
        mesh.append(vault, at * place({0, lowerSpringing, -bay / 2}), quarry(id, 4));
        // Each bay brings the column at its right end, so a side's next one brings the corner.
        const Transform foot = at * place({bay / 2, 0, 0});
        mesh.append(lowerColumn, foot * place({0, aisleFloor, 0}, 90.0 * (id % 4)), quarry(id, 5));
        mesh.append(impost, foot * place({0, lowerSpringing - 0.18, 0}), quarry(id, 6));
        mesh.append(pedestal, foot * place({0, upperFloor, 0}), quarry(id, 7));
        mesh.append(upperColumn, foot * place({0, upperFloor + parapet, 0}, 90.0 * (id % 3)),
                    quarry(id, 8));
        mesh.append(impost,
                    foot * place({0, upperSpringing - 0.12, 0}) * scaled({0.78, 0.667, 0.8}),
                    quarry(id, 9));
        if (detail.shows(0.11))
            mesh.append(rib, foot * place({0, lowerSpringing, -bay / 2}, 90), quarry(id, 10));
    }
    for (int corner = 0; corner < 4; ++corner) {
        const double x = corner % 2 == 0 ? halfX : -halfX;
        const double z = corner < 2 ? halfZ : -halfZ;
        const double t = wall / 2;
        addBlock(mesh, Ashlar, {x - t, lowerSpringing, z - t}, {x + t, lowerTop, z + t}, 0.005);
        addBlock(mesh, Ashlar, {x - t, upperSpringing, z - t}, {x + t, upperTop, z + t}, 0.005);
        const double ox = x + std::copysign(bay / 2, x);
        const double oz = z + std::copysign(bay / 2, z);
        mesh.append(vault, place({ox, lowerSpringing, oz}));
    }
}

/// The aisles' rear walls, floors and ceilings.
void addAisles(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    const double lowerHeight = upperFloor - aisleFloor;
    const double upperHeight = upperTop - upperFloor + 0.3;
    const Mesh lower[3] = {makeWallBay(detail, BayKind::Niche, bay / 2, lowerHeight),
                           makeWallBay(detail, BayKind::Door, bay / 2, lowerHeight),
                           makeWallBay(detail, BayKind::Plain, bay / 2, lowerHeight)};
    const Mesh upper[2] = {makeWallBay(detail,
                                       detail.shows(0.115) ? BayKind::Window : BayKind::Plain,
                                       bay / 2, upperHeight),
                           makeWallBay(detail, BayKind::Door, bay / 2, upperHeight)};
    const Mesh pilaster = makePilaster(detail, 0.2, 0.12, lowerSpringing - aisleFloor);
    const Mesh upperPilaster = makePilaster(detail, 0.17, 0.1, upperTop - upperFloor - 0.2);
    Mesh beam(detail);
    addBlock(beam, Wood, {-0.11, upperTop - 0.22, -bay - 0.1}, {0.11, upperTop + 0.08, 0.1}, 0.015);
    for (const BayPlace& place0 : bays()) {
        const Transform back = place0.transform * place({0, 0, -bay});
        const bool middle = place0.index == (place0.side % 2 == 1 ? baysAcross : baysAlong) / 2;
        const int kind = !detail.shows(0.105) ? 2 : middle ? 1 : place0.index % 2;
        mesh.append(lower[kind], back * place({0, aisleFloor, 0}), quarry(place0.id, 11));
        mesh.append(upper[place0.index % 3 == 1 ? 1 : 0], back * place({0, upperFloor, 0}),
                    quarry(place0.id, 12));
        const Transform end = back * place({bay / 2, 0, 0});
        mesh.append(pilaster, end * place({0, aisleFloor, 0}), quarry(place0.id, 13));
        if (detail.shows(0.112))
            mesh.append(upperPilaster, end * place({0, upperFloor, 0}), quarry(place0.id, 14));
        const int joists = detail.shows(0.17) ? 3 : 1;
        for (int k = 0; k < joists; ++k) {
            mesh.append(beam, place0.transform * place({bay * ((k + 0.5) / joists - 0.5), 0, 0}),
                        quarry(place0.id, 15));
        }
    }
    for (int corner = 0; corner < 4; ++corner) {
        const Transform turn(corner % 2 == 0 ? 1 : -1, 0, 0, 0, 0, 1, 0, 0, 0, 0,
                             corner < 2 ? 1 : -1, 0, 0, 0, 0, 1);
        const Transform toX = turn * place({halfX + bay, 0, halfZ + bay / 2}, -90);
        const Transform toZ = turn * place({halfX + bay / 2, 0, halfZ + bay}, 180);
        for (const Transform& at : {toX, toZ}) {
            mesh.append(lower[2], at * place({0, aisleFloor, 0}));
            mesh.append(upper[0], at * place({0, upperFloor, 0}));
        }
    }
    const double ox = halfX + bay;
    const double oz = halfZ + bay;
    const double edge = 0.5;
    const double ix = halfX - edge;
    const double iz = halfZ - edge;
    for (const double sign : {-1.0, 1.0}) {
        const Vec2 low(sign < 0 ? -ox : ix, -oz);
        const Vec2 high(sign < 0 ? -ix : ox, oz);
        addPaving(mesh, low, high, aisleFloor, 0.62);
        const Vec2 crossLow(-ix, sign < 0 ? -oz : iz);
        const Vec2 crossHigh(ix, sign < 0 ? -iz : oz);
        addPaving(mesh, crossLow, crossHigh, aisleFloor, 0.62);
    }
    Profile step({0, 0});
    step.line({0.06, 0})
        .line({0.06, 0.12})
        .bow({0.04, aisleFloor + 0.003}, 0.25)
        .line({-0.36, aisleFloor + 0.003});
    addInnerRing(mesh, Limestone, step, {ix, iz}, 8);
    Profile dado({0, 0.17});
    dado.line({0.05, 0.17}).line({0.05, 0.36}).cyma({0.02, 0.42}, -0.4).line({0, 0.42});
    addInnerRing(mesh, RedMarble, dado, {ox, oz}, 8);
    // The upper floor, seen from its own height, and boards over the beams.
    Profile floor({0.5 + bay, upperFloor});
    floor.line({0, upperFloor});
    addInnerRing(mesh, Limestone, floor, {ox, oz});
    Profile boards({0, upperTop + 0.06});
    boards.line({bay + 0.2, upperTop + 0.06});
    addInnerRing(mesh, Wood, boards, {ox, oz});
    for (int side = 0; side < 4; ++side) {
        const double depth = (side % 2 == 0 ? ox : oz) + 0.4;
        const double half = (side % 2 == 0 ? oz : ox) + 0.4;
        Mesh face(detail);
        face.addQuad(Plaster, {-half, -0.2, depth}, {half, -0.2, depth},
                     {half, eaves + 1.46, depth}, {-half, eaves + 1.46, depth});
        mesh.append(face, place({0, 0, 0}, 90.0 + 90.0 * side));
    }
}

void addBanners(Mesh& mesh) {
    if (!mesh.detail().shows(0.107)) {
        return;
    }
    const int colours[4] = {RedCloth, BlueCloth, OchreCloth, GreenCloth};
    const double face = wall / 2 - 0.15 + 0.02;
    for (const BayPlace& place0 : bays()) {
        const bool sides = place0.side % 2 == 0;
        const bool hung = sides ? place0.index % 2 == 1
                                : place0.side == 1 && (place0.index == 0 || place0.index == 3);
        if (hung) {
            const int colour = colours[(place0.index / 2 + place0.side) % 4];
            const double length = 4.6 + 0.5 * hashUnit(place0.id, 21);
            const Mesh banner = makeBanner(mesh.detail(), {1.5, length, 0.52 + face, parapet + 0.04,
                                                           colour, GoldTrim, place0.id});
            mesh.append(banner, place0.transform * place({0, upperFloor + parapet + 0.01, 0.155}));
        } else if (mesh.detail().shows(0.13) &&
                   (sides ? place0.index == 2 || place0.index == 4 : place0.side == 1)) {
            const int curtains[4] = {OchreCloth, RedCloth, BlueCloth, RedCloth};
            const int colour = curtains[place0.side];
            const Mesh curtain = makeCurtain(mesh.detail(), colour, GoldTrim, archRadius - 0.05,
                                             3.5, 1.35, place0.id);
            const Transform at = place0.transform * place({0, aisleFloor + 0.02, -0.12});
            mesh.append(curtain, at);
            mesh.append(curtain, at * scaled({-1, 1, 1}), {0.4, 0.3});
        }
    }
}

void addPlants(Mesh& mesh) {
    const Mesh pot = makePot(mesh.detail());
    const Mesh trees[2] = {makeLemonTree(mesh.detail(), 3), makeLemonTree(mesh.detail(), 8)};
    const Mesh agave = makeAgave(mesh.detail(), 5);
    const Vec3 soil(0, 0.5, 0);
    std::uint32_t id = 0;
    for (const double x : {-4.9, 4.9}) {
        for (const double z : {-8.0, -4.8, -1.6, 1.6, 4.8, 8.0}) {
            if (!mesh.detail().shows(0.118) && std::abs(z) < 4) {
                continue;
            }
            const Transform at = place({x, 0, z}, 73.0 * id);
            mesh.append(pot, at, quarry(id, 31));
            if (id % 2 == 0) {
                mesh.append(trees[id / 2 % 2], at * place(soil));
            } else {
                mesh.append(agave, at * place(soil));
            }
            ++id;
        }
    }
    for (const BayPlace& place0 : bays()) {
        if (mesh.detail().shows(0.165) && place0.side != 3 && place0.index % 3 == 0) {
            const Mesh ivy = makeHangingIvy(mesh.detail(), 2.0, 2.0, place0.id);
            mesh.append(ivy, place0.transform * place({0, upperFloor + parapet + 0.02, 0.12}));
        }
    }
}

} // namespace

Model makeAtrium(const Detail& detail) {
    Model model{atriumMaterials(), Mesh(detail)};
    Mesh& mesh = model.mesh;
    addArcades(mesh);
    addAisles(mesh);
    const Vec2 faces(halfX - wall / 2, halfZ - wall / 2);
    addEntablature(mesh, {faces, lowerTop, upperFloor, 0.46, false});
    addEntablature(mesh, {faces, upperTop, eaves, 0.62, true});
    Profile soffit({-1.6, eaves - 0.03});
    soffit.line({0.72, eaves - 0.03});
    addInnerRing(mesh, Wood, soffit, faces);
    addRoof(mesh, faces - Vec2(0.72), bay + 1.6, eaves + 0.03, 1.5);
    mesh.append(makeCourtFloor(detail, {halfX - 0.5, halfZ - 0.5}), place({0, 0, 0}));
    mesh.append(makeFountain(detail), place({0, 0, 0}));
    addBanners(mesh);
    addPlants(mesh);
    return model;
}

} // namespace dirt::generate
