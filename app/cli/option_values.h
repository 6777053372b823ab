#pragma once

#include "app/cli/command.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

// Options whose values are read by rules of our own: the whole text must be a value, and the error
// is one line that names the option, the text and what would have been right.

/// A whole number from \p low to \p high.
Option addInteger(Command command, const std::string& name, int64_t low, int64_t high,
                  const std::string& help, const std::function<void(int64_t)>& set);

/// \p count whole numbers from 0 to \p high with commas between. Throws InputError.
std::vector<int> readIntegers(const std::string& name, const std::string& text, size_t count,
                              int high, const std::string& typeName);

/// The same as an option, shown as \p typeName.
Option addIntegers(Command command, const std::string& name, size_t count, int high,
                   const std::string& typeName, const std::string& help,
                   const std::function<void(const std::vector<int>&)>& set);

/// A finite number above \p low and below \p high.
Option addNumber(Command command, const std::string& name, float low, float high,
                 const std::string& help, const std::function<void(float)>& set);

/// \p count (six at most) numbers that are finite in float32, with commas between, shown as \p
/// typeName.
Option addNumbers(Command command, const std::string& name, size_t count,
                  const std::string& typeName, const std::string& help,
                  const std::function<void(const std::vector<double>&)>& set);

/// Three numbers X,Y,Z that are finite in float32.
Option addVector(Command command, const std::string& name, const std::string& help,
                 const std::function<void(glm::dvec3)>& set);

/// One word of several; \p set gets its index.
Option addChoice(Command command, const std::string& name, const std::vector<std::string>& words,
                 const std::string& help, const std::function<void(size_t)>& set);

/// Text of the form WxH, two whole numbers from 1 to \p high.
Option addSize(Command command, const std::string& name, int high, const std::string& help,
               const std::function<void(int width, int height)>& set);

/// Text of the form A:B, two whole numbers from 0 to \p high of which the second is not less.
Option addRange(Command command, const std::string& name, int high, const std::string& help,
                const std::function<void(int first, int last)>& set);

/// Text of a number of bytes: 12G, 1.5GB, 800M; of powers of 1000. At least a megabyte.
Option addBytes(Command command, const std::string& name, const std::string& help,
                const std::function<void(uint64_t)>& set);

} // namespace dirt
