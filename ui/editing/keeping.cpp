// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editing/keeping.h"

#include "app/commands/set_page_parts.h"
#include "app/session/window_places.h"
#include "ui/look/text.h"

#include <QCoreApplication>

namespace ui {

void setKeep(app::Session& session, app::Keep keep)
{
    app::ClipWindows windows = session.now().windows();
    if (windows.keep == keep)
        return;
    windows.keep = keep;
    const char* const text = keep == app::Keep::Inside ? QT_TRANSLATE_NOOP("Text", "Keep inside")
                                                       : QT_TRANSLATE_NOOP("Text", "Keep outside");
    session.history.push(new app::SetWindows(session.document, std::move(windows), Text::tr(text)));
}

void keepOtherSide(app::Session& session)
{
    const bool inside = session.now().windows().keep == app::Keep::Inside;
    setKeep(session, inside ? app::Keep::Outside : app::Keep::Inside);
}

void layWindowOnPage(app::Session& session)
{
    app::layWindow(session, app::windowPlaces().front());
}

} // namespace ui
