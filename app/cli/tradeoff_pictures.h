#pragma once

#include "bench/tradeoff_bench.h"
#include "core/path/tone_mapping.h"

#include <string>

namespace dirt {

/// Writes STEM-time-….svg and STEM-memory.svg over the numeric sweeps, STEM-error.svg over time,
/// and for each different image STEM-SWEEP-VALUE.png with STEM-SWEEP-VALUE-error.png, its relative
/// error in false colour. Throws InputError.
void writePictures(const std::string& stem, const TradeoffReport& report,
                   const DisplayEncoding& display);

} // namespace dirt
