#pragma once

#include "core/base/image.h"
#include "core/frame/tracer.h"
#include "core/preview/marks.h"
#include "core/preview/picture.h"
#include "core/preview/picture_values.h"
#include "core/scene/origin.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dirt {

/// Some rays of a path: what `explain` has of them, and where they are in a picture.
struct PathStep {
    std::string text;
    std::vector<Mark> marks; ///< in the picture's pixels
};

/// A picture of the view, and what it is of. Not changed once it is shown.
struct ViewPicture {
    Picture picture;                        ///< as a screen shows it
    Image image;                            ///< its values, where it is the image
    std::vector<PictureValues> values;      ///< where it is a buffer
    uint64_t change = 0;                    ///< the last change of the state that it has
    int frame = 0;                          ///< of a scene that moves
    Bounds box;                             ///< of all triangles, the scene's coordinates
    int width = 0, height = 0, samples = 0; ///< of the image behind it
    double error = 0.0;                     ///< relative, see ErrorEstimate
    bool done = false;                      ///< no more samples will come
    bool loading = false;                   ///< of a scene that was not all there
    std::vector<PassTime> build, passes;    ///< of its last frame; passes: with those of the build
    double sampleMs = 0.0;                  ///< from the beginning of the build, for each sample
    std::vector<BufferSize> memory;         ///< of the backend
    uint64_t listEntries = 0;
    std::string device, scale;  ///< scale: what false colours stand for
    std::string told;           ///< of the tile that is asked about, in lines
    std::vector<Mark> marks;    ///< its frame
    std::vector<PathStep> path; ///< of the pixel that is asked about: all rays, then each alone
};

} // namespace dirt
