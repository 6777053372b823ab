#pragma once

#include <stdexcept>
#include <string>

namespace dirt {

/// Bad input, option or output: one clear line, "file:line: what is wrong" where there is a file.
/// The program ends with exit status 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A capability this build or machine lacks (Embree, GL). Exit status 3.
struct CapabilityError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace dirt
