#pragma once

#include "app/cli/json_report.h"
#include "core/verify/verify.h"

#include <cstdio>
#include <string>
#include <vector>

namespace dirt {

/// In words.
const char* word(Grade grade);

/// The header of verify's table.
void printVerifyHeader(std::FILE* file);

/// One kind's lines: a line for each backend, \p names in the order of the report's.
void printKind(std::FILE* file, const KindReport& report, const std::vector<std::string>& names);

/// Rays that the first backend got wrong, as hexadecimal floats in the grid frame.
void printWrongAnswers(std::FILE* file, const std::vector<WrongAnswer>& wrong);

/// The lines that say how to repeat what went wrong, and how to look at the first of it.
void printAgain(std::FILE* file, const std::string& command);
void printLook(std::FILE* file, const CommonOptions& options, const Input& input,
               const WrongAnswer& wrong);

/// The command that casts the same rays, with everything said that shapes them but their kind.
std::string verifyCommand(const CommonOptions& options, const Input& input,
                          const VerifySettings& settings);

/// What reports call the backends, of which the first is under test.
std::vector<std::string> verifiedNames(const std::vector<Tracer*>& backends);

/// A backend's name as a key.
std::string jsonKey(std::string name);

Json countsJson(const BackendReport& backend);

/// The value of one kind in the JSON object: the first backend's counts, and under their names,
/// blanks as underscores, the others'.
Json kindJson(const KindReport& report, const std::vector<std::string>& names);

} // namespace dirt
