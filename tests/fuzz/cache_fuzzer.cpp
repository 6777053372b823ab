// Caches of OBJ files whose sums are right and whose contents are anything: sums can be met on
// purpose.

#include "core/base/error.h"
#include "core/io/obj_cache.h"
#include "core/io/place_mesh.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::string source = "v 0 0 0\n", content((const char*) data, size);
    const std::string cache = dirt::sealCache(content, std::as_bytes(std::span(source)));
    const auto read = dirt::decodeCache(std::as_bytes(std::span(cache)),
                                        std::as_bytes(std::span(source)), "a.obj");
    if (!read) return 0;
    // What is taken for sound can be placed, and gives the same cache again.
    if (dirt::encodeCache(*read, std::as_bytes(std::span(source))) != cache) std::abort();
    dirt::Mesh mesh;
    try {
        placeMesh(read->obj, glm::dmat4(1.0),
                  std::vector<uint32_t>(read->obj.materialNames.size() + 1), mesh);
    } catch (const dirt::InputError&) { // a vertex that float does not hold
    }
    for (const dirt::Corners& corners : mesh.triangles)
        for (const uint32_t corner : corners)
            if (corner >= mesh.positions.size()) std::abort();
    return 0;
}
