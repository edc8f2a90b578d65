// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/tiles_page.h"

#include "ui/look/text.h"
#include "ui/tiles/tiles_bar.h"
#include "ui/tiles/tiles_sheet.h"

#include <QHBoxLayout>
#include <QKeyEvent>

namespace ui {

namespace {

constexpr int usualWindow = 1280; // pixels

} // namespace

TilesPage::TilesPage(app::Session& session, app::LiveSheets& sheets, QWidget* parent)
    : QWidget(parent), session_(session), sheets_(sheets), bar_(new TilesBar),
      view_(new TilesView(session, sheets, app::SheetArrangement::Apart)),
      overview_(
          new TilesView(session, sheets, app::SheetArrangement::InPlace, TilesView::Use::Overview)),
      sheet_(new TilesSheet(session, sheets, *overview_))
{
    setAccessibleName(Text::tr("Tiles"));
    auto* across = new QHBoxLayout;
    across->setSpacing(0);
    across->addWidget(view_, 1);
    across->addWidget(sheet_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar_);
    column->addLayout(across, 1);
    sheet_->fitTo(usualWindow);
    bar_->show(view_->arrangement(), view_->tintsOverlaps());
    connect(bar_, &TilesBar::arranged, view_, &TilesView::arrange);
    connect(bar_, &TilesBar::tinted, view_, &TilesView::tintOverlaps);
    connect(bar_, &TilesBar::fitWanted, view_, &TilesView::fit);
    connect(sheet_, &TilesSheet::closeWanted, this, &TilesPage::closeWanted);
    connect(sheet_, &TilesSheet::exportWanted, this, &TilesPage::exportWanted);
    connect(sheet_, &TilesSheet::entered, view_, [this] { view_->setFocus(); });
    connect(view_, &TilesView::hinted, this, &TilesPage::hinted);
    connect(overview_, &TilesView::hinted, this, &TilesPage::hinted);
    connect(&sheets, &app::LiveSheets::changed, this, &TilesPage::tellHint);
}

void TilesPage::tellHint()
{
    if (!isVisible())
        return;
    emit hinted(
        sheets_.settings().byNumber
            ? Text::tr("Click a sheet to leave it out. Drag to move the view.")
            : Text::tr("Drag the edge between two sheets to shift the cuts. Click a sheet to "
                       "leave it out."));
}

SheetsSection& TilesPage::sheetsSection() { return sheet_->sheetsSection(); }

void TilesPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    sheet_->fitTo(window()->width());
    layout()->activate();
}

void TilesPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    view_->setFocus();
    tellHint();
}

/// What no field took.
void TilesPage::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        return emit closeWanted();
    QWidget::keyPressEvent(event);
}

} // namespace ui

#include "moc_tiles_page.cpp"
