#pragma once

#include "core/base/error.h"

#include <string>

namespace dirt {

/// The text of the InputError that \p body throws; empty where it throws none.
template <typename Body>
std::string inputError(Body&& body) {
    try {
        body();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace dirt
