#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// The materials of a rabbit.
struct RabbitMaterials {
    int body;
    int eye;
};

/// A rabbit of glazed stoneware on its haunches, 0.48 m high to the tips of its ears, on the
/// origin, its body along x, looking towards +x and a little to +z.
Mesh makeRabbit(const Detail& detail, RabbitMaterials materials);

} // namespace dirt::generate
