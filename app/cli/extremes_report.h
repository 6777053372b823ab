#pragma once

#include "app/cli/json_report.h"
#include "core/verify/verify_extremes.h"

#include <cstdio>
#include <string>
#include <vector>

namespace dirt {

/// Over all variants.
struct ExtremesSum {
    uint64_t variants = 0, leftOut = 0, wrong = 0; ///< of these, in which the first backend was not
                                                   ///< right
    uint64_t rays = 0;

    void add(const ExtremeReport& report);
};

/// The header of the table of variants.
void printExtremesHeader(std::FILE* file);

/// A variant's lines: a line for each backend, \p names in the order of the report's.
void printExtreme(std::FILE* file, const ExtremeReport& report,
                  const std::vector<std::string>& names);

void printSum(std::FILE* file, const ExtremesSum& sum);

/// The value of one variant in the JSON object: the first backend's counts, and under their names,
/// blanks as underscores, the others'.
Json extremeJson(const ExtremeReport& report, const std::vector<std::string>& names);

} // namespace dirt
