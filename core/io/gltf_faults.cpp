#include "core/io/gltf_faults.h"

#include "core/base/finite.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

class VertexChecker {
public:
    VertexChecker(const JsonValue& source, FaultCounter& faults)
        : source_(source), faults_(faults) {}

    void position(size_t vertex, glm::vec3 p, bool used) {
        if (isFinite(p)) return;
        const std::string message =
            "has position " + std::to_string(vertex) + ", which is not finite";
        if (used) source_.fail(message);
        fault(WarningKind::skippedGeometry, message, ": no triangle uses it");
    }

    void normal(size_t vertex, glm::vec3 n) {
        const char* const bad = !isFinite(n)           ? ", which is not finite"
                                : n == glm::vec3(0.0f) ? ", which has no length"
                                                       : nullptr;
        if (bad)
            fault(WarningKind::unusableAttribute, "has normal " + std::to_string(vertex) + bad,
                  ": triangles with it have their own");
    }

    void texcoord(size_t vertex, glm::vec2 uv) {
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
            fault(WarningKind::unusableAttribute,
                  "has texture coordinates " + std::to_string(vertex) + ", which are not finite",
                  ": triangles with them have none");
    }

private:
    void fault(WarningKind kind, const std::string& message, const char* fallback) {
        faults_.add(kind, fallback, 0, [&] { return source_.place() + " " + message + fallback; });
    }

    const JsonValue& source_;
    FaultCounter& faults_;
};

} // namespace

void checkVertices(const GltfFile::Primitive& primitive, const JsonValue& source,
                   FaultCounter& faults) {
    std::vector<bool> used(primitive.positions.size(), false);
    for (const auto& triangle : primitive.triangles)
        for (const uint32_t vertex : triangle) used[vertex] = true;
    VertexChecker check(source, faults);
    for (size_t i = 0; i < used.size(); ++i) {
        check.position(i, primitive.positions[i], used[i]);
        if (!used[i]) continue;
        if (!primitive.normals.empty()) check.normal(i, primitive.normals[i]);
        if (!primitive.texcoords.empty()) check.texcoord(i, primitive.texcoords[i]);
    }
}

} // namespace dirt
