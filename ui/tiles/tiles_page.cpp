// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/tiles_page.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/tiles/files_section.h"
#include "ui/tiles/marks_section.h"
#include "ui/tiles/sheets_section.h"
#include "ui/tiles/tiles_bar.h"
#include "ui/widgets/elements.h"

#include <QKeyEvent>
#include <QPushButton>
#include <QScrollArea>

namespace ui {
namespace {

constexpr int columnWidth = 336, leastOverview = 60; // pixels

/// The whole drawing with all sheets, small.
class OverviewSection : public Section {
public:
    OverviewSection(const QString& title, QWidget* view) : Section(title)
    {
        view->setMinimumHeight(leastOverview);
        view->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
        addWide(view);
        grid().setRowStretch(grid().rowCount() - 1, 1);
    }
};

// However low the window is, the button is seen.
QWidget* withButtonBelow(QWidget* sections, QWidget* button)
{
    auto* page = new QWidget;
    page->setBackgroundRole(QPalette::AlternateBase);
    page->setAutoFillBackground(true);
    auto* below = new QVBoxLayout;
    below->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                              space::labelToField);
    below->addWidget(button);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(sections, 1);
    column->addLayout(below);
    return page;
}

} // namespace

TilesPage::TilesPage(app::Session& session, app::LiveSheets& sheets, QWidget* parent)
    : QWidget(parent), session_(session), sheets_(sheets), bar_(new TilesBar),
      view_(new TilesView(session, sheets, app::SheetArrangement::Apart)),
      overview_(
          new TilesView(session, sheets, app::SheetArrangement::InPlace, TilesView::Use::Overview)),
      sheetsSection_(new SheetsSection(session, sheets))
{
    setAccessibleName(Text::tr("Tiles"));
    auto* across = new QHBoxLayout;
    across->setSpacing(0);
    across->addWidget(view_, 1);
    across->addWidget(rule(Qt::Vertical));
    across->addWidget(makeColumn());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar_);
    column->addLayout(across, 1);
    bar_->show(view_->arrangement(), view_->tintsOverlaps());
    connect(bar_, &TilesBar::arranged, view_, &TilesView::arrange);
    connect(bar_, &TilesBar::tinted, view_, &TilesView::tintOverlaps);
    connect(bar_, &TilesBar::fitWanted, view_, &TilesView::fit);
    connect(bar_, &TilesBar::closeWanted, this, &TilesPage::closeWanted);
    connect(view_, &TilesView::hinted, this, &TilesPage::hinted);
    connect(overview_, &TilesView::hinted, this, &TilesPage::hinted);
    connect(&sheets, &app::LiveSheets::changed, this, &TilesPage::tellHint);
}

QWidget* TilesPage::makeColumn()
{
    auto* marks = new MarksSection(sheets_);
    auto* overview = new OverviewSection(Text::tr("Overview"), overview_);
    overview->setRemark(Text::tr("in place, overlaps shaded"));
    auto* files = new FilesSection(sheets_);
    auto* inner = new QWidget;
    inner->setBackgroundRole(QPalette::AlternateBase);
    inner->setAutoFillBackground(true);
    auto* column = new QVBoxLayout(inner);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(sheetsSection_);
    column->addWidget(marks);
    column->addWidget(overview, 1);
    column->addWidget(files);
    auto* scrolled = new QScrollArea;
    scrolled->setWidget(inner);
    scrolled->setWidgetResizable(true);
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolled->setFocusPolicy(Qt::NoFocus);
    auto* page = withButtonBelow(scrolled, files->exportButton());
    page->setFixedWidth(std::max(columnWidth, inner->minimumSizeHint().width()));
    const auto focusView = [this] {
        if (sheetsSection_->refusal().isEmpty())
            view_->setFocus();
    };
    connect(sheetsSection_, &SheetsSection::entered, view_, focusView);
    connect(files, &FilesSection::entered, view_, focusView);
    connect(marks, &MarksSection::refused, sheetsSection_, &SheetsSection::say);
    connect(marks, &MarksSection::taken, sheetsSection_, &SheetsSection::withdraw);
    connect(files, &FilesSection::exportWanted, this, &TilesPage::exportWanted);
    return page;
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
