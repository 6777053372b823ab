#pragma once

#include <stdexcept>
#include <string>

namespace dirt {

/// Bad input, option or output: one clear line, "file:line: what is wrong" where there is a file.
/// The program ends with exit status 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// More memory than there may be: a bad input that no stand-in replaces.
struct MemoryError : InputError {
    using InputError::InputError;
};

/// A capability this build or machine lacks (Embree, GL). Exit status 3.
struct CapabilityError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace dirt
