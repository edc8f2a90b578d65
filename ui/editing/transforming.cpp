// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editing/transforming.h"

#include "app/view/handles.h"

#include <QCoreApplication>

namespace ui {

void turnSelection(app::Session& session, Turn turn)
{
    const auto bounds = session.selectionBounds();
    if (!bounds)
        return;
    const app::Point middle = app::placeOf(app::Handle{}, *bounds);
    const std::array maps{app::rotation(90, middle), app::rotation(-90, middle),
                          app::scaling({-1, 1}, middle), app::scaling({1, -1}, middle)};
    const bool flips = turn == Turn::FlipAcross || turn == Turn::FlipDown;
    const QString text = flips ? QCoreApplication::translate("Editing", "Flip selection")
                               : QCoreApplication::translate("Editing", "Rotate selection");
    session.history.push(new app::TransformObjects(session.document, session.selection(),
                                                   maps[std::size_t(turn)],
                                                   app::StrokeScaling::Keep, text));
}

} // namespace ui
