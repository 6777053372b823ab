#include "core/replay/judged_pass.h"

#include <algorithm>

namespace dirt {

uint64_t JudgedPass::wrong() const {
    uint64_t sum = 0;
    for (const auto& [sort, count] : faults) sum += count;
    return sum;
}

uint64_t& JudgedPass::countOf(const std::string& sort) {
    const auto at = std::find_if(faults.begin(), faults.end(),
                                 [&](const auto& known) { return known.first == sort; });
    return at != faults.end() ? at->second : faults.emplace_back(sort, 0).second;
}

void JudgedPass::add(const JudgedPass& other) {
    if (other.wrong() > 0 && (wrong() == 0 || other.place < place)) {
        place = other.place;
        first = other.first;
    }
    compared += other.compared;
    right += other.right;
    inherited += other.inherited;
    outside += other.outside;
    largestTError = std::max(largestTError, other.largestTError);
    for (const auto& [sort, count] : other.faults) countOf(sort) += count;
}

void JudgedPass::addPieces(Executor& executor, size_t count, size_t grain,
                           const std::function<JudgedPass(size_t begin, size_t end)>& judge) {
    std::vector<JudgedPass> pieces((count + grain - 1) / grain);
    executor.forRange(count, grain,
                      [&](size_t begin, size_t end) { pieces[begin / grain] = judge(begin, end); });
    for (const JudgedPass& piece : pieces) add(piece);
}

std::string JudgedPass::name() const {
    return event < 0 ? pass : pass + " " + std::to_string(event);
}

const JudgedPass* firstWrong(const std::vector<JudgedPass>& passes) {
    for (const JudgedPass& pass : passes)
        if (pass.wrong() > 0) return &pass;
    return nullptr;
}

} // namespace dirt
