// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/permanent_cuts.h"

#include "app/cut/occlude.h"
#include "app/cut/split.h"

#include <QtGlobal>

#include <algorithm>
#include <array>

namespace app {
namespace {

/// Hides the windows that have cut, so that all that is left is seen.
Cut withWindowsHidden(Cut made, const Document& document)
{
    if ((made.edit.splices.empty() && !made.edit.containers) || !cuts(document.windows()))
        return made;
    made.edit.windows = document.windows();
    for (ClipWindow& window : made.edit.windows->list) // or one of them would no longer be replaced
        window.visible = false;
    return made;
}

Cut crop(const Document& document, const CutOptions& options, const Follower& follower)
{
    return withWindowsHidden(cut(document, options, follower), document);
}

Cut cutOut(const Document& document, const CutOptions& options, const Follower& follower)
{
    CutOptions outside = options;
    outside.region = withKeep(options.region, Keep::Outside);
    return withWindowsHidden(cut(document, outside, follower), document);
}

constexpr std::array kinds{
    PermanentCut{"crop", QT_TRANSLATE_NOOP("Text", "Crop to windows"),
                 QT_TRANSLATE_NOOP("Text", "Cropped: %1 The clip windows are hidden now."),
                 QT_TRANSLATE_NOOP("Text", "Nothing was cropped"),
                 QT_TRANSLATE_NOOP("Text", "the clip window keeps all of the drawing."), crop},
    PermanentCut{"cut-out", QT_TRANSLATE_NOOP("Text", "Cut out windows"),
                 QT_TRANSLATE_NOOP("Text", "Cut out: %1 The clip windows are hidden now."),
                 QT_TRANSLATE_NOOP("Text", "Nothing was cut out"),
                 QT_TRANSLATE_NOOP("Text", "no object is inside the clip windows."), cutOut},
    PermanentCut{"split", QT_TRANSLATE_NOOP("Text", "Split at windows"),
                 QT_TRANSLATE_NOOP(
                     "Text", "Split: %1 What is outside the clip windows is on layers of its own, "
                             "named “…, outside”."),
                 QT_TRANSLATE_NOOP("Text", "Nothing was split"),
                 QT_TRANSLATE_NOOP("Text", "no object is outside the clip windows."), split},
    PermanentCut{"occlude", QT_TRANSLATE_NOOP("Text", "Remove covered lines"),
                 QT_TRANSLATE_NOOP("Text", "Covered lines removed: %1"),
                 QT_TRANSLATE_NOOP("Text", "No covered lines were removed"),
                 QT_TRANSLATE_NOOP("Text", "no object is filled."), occlude},
};

} // namespace

std::span<const PermanentCut> permanentCuts() { return kinds; }

const PermanentCut& permanentCut(std::string_view key)
{
    return *std::ranges::find(kinds, key, &PermanentCut::key);
}

} // namespace app
