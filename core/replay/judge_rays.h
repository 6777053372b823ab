#pragma once

#include "core/base/executor.h"
#include "core/replay/judged_pass.h"
#include "core/replay/replay_input.h"
#include "core/verify/view_scope.h"

#include <string>

namespace dirt {

// What the judges of hits and of shadow rays share.

/// Judges one buffer of a path event: \p one.judge(pixel, found) counts what it finds of a pixel.
template <class One>
JudgedPass judgePixels(const std::string& pass, int event, const std::string& buffer, size_t pixels,
                       const One& one, Executor& executor) {
    constexpr size_t kGrain = 1024;
    JudgedPass judged;
    judged.pass = pass;
    judged.event = event;
    judged.buffer = buffer;
    judged.addPieces(executor, pixels, kGrain, [&](size_t begin, size_t end) {
        JudgedPass found;
        for (size_t pixel = begin; pixel < end; ++pixel) one.judge((uint32_t) pixel, found);
        return found;
    });
    return judged;
}

/// Which rays the dump's views answer for.
ViewScope scopeOf(const Manifest& manifest);

/// Whether the tile in which \p hit is filed lists its primitive. The input has lists.
bool isListed(const ReplayInput& input, const Hit& hit);

/// "filed in view +X, column 1, row 2, which does not list it".
std::string misfiledText(const ReplayInput& input, const Hit& hit);

/// "pixel 3,4".
std::string pixelText(const ReplayInput& input, uint32_t pixel);

/// With nine digits, which tell floats apart.
std::string numberText(double x);

} // namespace dirt
