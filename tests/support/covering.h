#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace dirt::test {

/// One choice of every factor, as indices.
using Choice = std::vector<int>;

/// The pairs (factor and value, factor and value) of \p choice.
inline std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> pairsOf(const Choice& choice) {
    std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> pairs;
    for (int i = 0; i < (int) choice.size(); ++i)
        for (int j = i + 1; j < (int) choice.size(); ++j)
            pairs.insert({{i, choice[(size_t) i]}, {j, choice[(size_t) j]}});
    return pairs;
}

/// All choices of factors with \p values values each, the last factor changing fastest.
inline std::vector<Choice> fullProduct(const std::vector<int>& values) {
    std::vector<Choice> all{{}};
    for (int count : values) {
        std::vector<Choice> longer;
        for (const Choice& choice : all)
            for (int value = 0; value < count; ++value) {
                longer.push_back(choice);
                longer.back().push_back(value);
            }
        all = std::move(longer);
    }
    return all;
}

/// Few choices such that every pair of values of any two factors occurs in one of them: always the
/// choice with most pairs that are new, of these the first.
inline std::vector<Choice> pairwiseCovering(const std::vector<int>& values) {
    const std::vector<Choice> all = fullProduct(values);
    std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> missing;
    for (const Choice& choice : all) missing.merge(pairsOf(choice));
    std::vector<Choice> chosen;
    while (!missing.empty()) {
        const Choice* best = nullptr;
        size_t most = 0;
        for (const Choice& choice : all) {
            const auto pairs = pairsOf(choice);
            const auto fresh =
                (size_t) std::count_if(pairs.begin(), pairs.end(),
                                       [&](const auto& pair) { return missing.contains(pair); });
            if (fresh > most) most = fresh, best = &choice;
        }
        for (const auto& pair : pairsOf(*best)) missing.erase(pair);
        chosen.push_back(*best);
    }
    return chosen;
}

} // namespace dirt::test
