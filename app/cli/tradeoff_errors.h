#pragma once

#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "bench/tradeoff_bench.h"

#include <string>

namespace dirt {

/// Converged images in a folder, as `render --backend embree -o FOLDER/SCENE-BOUNCES.exr` writes
/// them with the seed of the references: read where they are there, else traced and left there.
class KeptReferences {
public:
    /// Makes the folder. \p input must outlive it. Throws InputError.
    KeptReferences(std::string folder, const Input& input);

    /// The image of \p settings, which \p trace makes. Throws InputError where the file there is of
    /// anything else.
    Image operator()(const RenderSettings& settings, const std::function<Image()>& trace) const;

private:
    std::string folder_;
    const Input& input_;
};

/// The errors in the JSON of an earlier `bench tradeoff`.
class KnownErrors {
public:
    /// \p head: of this run's report; whatever the file says otherwise is refused. Throws
    /// InputError.
    KnownErrors(const std::string& file, const Json& head, const Sweeps& sweeps);

    /// Of one settings. Throws InputError where the file has none.
    std::vector<ErrorAt> of(size_t settings) const;

    int referenceSamples() const { return referenceSamples_; }

private:
    std::string file_;
    std::vector<std::vector<ErrorAt>> errors_; ///< by settings
    int referenceSamples_ = 0;
};

} // namespace dirt
