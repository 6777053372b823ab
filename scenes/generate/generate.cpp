#include "scenes/generate/generate.h"

#include <cmath>
#include <functional>
#include <stdexcept>

#include "scenes/generate/atrium.h"
#include "scenes/generate/bunny.h"
#include "scenes/generate/cornell.h"
#include "scenes/generate/hangar.h"
#include "scenes/generate/output.h"
#include "scenes/generate/scene_text.h"
#include "scenes/generate/temples.h"

namespace dirt {
namespace {

using generate::Detail;
using generate::Model;

struct Generator {
    GeneratorInfo info;
    std::function<Model(const Detail&)> make;
};

const std::vector<Generator>& table() {
    static const std::vector<Generator> all = {
        {{"atrium",
          "a court between two storeys of arcades, with banners, a fountain and lemon trees",
          250'000,
          1e4,
          1e7,
          {"atrium"}},
         generate::makeAtrium},
        {{"bunny",
          "a stoneware rabbit in the furnished corner of a room",
          300'000,
          6e4,
          1e7,
          {"bunny_day", "bunny_night"}},
         generate::makeBunny},
        {{"cornell",
          "the Cornell box with a lamp panel and a spotlight under it",
          36,
          36,
          1e7,
          {"cornell"}},
         generate::makeCornell},
        {{"hangar",
          "an airliner of the 1930s in a steel hall lit by panels",
          350'000,
          9e4,
          1e7,
          {"hangar"}},
         generate::makeHangar},
        {{"temples",
          "ruined temples on a rocky cape, with islands in the haze",
          400'000,
          1e5,
          1e7,
          {"temples"}},
         generate::makeTemples},
    };
    return all;
}

std::string range(const GeneratorInfo& info) {
    const auto text = [](double value) { return std::to_string(static_cast<long long>(value)); };
    return text(info.minDetail) + " to " + text(info.maxDetail);
}

/// The quality whose triangle count comes nearest to the wish. The count grows with quality, in
/// steps; meshes that only count make trying cheap.
double findQuality(const Generator& generator, double wished) {
    double low = 0.01;
    double high = 1000;
    double best = low;
    double bestError = INFINITY;
    for (int step = 0; step < 30; ++step) {
        const double middle = std::sqrt(low * high);
        const auto count = static_cast<double>(generator.make({middle, true}).mesh.triangleCount());
        const double error = std::abs(std::log(count / wished));
        if (error < bestError) {
            bestError = error;
            best = middle;
        }
        (count < wished ? low : high) = middle;
    }
    return best;
}

} // namespace

std::vector<GeneratorInfo> generators() {
    std::vector<GeneratorInfo> infos;
    for (const Generator& generator : table()) {
        infos.push_back(generator.info);
    }
    return infos;
}

std::vector<std::filesystem::path> generateScene(const std::string& name, double detail,
                                                 const std::filesystem::path& directory) {
    for (const Generator& generator : table()) {
        if (generator.info.name != name) continue;
        // Written so that NaN fails.
        if (!(detail >= generator.info.minDetail && detail <= generator.info.maxDetail)) {
            throw std::runtime_error("detail of '" + name + "' must be " + range(generator.info) +
                                     " triangles");
        }
        const Model model = generator.make({findQuality(generator, detail), false});
        std::vector<generate::SceneFile> scenes;
        for (const std::string& scene : generator.info.scenes) {
            scenes.push_back({scene, generate::sceneText(scene, name + ".obj")});
        }
        return generate::writeModel(model, name, scenes, directory);
    }
    std::string known;
    for (const Generator& generator : table()) {
        known += (known.empty() ? "" : ", ") + generator.info.name;
    }
    throw std::runtime_error("no generator named '" + name + "'; there are: " + known);
}

} // namespace dirt
