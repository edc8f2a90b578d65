// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/parsed_arguments.h"
#include "app/cut/cut.h"

namespace app {

/// --close, --min-length, --leave-hidden and --occlude: how `clip` cuts objects at its windows.
std::vector<Option> cuttingOptions();

/// Sets what the options say. Throws WrongUsage.
void takeCuttingOptions(const ParsedArguments& arguments, const Page& page, CutOptions& options);

/// With --occlude, removes what filled shapes cover, and returns the counts.
std::optional<CutCounts> occludeIfWanted(const ParsedArguments& arguments,
                                         const CutOptions& options, Document& document);

/// What the report says of covered lines.
QString occlusionText(const CutCounts& counts);
/// Of dropped pieces and locked layers; empty if there are none.
QString furtherCountsText(const CutCounts& counts);

} // namespace app
