#pragma once

#include "app/cli/options.h"
#include "core/base/executor.h"
#include "core/frame/backend.h"
#include "core/verify/extremes.h"
#include "core/verify/verify.h"

#include <memory>
#include <string>
#include <vector>

namespace dirt {

/// What `dirt verify` was asked for.
struct VerifyOptions {
    CommonOptions common;
    std::optional<uint32_t> rays;
    std::vector<std::string> kinds; ///< none: all
    bool json = false;
    bool extremes = false;
    std::vector<std::string> only; ///< names of variants; none: all
};

/// Throws InputError where one is not known.
std::vector<RayKind> kindsOf(const VerifyOptions& options);
std::vector<const Extreme*> extremesOf(const VerifyOptions& options);

/// Embree as its users get it, by default and robust. Throws CapabilityError where this build lacks
/// it.
std::vector<std::unique_ptr<Backend>> makePeers(Executor& executor);

/// `dirt verify --extremes`. Whether the backend under test was right in every variant.
bool runExtremes(VerifyOptions options);

} // namespace dirt
