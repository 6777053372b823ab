#include "core/check/built_structure.h"

namespace dirt {

BuiltStructure buildOn(Backend& backend, const Mesh& mesh, const Camera& camera,
                       const GridSettings& settings) {
    backend.build(mesh, camera, settings);
    BuiltStructure built;
    built.geometry = backend.readGeometry();
    if (backend.hasGrid()) built.grid = backend.readGrid();
    return built;
}

BuiltStructure defined(const Mesh& mesh, const Camera& camera, const GridSettings& settings) {
    BuiltStructure built;
    built.geometry = makeFrameGeometry(mesh, camera, settings.mode);
    built.grid = buildGrid(built.geometry, camera, settings);
    return built;
}

void hand(const BuiltStructure& built, const Camera& camera, const GridSettings& settings,
          Backend& backend) {
    if (!built.grid || !backend.hasGrid()) {
        backend.build(built.geometry, camera, settings);
        return;
    }
    backend.clear(camera, settings);
    backend.setGeometry(built.geometry);
    backend.writeGrid(*built.grid);
}

} // namespace dirt
