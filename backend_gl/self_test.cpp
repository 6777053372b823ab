#include "backend_gl/self_test.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace dirt {
namespace {

/// Floats with full mantissas and exponents from -30 to 1; some pairs nearly cancel.
std::vector<float> testValues() {
    std::vector<float> values;
    uint32_t state = 1;
    const auto next = [&state] { return state = state * 1664525u + 1013904223u; };
    for (int i = 0; i < kSelfTestCases; ++i) {
        float v[3];
        for (float& x : v) {
            const float mantissa = (float) (next() >> 8) * 0x1p-24f + 1.0f; // 24 random bits
            const int exponent = (int) (next() >> 27) - 30;
            x = std::ldexp(next() >> 31 ? mantissa : -mantissa, exponent);
        }
        // Where a product is fused with this sum, what is left is its rounding error.
        if (i % 2) v[2] = -(v[0] * v[1]);
        values.insert(values.end(), v, v + 3);
    }
    return values;
}

/// What include/self_test.glsl computes: floats and doubles.
std::array<uint32_t, 8> expected(const float* v) {
    const float product = v[0] * v[1], difference = v[0] - v[2], sum = product + v[2];
    const double exact = (double) v[0] * v[1];
    const float rounded = (float) (exact + v[2]);
    const double quotient = (exact * v[2] * v[0] + v[1]) / v[2];
    const auto bits = [](float x) { return std::bit_cast<uint32_t>(x); };
    const auto low = [](double x) { return (uint32_t) std::bit_cast<uint64_t>(x); };
    const auto high = [](double x) { return (uint32_t) (std::bit_cast<uint64_t>(x) >> 32); };
    return {bits(product), bits(difference), bits(sum),     bits(rounded),
            low(exact),    high(exact),      low(quotient), high(quotient)};
}

} // namespace

std::string arithmeticFaults(Programs& programs) {
    const std::vector<float> values = testValues();
    const GlBuffer input(values.size() * sizeof(float), values.data());
    constexpr int kStages = 4;
    using Results = std::array<uint32_t, 8 * kStages>;
    const GlBuffer output(sizeof(Results) * kSelfTestCases);

    const GlVertexArray points = makeVertexArray();
    glEnableVertexArrayAttrib(points.id(), 0);
    glVertexArrayAttribFormat(points.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(points.id(), 0, 0);
    glVertexArrayVertexBuffer(points.id(), 0, input.id(), 0, 3 * sizeof(float));
    const GlFramebuffer line = makeFramebuffer(); // without pictures: a fragment for each case
    glNamedFramebufferParameteri(line.id(), GL_FRAMEBUFFER_DEFAULT_WIDTH, kSelfTestCases);
    glNamedFramebufferParameteri(line.id(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, line.id());
    glViewport(0, 0, kSelfTestCases, 1);
    glBindVertexArray(points.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, output.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, input.id());
    programs.use(selfTestRasterSource());
    glDrawArrays(GL_POINTS, 0, kSelfTestCases);
    programs.use(selfTestComputeSource());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);

    std::vector<Results> results(kSelfTestCases);
    output.read(0, output.bytes(), results.data());
    std::string faults;
    const char* const names[kStages] = {"vertex", "geometry", "fragment", "compute"};
    for (int stage = 0; stage < kStages; ++stage) {
        bool right = true;
        for (int i = 0; i < kSelfTestCases; ++i) {
            const auto want = expected(&values[(size_t) i * 3]);
            for (size_t k = 0; k < want.size(); ++k)
                right = right && results[(size_t) i][(size_t) stage * 8 + k] == want[k];
        }
        if (!right) faults += (faults.empty() ? "" : ", ") + std::string(names[stage]);
    }
    return faults;
}

} // namespace dirt
