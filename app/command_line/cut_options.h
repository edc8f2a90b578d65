// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/parsed_arguments.h"
#include "app/cut/cut.h"

namespace app {

/// How `clip` cuts objects at its windows: --close, --min-length, --leave-hidden, --occlude,
/// --coincident and --strokes-as-areas.
std::vector<Option> cuttingOptions();

/// Sets what the options say. Throws WrongUsage.
void takeCuttingOptions(const ParsedArguments& arguments, const Page& page, CutOptions& options);

/// With --occlude, removes what filled shapes cover, and returns the counts.
std::optional<CutCounts> occludeIfWanted(const ParsedArguments& arguments,
                                         const CutOptions& options, Document& document);

/// With --strokes-as-areas, turns all strokes into areas. Throws WrongUsage beside --occlude.
void makeAreasIfWanted(const ParsedArguments& arguments, Document& document);

/// The report's sentence on covered lines: how many were removed.
QString occlusionText(const CutCounts& counts);
/// The report's first sentence, without its full stop: how many shapes were kept, cut and removed,
/// and how many only touch the windows, which leaves points, or nothing.
QString shapesText(const CutCounts& counts, bool keepsContacts);
/// Says that nothing is left of a drawing, and where the drawing is (`placeText`).
QString nothingLeftText(Keep keep, const QString& place, const CutCounts& counts);
/// The sentences on dropped pieces, locked layers that were cut, and wide strokes; empty without
/// them.
QString furtherCountsText(const CutCounts& counts);

} // namespace app
