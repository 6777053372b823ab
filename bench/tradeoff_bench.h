#pragma once

#include "bench/sweeps.h"
#include "bench/timing.h"
#include "core/base/executor.h"
#include "core/compare/plane.h"
#include "core/frame/backend.h"
#include "core/io/image.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace dirt {

/// Error of the mean of some samples against a converged reference.
struct ErrorAt {
    int samples = 0;
    double relativeMse = 0.0;
    double flip = 0.0; ///< mean HDR-FLIP
};

/// What one choice of settings costs, and what it gives.
struct SettingsReport {
    Timing build, sample; ///< of frames of one sample
    uint64_t bytes = 0;   ///< all buffers of a backend that has done nothing else
    uint64_t listEntries = 0;
    size_t image = 0;            ///< first settings that gave this very image, to the bit
    std::vector<ErrorAt> errors; ///< of those settings; empty for the others
};

/// Runs every settings of the sweeps, and keeps what pictures need.
struct TradeoffReport {
    Sweeps sweeps;
    std::vector<SettingsReport> settings; ///< as Sweeps::settings
    std::vector<Image> images; ///< of those with errors, of all samples; empty for the others
    Image reference;           ///< of the bounces that most settings have
};

/// What a tradeoff run is to do.
struct TradeoffOptions {
    int rounds = 9;   ///< measured, after one that is not
    int samples = 64; ///< of the images whose error is taken
    int referenceSamples = 1024;
    /// The reference of some settings, which \p trace makes. Empty: it is traced.
    std::function<Image(const RenderSettings&, const std::function<Image()>& trace)> reference;
    /// The errors of one of Sweeps::settings, known before. Empty: they are taken.
    std::function<std::vector<ErrorAt>(size_t settings)> knownErrors;
    std::function<void(const std::string&)> progress; ///< one line, now and then
};

/// A backend that has done nothing yet.
using BackendMaker = std::function<std::unique_ptr<Backend>()>;

/// Takes the memory of frames of one sample under all settings, each by a backend of its own; then
/// the error of each different image, at powers of two of the samples, against \p reference's
/// backend with another seed; then times such frames of one backend in turn, round after round. The
/// reference has the bounces of \p around, but that of the settings of other bounces has the most
/// of any.
TradeoffReport benchTradeoff(const Scene& scene, const RenderSettings& around,
                             const BackendMaker& makeBackend, Backend& reference,
                             Executor& executor, const TradeoffOptions& options);

} // namespace dirt
