#pragma once

#include "app/cli/json_report.h"
#include "core/verify/verify.h"

#include <cstdio>
#include <string>
#include <vector>

namespace dirt {

/// The header of verify's table.
void printVerifyHeader(std::FILE* file);

/// One kind's lines: a line for each backend, \p names in the order of the report's.
void printKind(std::FILE* file, const KindReport& report, const std::vector<std::string>& names);

/// The rays that the first backend got wrong, as hexadecimal floats in the grid frame, each with
/// the command that casts it again. \p scene is the command's SCENE.
void printWrongAnswers(std::FILE* file, const KindReport& report, const std::string& scene,
                       const Input& input, const VerifySettings& settings);

/// The value of one kind in the JSON object: the first backend's counts, and under their names,
/// blanks as underscores, the others'.
Json kindJson(const KindReport& report, const std::vector<std::string>& names);

} // namespace dirt
