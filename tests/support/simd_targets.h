#pragma once

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace dirt::test {

/// Each instruction set in turn, and the best again in the end.
template <class Body>
void forEachTarget(Body&& body) {
    std::vector<int64_t> targets;
    for (int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1)
        targets.push_back(rest & -rest);
    for (const int64_t target : targets) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        SCOPED_TRACE(hwy::TargetName(target));
        body();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    EXPECT_GT(targets.size(), 1u);
}

} // namespace dirt::test
