// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"

namespace app {

/// How a person wants drawings to be cut.
struct CutChoices {
    bool closeAreas = false;     ///< CutOptions::closeAreas
    bool cutHidden = false;      ///< cuts of the drawing itself change hidden objects, too
    double leastMillimetres = 0; ///< CutOptions::leastLength, on paper
    friend bool operator==(const CutChoices&, const CutChoices&) = default;
};

/// The options for a cut whose result is written to a file: all objects are cut.
inline CutOptions exportOptions(const CutChoices& choices, const Page& page)
{
    return {.closeAreas = choices.closeAreas,
            .leastLength = choices.leastMillimetres / page.millimetresPerUnit()};
}

/// The options for a cut of the drawing itself: locked objects stay whole.
inline CutOptions permanentOptions(const CutChoices& choices, const Page& page)
{
    CutOptions options = exportOptions(choices, page);
    options.leaveLocked = true;
    options.leaveHidden = !choices.cutHidden;
    return options;
}

} // namespace app
