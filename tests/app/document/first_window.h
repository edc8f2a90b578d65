// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include "tests/app/document/sheet.h"

inline app::Sheet sheetAt(const clipping::Window& window)
{
    app::Sheet sheet;
    sheet.window = window;
    return sheet;
}

/// Shows or hides the first clip window.
inline void setVisible(app::Session& session, bool visible)
{
    app::Edit edit;
    edit.windows = session.now().windows();
    edit.windows->list.at(0).visible = visible;
    session.document.apply(edit);
}
