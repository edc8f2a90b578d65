// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/files_section.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/tiles/empty_sheets.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/refusal_frame.h"
#include "ui/widgets/segments.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>

#include <algorithm>

namespace ui {
namespace {

QStringList namesOf(const std::vector<const app::Format*>& formats)
{
    QStringList names;
    for (const app::Format* format : formats)
        names << format->shortName();
    return names;
}

} // namespace

FilesSection::FilesSection(app::LiveSheets& sheets, QWidget* parent)
    : Section(Text::tr("Files"), parent), sheets_(sheets), formats_(app::sheetFormats()),
      format_(new Segments(Text::tr("Format"), namesOf(formats_))),
      each_(new QRadioButton(Text::tr("one file a sheet"))),
      one_(new QRadioButton(Text::tr("one PDF"))), name_(new QLineEdit),
      frame_(new RefusalFrame(*name_)), files_(new ElidedLabel),
      overview_(new QCheckBox(Text::tr("Overview sheet with all numbers"))),
      empty_(new QCheckBox(Text::tr("Leave out empty sheets"))),
      export_(new QPushButton(icon("export"), {}))
{
    addFormat();
    addName();
    overview_->setObjectName(QStringLiteral("overview-sheet"));
    overview_->setToolTip(Text::tr("A further sheet that shows where each one belongs"));
    addWide(overview_);
    empty_->setObjectName(QStringLiteral("leave-out-empty-sheets"));
    addWide(empty_);
    export_->setObjectName(QStringLiteral("export-sheets"));
    export_->setIconSize({16, 16});
    connect(overview_, &QCheckBox::clicked, this, [this](bool checked) {
        app::SheetSettings next = sheets_.settings();
        next.overview = checked ? app::OverviewSheet::Yes : app::OverviewSheet::No;
        change(std::move(next));
    });
    connect(empty_, &QCheckBox::clicked, this, [this](bool checked) {
        app::SheetSettings next = sheets_.settings();
        next.plan.empty = checked ? app::EmptySheets::LeftOut : app::EmptySheets::Written;
        change(std::move(next));
    });
    connect(export_, &QPushButton::clicked, this, &FilesSection::exportWanted);
    connect(&sheets, &app::LiveSheets::changed, this, &FilesSection::follow);
    connect(&sheets, &app::LiveSheets::openChanged, this, &FilesSection::follow);
    follow();
}

void FilesSection::addFormat()
{
    format_->setObjectName(QStringLiteral("sheets-format"));
    each_->setObjectName(QStringLiteral("one-file-a-sheet"));
    one_->setObjectName(QStringLiteral("one-pdf"));
    one_->setToolTip(Text::tr("A PDF file with a page for each sheet"));
    addRow(Text::tr("Format"), {format_});
    addRow(Text::tr("As"), {each_, one_});
    connect(format_, &Segments::picked, this, [this](int chosen) {
        change(app::withFormat(sheets_.settings(), *formats_[std::size_t(chosen)]));
    });
    for (QRadioButton* button : {each_, one_})
        connect(button, &QRadioButton::clicked, this,
                [this, button] { change(app::withOneFile(sheets_.settings(), button == one_)); });
}

void FilesSection::addName()
{
    name_->setAccessibleName(Text::tr("Name"));
    name_->setObjectName(QStringLiteral("sheets-name"));
    name_->setFixedHeight(space::fieldHeight);
    name_->setToolTip(Text::tr("{row} and {column} become the place of the sheet, {n} its number"));
    auto* beside = addRow(Text::tr("Name"), {name_});
    beside->setStretch(0, 1);
    files_->setFont(captionFont(font()));
    files_->setObjectName(QStringLiteral("sheets-files"));
    grid().addWidget(files_, grid().rowCount(), 1);
    connect(name_, &QLineEdit::editingFinished, this, &FilesSection::takeName);
    connect(name_, &QLineEdit::returnPressed, this, [this] {
        if (frame_->isHidden())
            emit entered();
    });
    connect(frame_, &RefusalFrame::typed, this, [this] { showFiles(sheets_.files()); });
    // The names follow while one types, as far as they are right.
    connect(name_, &QLineEdit::textEdited, this, [this](const QString& text) {
        if (!sheets_.tiling())
            return;
        if (auto named = app::withName(sheets_.settings(), text, *sheets_.tiling().value))
            showFiles(
                app::filesOf(sheets_.sheets(), app::patternOf(*named.value, sheets_.title())));
    });
}

void FilesSection::change(app::SheetSettings next)
{
    sheets_.change(std::move(next));
    follow();
}

void FilesSection::takeName()
{
    if (!sheets_.tiling() || !name_->isModified())
        return;
    auto named = app::withName(sheets_.settings(), name_->text(), *sheets_.tiling().value);
    name_->setModified(false);
    if (named)
        return change(std::move(*named.value));
    follow(); // the old name stays
    frame_->show();
    frame_->raise();
    files_->setColour(errorColour);
    files_->setWhole(named.error);
    files_->setToolTip(named.error);
}

void FilesSection::follow()
{
    if (!sheets_.isOpen())
        return;
    const app::SheetSettings& now = sheets_.settings();
    const auto chosen = std::ranges::find(formats_, std::string_view(now.format),
                                          [](const app::Format* format) { return format->key; });
    format_->choose(int(chosen - formats_.begin()));
    (now.oneFile ? one_ : each_)->setChecked(true);
    overview_->setChecked(now.overview == app::OverviewSheet::Yes);
    empty_->setChecked(now.plan.empty == app::EmptySheets::LeftOut);
    const QString leftOut =
        sheets_.tiling() ? app::emptySheetsText(*sheets_.tiling().value) : QString();
    empty_->setToolTip(leftOut.isEmpty() ? Text::tr("Sheets without any part of the drawing")
                                         : leftOut);
    frame_->hide();
    if (!name_->isModified() || !name_->hasFocus())
        name_->setText(app::patternOf(now, sheets_.title()));
    const QStringList files = sheets_.files();
    showFiles(files);
    const int written = sheets_.tiling() ? sheets_.tiling().value->written() : 0;
    export_->setText(written == 1 ? Text::tr("Export 1 sheet…")
                                  : Text::tr("Export %1 sheets…").arg(app::countText(written)));
    const bool ready = !sheets_.cutting();
    export_->setEnabled(written > 0 && ready);
    export_->setToolTip(!ready        ? Text::tr("The drawing is being cut at its clip windows.")
                        : written > 0 ? Text::tr("Choose where to write the files")
                                      : Text::tr("There is no sheet to export."));
}

void FilesSection::showFiles(const QStringList& files)
{
    files_->setSheet({});
    files_->setForegroundRole(QPalette::PlaceholderText);
    files_->setWhole(files.size() < 2 ? files.value(0)
                                      : files.front() + QStringLiteral(" … ") + files.back());
    files_->setToolTip(files_->whole());
}

} // namespace ui

#include "moc_files_section.cpp"
