// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/parsed_arguments.h"
#include "app/document/document.h"

namespace app {

/// --layer and --fit-paper, of commands that write a drawing.
std::vector<Option> partOptions();

/// The part of a drawing that a command works on.
struct DrawingPart {
    Document drawing;
    std::vector<std::uint32_t> rows; ///< Imported::rows of its objects
};
/// The drawing, or with --layer only what is seen of that layer. Throws Failure if no layer has
/// this name.
DrawingPart chosenPart(const ParsedArguments& arguments, const Imported& imported);

/// With --fit-paper the page becomes just as large as what these windows keep, or without any as
/// what is drawn. Throws Failure if there is nothing that has a size.
void fitPaper(const ParsedArguments& arguments, const ClipWindows& windows, Document& drawing);

} // namespace app
