#include "scenes/generate/bunny.h"

#include <glm/gtc/matrix_transform.hpp>

#include "scenes/generate/bunny_furniture.h"
#include "scenes/generate/bunny_materials.h"
#include "scenes/generate/bunny_room.h"
#include "scenes/generate/rabbit.h"

namespace dirt::generate {
namespace {

using namespace bunny;

void addFurniture(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    mesh.append(makeArmchair(detail), place({1.02, 0, -0.92}, -28));
    mesh.append(makeSideTable(detail), place({-0.95, 0, 0.0}));
    mesh.append(makeTableLamp(detail), place({-0.96, 0.52, -0.03}));
    mesh.append(makeHousePlant(detail, 5), place({-1.38, 0, -1.28}));
}

void addThings(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    const struct {
        int cover;
        Vec3 size;
        double degrees;
        Vec2 shift;
    } books[] = {{BlueBook, {0.25, 0.034, 0.18}, 14, {0, 0}},
                 {RedBook, {0.23, 0.042, 0.17}, 2, {0.006, 0.004}},
                 {OchreBook, {0.21, 0.026, 0.15}, 24, {-0.008, 0.003}},
                 {GreenBook, {0.19, 0.036, 0.14}, 8, {0.004, -0.006}}};
    double y = 0.012;
    for (const auto& book : books) {
        mesh.append(makeBook(detail, book.cover, book.size),
                    place({0.72 + book.shift.x, y, 0.02 + book.shift.y}, book.degrees));
        y += book.size.y + 0.0005;
    }
    mesh.append(makeBook(detail, OchreBook, {0.18, 0.022, 0.13}), place({-0.84, 0.52, 0.11}, -35),
                {0.2, 0.1});
    mesh.append(makeBall(detail, 0.115), glm::translate(Transform(1), {-0.34, 0.012, -0.20}) *
                                             glm::translate(Transform(1), {0, 0.115, 0}) *
                                             glm::rotate(Transform(1), 0.7, Vec3(1, 0, 0.6)) *
                                             glm::translate(Transform(1), {0, -0.115, 0}));
    const int colours[4] = {ToyRed, ToyBlue, ToyGreen, ToyYellow};
    const struct {
        Vec3 position;
        double degrees;
    } blocks[] = {{{0.50, 0.012, 0.46}, 20},
                  {{0.575, 0.012, 0.485}, -12},
                  {{0.535, 0.072, 0.47}, 33},
                  {{0.66, 0.012, 0.60}, 50},
                  {{0.42, 0.012, 0.62}, -40}};
    int k = 0;
    for (const auto& block : blocks) {
        mesh.append(makeToyBlock(detail, colours[k % 4]), place(block.position, block.degrees),
                    {0.3 * k, 0.1 * k});
        ++k;
    }
    mesh.append(makeCarrotPlate(detail), place({-0.34, 0.012, 0.56}, 150));
}

} // namespace

Model makeBunny(const Detail& detail) {
    Model model{bunnyMaterials(), Mesh(detail)};
    Mesh& mesh = model.mesh;
    addRoom(mesh);
    mesh.append(makeRabbit(detail, {Stoneware, bunny::Eye}),
                place({0.14, 0.012, 0.33}, 219) * scaled({1, 1, -1}));
    addFurniture(mesh);
    addThings(mesh);
    return model;
}

} // namespace dirt::generate
