// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"

#include <string_view>

namespace app {

/// A way to cut a drawing permanently, at its clip windows or below its areas: a command of the
/// menu and a step of the history. The texts are to be translated.
struct PermanentCut {
    std::string_view key;
    const char* name;    ///< of the command and the step: "Crop to windows"
    const char* done;    ///< "Cropped: %1"
    const char* nothing; ///< what is said if no object changes: "Nothing was cropped"
    const char* why;     ///< usually: "the clip window keeps all of the drawing."
    /// When a stop is requested, the result is of no use.
    Cut (*make)(const Document& document, const CutOptions& options, const Follower& follower);
};

/// All of them, in the order of menus.
std::span<const PermanentCut> permanentCuts();
const PermanentCut& permanentCut(std::string_view key); ///< which must exist

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
