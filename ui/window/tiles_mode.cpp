// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/tiles_mode.h"

#include "ui/canvas/canvas.h"
#include "ui/tiles/tiles_page.h"
#include "ui/window/centre.h"

#include <QApplication>

namespace ui {

TilesMode::TilesMode(app::Session& session, app::LiveSheets& sheets, Canvas& canvas, Centre& centre)
    : session_(session), sheets_(sheets), canvas_(canvas), centre_(centre)
{
}

void TilesMode::enter()
{
    canvas_.endGesture();
    focusBefore_ = QApplication::focusWidget();
    if (centre_.tiles())
        return;
    auto* page = new TilesPage(session_, sheets_);
    centre_.setTiles(page);
    connect(page, &TilesPage::closeWanted, &sheets_, &app::LiveSheets::close);
    emit made(page);
}

void TilesMode::returnFocus()
{
    (focusBefore_ && focusBefore_->isVisible() ? focusBefore_.data() : &canvas_)->setFocus();
}

} // namespace ui

#include "moc_tiles_mode.cpp"
