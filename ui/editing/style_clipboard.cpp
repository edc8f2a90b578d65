// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editing/style_clipboard.h"

#include "app/session/selection_style.h"

namespace ui {
namespace {

std::optional<app::CopiedStyle>& copied()
{
    static std::optional<app::CopiedStyle> copied;
    return copied;
}

} // namespace

void copyStyle(const app::Session& session) { copied() = app::copiedStyle(session); }

bool hasCopiedStyle() { return copied().has_value(); }

void pasteStyle(app::Session& session)
{
    if (copied())
        app::pasteStyle(session, *copied());
}

} // namespace ui
