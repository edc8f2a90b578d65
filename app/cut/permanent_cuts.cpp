// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/permanent_cuts.h"

#include "app/cut/occlude.h"
#include "app/cut/split.h"

#include <QtGlobal>

#include <algorithm>
#include <array>

namespace app {
namespace {

Cut cutOut(const Document& document, const CutOptions& options, const Follower& follower)
{
    CutOptions outside = options;
    outside.region = withKeep(options.region, Keep::Outside);
    Cut made = cut(document, outside, follower);
    if (!made.edit.splices.empty() && document.windows().keep == Keep::Inside) {
        made.edit.windows = document.windows();
        made.edit.windows->keep = Keep::Outside; // or what is left would not be seen
    }
    return made;
}

constexpr std::array kinds{
    PermanentCut{"crop", QT_TRANSLATE_NOOP("Text", "Crop to windows"),
                 QT_TRANSLATE_NOOP("Text", "Cropped: %1"),
                 QT_TRANSLATE_NOOP("Text", "Nothing was cropped"),
                 QT_TRANSLATE_NOOP("Text", "the clip window keeps all of the drawing."), cut},
    PermanentCut{"cut-out", QT_TRANSLATE_NOOP("Text", "Cut out windows"),
                 QT_TRANSLATE_NOOP("Text", "Cut out: %1"),
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
