#pragma once

#include "app/cli/options.h"

namespace dirt {

/// Takes the options that every command with a scene has and this one has no use for (see the table
/// in option_scope.cpp) out of its help, and refuses them in one line; takes note of the others
/// that are given. Called when all are there; \p options must outlive the parsing.
void limitOptions(Command command, CommonOptions& options);

/// Throws InputError where an option was given that none of the command's backends honours.
void refuseIdleOptions(const CommonOptions& options);

/// Throws InputError where an option was given that the other choices leave without effect.
void refuseIdleOptions(const CommonOptions& options, const RenderSettings& settings);

} // namespace dirt
