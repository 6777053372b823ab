// Every variant of `verify --extremes` of the real scenes, in the long form.

#include "backend_cpu/cpu_backend.h"
#include "tests/extremes/verify_variants.h"
#include "tests/support/random.h"
#include "tests/verify/places.h"

namespace dirt {
namespace {

class ExtremesOfPlaces : public test::Extremes, public testing::WithParamInterface<test::Place> {};

TEST_P(ExtremesOfPlaces, AllAreRight) {
    if (!test::fullTests()) GTEST_SKIP() << "takes minutes: in the long form";
    auto scene = test::loadPlace(GetParam(), 300'000);
    if (!scene) GTEST_SKIP() << GetParam().file << " is not in " << scenesFolder();
    Spotlight light;
    light.position = scene->camera.eye, light.target = scene->camera.target;
    scene->lights = {light};
    CpuBackend cpu(pool_);
    emptyViews_ = true;
    verify(*scene, GetParam().name, ViewMode::full, cpu, 200);
}

INSTANTIATE_TEST_SUITE_P(Places, ExtremesOfPlaces, testing::ValuesIn(test::places()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace dirt
