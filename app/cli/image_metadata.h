#pragma once

#include "app/cli/input.h"
#include "core/io/image.h"

namespace dirt {

/// What a rendered image's file says of itself. Nothing that differs between runs, so that equal
/// renders are equal files.
ImageMetadata metadataOf(const Input& input, const RenderSettings& settings, int samples);

} // namespace dirt
