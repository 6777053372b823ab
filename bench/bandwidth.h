#pragma once

#include "core/base/executor.h"

namespace dirt {

/// The memory bandwidth of a large copy on all threads, bytes read and written per millisecond: the
/// best of a few.
double measureBandwidth(Executor& executor);

} // namespace dirt
