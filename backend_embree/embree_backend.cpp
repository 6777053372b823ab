#include "backend_embree/embree_backend.h"

#include "backend_embree/filter.h"
#include "core/base/denormals.h"
#include "core/base/error.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace dirt {

namespace {

constexpr size_t kGrain = 1024; ///< rays traced in one piece

/// Backends may or may not flush denormals while they trace: none sees any.
Ray withoutDenormals(Ray ray) {
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = flushed(ray.origin[i]);
        ray.direction[i] = flushed(ray.direction[i]);
    }
    return ray;
}

/// Embree ends the program at numbers from 1.844e18 on, and loses rays whose direction is below
/// 1e-18 in all components.
constexpr float kLargestTaken = 0x1p60f, kLeastDirection = 0x1p-40f;

float largestOf(glm::vec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Whether Embree can be asked. An origin that far from everything hits nothing here.
bool isTaken(const Ray& ray) {
    return isTraceable(ray) && largestOf(ray.origin) <= kLargestTaken;
}

/// The power of two that a direction has to be divided by for Embree; nearly always 1.
float unitFor(glm::vec3 direction) {
    const float largest = largestOf(direction);
    if (largest >= kLeastDirection && largest <= kLargestTaken) return 1.0f;
    return std::ldexp(1.0f, std::min(std::ilogb(largest), 126));
}

/// How many of \p wanted threads can be made besides those there are: Embree's library ends the
/// program where it gets fewer than it was told.
unsigned possibleThreads(unsigned wanted) {
    std::vector<std::thread> threads;
    std::mutex held; // until all are there
    std::unique_lock lock(held);
    try {
        threads.reserve(wanted);
        while (threads.size() < wanted)
            threads.emplace_back([&held] { const std::lock_guard wait(held); });
    } catch (const std::exception&) { // no more are allowed
    }
    lock.unlock();
    for (std::thread& thread : threads) thread.join();
    return (unsigned) threads.size();
}

RTCRay toEmbree(const Ray& ray, float unit, float tfar) {
    const glm::vec3 direction = ray.direction / unit;
    RTCRay r{};
    r.org_x = ray.origin.x, r.org_y = ray.origin.y, r.org_z = ray.origin.z;
    r.dir_x = direction.x, r.dir_y = direction.y, r.dir_z = direction.z;
    r.tnear = 0.0f, r.tfar = tfar * unit;
    r.mask = ~0u;
    return r;
}

} // namespace

/// Embree's objects; the scene is null before the first build.
struct EmbreeBackend::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::atomic<int64_t> bytes{0}; ///< what Embree has allocated now
    std::string error;             ///< the first that Embree reported

    ~State() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void throwOnError(const char* doing) {
        if (rtcGetDeviceError(device) == RTC_ERROR_NONE) return;
        throw std::runtime_error(std::string("Embree failed ") + doing + ": " + error);
    }
};

EmbreeBackend::EmbreeBackend(Executor& executor, bool robust, EmbreeDecision decision,
                             EmbreeQuality quality)
    : HostBackend(executor), robust_(robust), decision_(decision), quality_(quality),
      state_(std::make_unique<State>()) {
    const unsigned threads = possibleThreads(executor.threads());
    if (threads == 0) throw CapabilityError("Embree needs a thread, and none can be made");
    const std::string config = "threads=" + std::to_string(threads);
    state_->device = rtcNewDevice(config.c_str());
    if (!state_->device) throw CapabilityError("Embree does not start on this machine");
    rtcSetDeviceErrorFunction(
        state_->device,
        [](void* state, RTCError, const char* text) {
            auto& error = static_cast<State*>(state)->error;
            if (error.empty() && text) error = text;
        },
        state_.get());
    rtcSetDeviceMemoryMonitorFunction(
        state_->device,
        [](void* state, ssize_t bytes, bool) {
            static_cast<State*>(state)->bytes += bytes;
            return true;
        },
        state_.get());
}

EmbreeBackend::~EmbreeBackend() = default;

std::string EmbreeBackend::name() const {
    return robust_ ? "embree robust" : "embree";
}

std::string EmbreeBackend::device() const {
    const auto version = rtcGetDeviceProperty(state_->device, RTC_DEVICE_PROPERTY_VERSION);
    return "Embree " + std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) +
           "." + std::to_string(version % 100) + ", " + std::to_string(executor_.threads()) +
           " threads";
}

void EmbreeBackend::clear(const Camera&, const GridSettings&) {
    if (state_->scene) rtcReleaseScene(state_->scene);
    state_->scene = nullptr;
}

void EmbreeBackend::fillPrimitives() {
    const FrameGeometry& geometry = *geometry_;
    State& state = *state_;
    state.scene = rtcNewScene(state.device);
    int flags = RTC_SCENE_FLAG_NONE;
    if (robust_) flags |= RTC_SCENE_FLAG_ROBUST;
    rtcSetSceneFlags(state.scene, (RTCSceneFlags) flags);

    // The scene's quality chooses a tree over the geometries' own, which are built at theirs.
    const RTCBuildQuality quality =
        quality_ == EmbreeQuality::low ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
    rtcSetSceneBuildQuality(state.scene, quality);

    // Embree reads 16 bytes at each vertex, which the triangle buffer does not have at its end,
    // so it gets a copy with its own padding.
    RTCGeometry mesh = rtcNewGeometry(state.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const size_t count = geometry.triangles.size();
    void* vertices = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(glm::vec3), 3 * count);
    auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), count));
    if (vertices && indices) {
        static_assert(sizeof(Triangle) == 3 * sizeof(glm::vec3));
        std::memcpy(vertices, geometry.triangles.data(), count * sizeof(Triangle));
        for (size_t i = 0; i < 3 * count; i++) indices[i] = (uint32_t) i;
    }
    if (decision_ == EmbreeDecision::core) {
        rtcSetGeometryIntersectFilterFunction(mesh, filterNearest);
        rtcSetGeometryOccludedFilterFunction(mesh, filterOccluded);
    } else {
        rtcSetGeometryIntersectFilterFunction(mesh, filterSkipped);
        rtcSetGeometryOccludedFilterFunction(mesh, filterSkipped);
    }
    rtcSetGeometryBuildQuality(mesh, quality);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(state.scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(state.scene);
    state.throwOnError("to build");
}

void EmbreeBackend::intersect(std::span<const Ray> rays, std::span<Hit> hits) {
    const auto nearest = [&](const Ray& given) -> Hit {
        const Ray ray = withoutDenormals(given);
        if (!isTaken(ray)) return {};
        constexpr float kFar = std::numeric_limits<float>::infinity();
        QueryContext query(*geometry_, ray, kFar, unitFor(ray.direction));
        RTCRayHit result{toEmbree(ray, query.unit, kFar), {}};
        result.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(state_->scene, &query.embree, &result);
        if (decision_ == EmbreeDecision::core) return query.best;
        if (result.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        const float t = flushed(result.ray.tfar / query.unit);
        return {result.hit.primID, t, result.hit.u, result.hit.v, 0, 0};
    };
    executor_.forRange(rays.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; i++) hits[i] = nearest(rays[i]);
    });
}

void EmbreeBackend::occluded(std::span<const Ray> rays, std::span<const float> maxT,
                             std::span<uint8_t> result) {
    const auto blocked = [&](const Ray& given, float limit) -> bool {
        const Ray ray = withoutDenormals(given);
        if (!isTaken(ray) || !(limit > 0.0f)) return false;
        QueryContext query(*geometry_, ray, limit, unitFor(ray.direction));
        const bool core = decision_ == EmbreeDecision::core;
        RTCRay r = toEmbree(ray, query.unit, core ? limit * kLookBehind : limit);
        rtcOccluded1(state_->scene, &query.embree, &r);
        return r.tfar < 0.0f; // Embree's mark of an occluded ray
    };
    executor_.forRange(rays.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; i++) result[i] = blocked(rays[i], maxT[i]) ? 1 : 0;
    });
}

std::vector<BufferSize> EmbreeBackend::memory() const {
    std::vector<BufferSize> sizes = HostBackend::memory();
    sizes.emplace(sizes.begin() + 1, "embree scene", (uint64_t) state_->bytes.load());
    return sizes;
}

} // namespace dirt
