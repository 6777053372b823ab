#pragma once

#include "app/cli/options.h"
#include "core/io/load.h"

namespace dirt {

/// Makes \p loaded seen by the camera of its model files that --camera names, whatever a scene file
/// says; or by none of them where --eye or --target say where to stand. Throws InputError where
/// there is no such camera, or it is orthographic.
void chooseCamera(LoadedScene& loaded, const CommonOptions& options);

/// "2 'top', orthographic".
std::string cameraText(const std::vector<ModelCamera>& cameras, size_t index);

} // namespace dirt
