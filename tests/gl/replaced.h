#pragma once

#include <epoxy/gl.h>

/// Functions of the driver that a test puts its own in place of.
namespace dirt::test {

/// While it lives, \p function (one of epoxy's pointers, called before) is another one.
template <typename Function>
class Replaced {
public:
    Replaced(Function*& function, Function* other) : function_(function), real_(function) {
        function_ = other;
    }
    ~Replaced() { function_ = real_; }
    Replaced(const Replaced&) = delete;
    Replaced& operator=(const Replaced&) = delete;

private:
    Function*& function_;
    Function* real_;
};

} // namespace dirt::test
