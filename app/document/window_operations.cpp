// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/window_operations.h"

#include "app/base/text.h"

#include <algorithm>
#include <array>

namespace app {

std::span<const WindowOperationInfo> windowOperations()
{
    static const std::array all{
        WindowOperationInfo{WindowOperation::Add,
                            "add",
                            "window-adds",
                            "window-add",
                            "+",
                            "+",
                            Text::tr("Add"),
                            Text::tr("adds"),
                            Text::tr("&Add to those above"),
                            Text::tr("Add the window to those above it"),
                            Text::tr("Add %1"),
                            Text::tr("add %1"),
                            {}},
        WindowOperationInfo{WindowOperation::CutOut,
                            "cut-out",
                            "window-cuts-out",
                            "window-cut-out",
                            "-",
                            QString(u'\u2212'),
                            Text::tr("Cut out"),
                            Text::tr("cuts out"),
                            Text::tr("Cut out of t&hose above"),
                            Text::tr("Cut the window out of those above it"),
                            Text::tr("Cut out %1"),
                            Text::tr("cut out %1"),
                            {7, 4}},
        WindowOperationInfo{WindowOperation::Intersect,
                            "intersect",
                            "window-intersects",
                            "window-intersect",
                            "*",
                            QString(u'\u2229'),
                            Text::tr("Intersect"),
                            Text::tr("intersects"),
                            Text::tr("Int&ersect with those above"),
                            Text::tr("Keep what the window has in common with those above it"),
                            Text::tr("Intersect with %1"),
                            Text::tr("intersect %1"),
                            {2, 3},
                            true},
        WindowOperationInfo{WindowOperation::Replace,
                            "replace",
                            "window-replaces",
                            "window-replace",
                            "=",
                            "=",
                            Text::tr("Replace"),
                            Text::tr("replaces"),
                            Text::tr("Rep&lace those above"),
                            Text::tr("Let the window count alone: those above it have no effect"),
                            Text::tr("Replace with %1"),
                            Text::tr("replace by %1"),
                            {},
                            true},
    };
    return all;
}

const WindowOperationInfo& infoOf(WindowOperation operation)
{
    return windowOperations()[std::size_t(operation)];
}

std::optional<WindowOperation> windowOperation(std::string_view word)
{
    const auto all = windowOperations();
    const auto found = std::ranges::find(all, word, &WindowOperationInfo::word);
    return found == all.end() ? std::nullopt : std::optional(found->operation);
}

} // namespace app
