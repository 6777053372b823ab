#include "backend_cpu/light/light_tree.h"

#include "backend_cpu/light/light_cone.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace dirt {
namespace {

/// One triangle of so many is asked for its place; which of them, chance decides, as meshes repeat.
constexpr int kStrideBits = 6;
constexpr size_t kStride = 1 << kStrideBits;
constexpr size_t kSamplesPerPiece = 1024;

/// Triangles to a root, of those spread evenly over the cone; and to a tile, at most, of those that
/// fit into it: larger ones would be in most of its parts.
constexpr double kPerRoot = 32.0;
constexpr uint32_t kMostSamples = 16;

constexpr int kLeastRootBits = 2, kMostRootBits = 10;

/// A triangle in the light's cone: its middle on the way from root to tile.
struct Sample {
    uint32_t root;
    uint32_t path;  ///< four bits a level, the first level's the highest of 4 kMostLevels
    uint32_t level; ///< of the last node that it fits into; 0 is the root
};
constexpr int kMostLevels = 8;
constexpr uint32_t kNoRoot = ~0u;

class Sampler {
public:
    Sampler(const LightTree& tree, const glm::vec3& position) : tree_(tree), position_(position) {}

    Sample operator()(const Triangle& t) const {
        const Sample none{kNoRoot, 0, 0};
        const glm::vec3 v[3] = {t.a - position_, t.b - position_, t.c - position_};
        const glm::vec3 middle = v[0] + v[1] + v[2];
        const glm::vec3 size = glm::abs(middle);
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const LightFace& face = tree_.faces[2 * axis + (middle[axis] < 0.0f)];
        float low[2] = {2.0f, 2.0f}, high[2] = {-2.0f, -2.0f};
        for (const glm::vec3& p : v) {
            const float w = face.signW * p[face.axisW];
            if (!(w > 0.0f)) return none;
            const float slope[2] = {p[face.axisX] / w, p[face.axisY] / w};
            for (int i = 0; i < 2; ++i) {
                low[i] = std::min(low[i], slope[i]);
                high[i] = std::max(high[i], slope[i]);
            }
        }
        const auto place = [](float slope) {
            return (uint32_t) std::clamp((slope + 1.0f) * (float) kPlacesPerSlope, 0.0f,
                                         (float) ((1 << kPlaceBits) - 1));
        };
        const uint32_t x = place(0.5f * (low[0] + high[0])), y = place(0.5f * (low[1] + high[1]));
        const uint32_t column = (x >> tree_.rootShift) - (uint32_t) face.column;
        const uint32_t row = (y >> tree_.rootShift) - (uint32_t) face.row;
        if (column >= (uint32_t) face.columns || row >= (uint32_t) face.rows) return none;
        const uint32_t extent =
            std::max(place(high[0]) - place(low[0]), place(high[1]) - place(low[1]));
        const int room = tree_.rootShift - (int) std::bit_width(extent);
        if (room < 0) return none;
        Sample sample{face.firstNode + row * (uint32_t) face.columns + column, 0,
                      (uint32_t) room / LightTree::kSplitBits};
        for (int level = 0; level < kMostLevels; ++level) {
            const int shift = tree_.rootShift - (level + 1) * LightTree::kSplitBits;
            const uint32_t child = shift < 0 ? 0 : (y >> shift & 3) << 2 | (x >> shift & 3);
            sample.path = sample.path << 4 | child;
        }
        return sample;
    }

private:
    const LightTree& tree_;
    const glm::vec3 position_;
};

/// Cuts a root, and what comes of it, as long as many samples fit.
class Splitter {
public:
    Splitter(LightTree& tree, std::vector<Sample>& spare) : tree_(tree), spare_(spare) {}

    void split(size_t node, std::span<Sample> samples, uint32_t level) {
        const auto fitting =
            std::count_if(samples.begin(), samples.end(),
                          [&](const Sample& sample) { return sample.level >= level; });
        const int shift = tree_.rootShift - (int) (level + 1) * LightTree::kSplitBits;
        if (fitting <= kMostSamples || shift < kUnitBits || level == kMostLevels) {
            tree_.nodes[node] = tree_.tiles++;
            return;
        }
        const auto childOf = [&](const Sample& sample) {
            return sample.path >> 4 * (kMostLevels - 1 - level) & 15;
        };
        std::array<size_t, 17> ends{};
        for (const Sample& sample : samples) ++ends[childOf(sample) + 1];
        for (int child = 0; child < 16; ++child) ends[child + 1] += ends[child];
        std::array<size_t, 17> next = ends;
        spare_.assign(samples.begin(), samples.end());
        for (const Sample& sample : spare_) samples[next[childOf(sample)]++] = sample;

        const size_t first = tree_.nodes.size();
        tree_.nodes[node] = LightTree::kInner | (uint32_t) first;
        tree_.nodes.resize(first + 16);
        for (int child = 0; child < 16; ++child)
            split(first + child, samples.subspan(ends[child], ends[child + 1] - ends[child]),
                  level + 1);
    }

private:
    LightTree& tree_;
    std::vector<Sample>& spare_;
};

} // namespace

void makeLightTree(const FrameGeometry& geometry, const glm::vec3& position, const LightCone& cone,
                   Executor& executor, LightTree& tree) {
    const size_t count = geometry.triangles.size();
    const double roots = std::sqrt((double) count / kPerRoot / (6.0 * cone.part()));
    const int bits = std::clamp((int) std::lround(std::log2(std::max(roots, 1.0))), kLeastRootBits,
                                kMostRootBits);
    tree.rootShift = kPlaceBits - bits;
    tree.tiles = 0;
    const uint32_t rootCount = setFaces(cone, 1 << bits, tree.faces);
    tree.nodes.resize(rootCount);

    std::vector<Sample> found(count / kStride);
    const Sampler sampler(tree, position);
    executor.forRange(found.size(), kSamplesPerPiece, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const uint32_t chance = (uint32_t) i * 2654435769u >> (32 - kStrideBits);
            found[i] = sampler(geometry.triangles[i * kStride + chance]);
        }
    });

    // Root by root.
    std::vector<size_t> ends(rootCount + 1);
    for (const Sample& sample : found)
        if (sample.root != kNoRoot) ++ends[sample.root + 1];
    for (uint32_t root = 0; root < rootCount; ++root) ends[root + 1] += ends[root];
    std::vector<Sample> samples(ends.back());
    std::vector<size_t> next = ends;
    for (const Sample& sample : found)
        if (sample.root != kNoRoot) samples[next[sample.root]++] = sample;
    Splitter splitter(tree, found);
    for (uint32_t root = 0; root < rootCount; ++root)
        splitter.split(root, {samples.data() + ends[root], samples.data() + ends[root + 1]}, 0);
}

} // namespace dirt
