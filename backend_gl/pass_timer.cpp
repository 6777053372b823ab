#include "backend_gl/pass_timer.h"

namespace dirt {
namespace {

/// Marks that are under way at once, at most.
constexpr size_t kMostPending = 1024;

} // namespace

PassTimer::PassTimer() {
    GLint bits = 0;
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    works_ = bits > 0;
}

void PassTimer::mark() {
    if (!works_) return;
    if (pending_.size() == kMostPending) collect();
    if (free_.empty()) {
        GLuint id = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &id);
        free_.emplace_back(id);
    }
    glQueryCounter(free_.back().id(), GL_TIMESTAMP);
    pending_.push_back(std::move(free_.back()));
    free_.pop_back();
}

void PassTimer::collect() {
    for (GlObject<QueryKind>& query : pending_) {
        GLuint64 mark = 0;
        glGetQueryObjectui64v(query.id(), GL_QUERY_RESULT, &mark);
        marks_.push_back(mark);
        free_.push_back(std::move(query));
    }
    pending_.clear();
}

std::vector<double> PassTimer::take() {
    collect();
    std::vector<double> times;
    if (marks_.size() % 2 == 0)
        for (size_t i = 0; i < marks_.size(); i += 2)
            times.push_back((double) (marks_[i + 1] - marks_[i]) * 1e-6);
    marks_.clear();
    return times;
}

} // namespace dirt
