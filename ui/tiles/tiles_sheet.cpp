// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/tiles_sheet.h"

#include "ui/look/text.h"
#include "ui/tiles/files_section.h"
#include "ui/tiles/marks_section.h"
#include "ui/tiles/sheets_section.h"

#include <QPushButton>

namespace ui {
namespace {

constexpr int leastOverview = 60; // pixels

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

} // namespace

TilesSheet::TilesSheet(app::Session& session, app::LiveSheets& sheets, QWidget& overview)
    : Sheet(QStringLiteral("tiles-sheet"), Text::tr("Tiles")),
      sheetsSection_(new SheetsSection(session, sheets))
{
    auto* marks = new MarksSection(sheets);
    auto* small = new OverviewSection(Text::tr("Overview"), &overview);
    small->setRemark(Text::tr("in place, overlaps shaded"));
    auto* files = new FilesSection(sheets);
    body().addWidget(sheetsSection_);
    body().addWidget(marks);
    body().addWidget(small, 1);
    body().addWidget(files);
    addToFoot(files->exportButton());
    const auto enter = [this] {
        if (sheetsSection_->refusal().isEmpty())
            emit entered();
    };
    connect(sheetsSection_, &SheetsSection::entered, this, enter);
    connect(files, &FilesSection::entered, this, enter);
    connect(marks, &MarksSection::refused, sheetsSection_, &SheetsSection::say);
    connect(marks, &MarksSection::taken, sheetsSection_, &SheetsSection::withdraw);
    connect(files, &FilesSection::exportWanted, this, &TilesSheet::exportWanted);
}

} // namespace ui

#include "moc_tiles_sheet.cpp"
