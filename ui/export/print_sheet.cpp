// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/print_sheet.h"

#include "app/base/number.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/export/export_path.h"
#include "app/session/export_source.h"
#include "ui/export/area_section.h"
#include "ui/export/export_preview.h"
#include "ui/export/print_section.h"
#include "ui/files/files.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/look_label.h"

#include <QKeyEvent>
#include <QPointer>
#include <QVBoxLayout>

namespace ui {

namespace {

/// Where it is said how many sheets are printed.
class PrintResult : public ExportSection {
public:
    PrintResult(double ratio, QWidget* sheets, QWidget* error) : ExportSection(Text::tr("Result"))
    {
        auto* scale =
            new QLabel(Text::tr("<b>1 : %1</b>, true size").arg(app::shortestText(ratio)));
        scale->setTextFormat(Qt::RichText);
        addRow(Text::tr("Scale"), {scale});
        addRow(Text::tr("Sheets"), {sheets});
        grid().addWidget(error, grid().rowCount(), 0, 1, 2);
    }
};

QString sheetsText(const app::PrintSheets& sheets)
{
    const QString paper = app::sizeText(sheets.paper(), app::Unit::Mm, 1);
    if (sheets.count() == 1)
        return Text::tr("<b>1</b> of %1").arg(paper);
    return Text::tr("<b>%1</b> of %2, %3")
        .arg(app::countText(std::size_t(sheets.count())), paper,
             app::gridText(sheets.sheets.tiling));
}

QString summaryOf(const app::PrintSheets& sheets)
{
    return sheets.count() == 1
               ? Text::tr("1 sheet")
               : Text::tr("%1 sheets").arg(app::countText(std::size_t(sheets.count())));
}

} // namespace

PrintSheet::PrintSheet(app::Session& session, Files& files)
    : Sheet(QStringLiteral("print"), Text::tr("Print"), Width::Wide), session_(session),
      files_(files), live_(std::make_shared<app::LiveExport>(session)),
      preview_(new ExportPreview(session, live_)), area_(new AreaSection(session, *live_)),
      paper_(new PrintSection(session.now().page())), sheets_(new LookLabel), error_(new LookLabel),
      print_(plainButton(Text::tr("Print…"))), toFile_(plainButton(Text::tr("To PDF file…")))
{
    body().addWidget(area_);
    body().addWidget(paper_);
    addResult();
    body().addStretch();
    addButtons();
    setPreview(preview_);
    connect(preview_, &ExportPreview::closeWanted, this, &Sheet::closeWanted);
    connect(preview_, &ExportPreview::entered, this, &PrintSheet::print);
    connect(live_.get(), &app::LiveExport::changed, this, &PrintSheet::follow);
    connect(paper_, &PrintSection::changed, this, &PrintSheet::follow);
    connect(&session, &app::Session::loaded, this, &Sheet::closeWanted);
    begin();
}

void PrintSheet::addResult()
{
    sheets_->setTextFormat(Qt::RichText);
    sheets_->setObjectName(QStringLiteral("print-sheets"));
    error_->setObjectName(QStringLiteral("print-error"));
    error_->setWordWrap(true);
    error_->setColour(errorColour);
    body().addWidget(new PrintResult(session_.now().page().scale.ratio, sheets_, error_));
}

void PrintSheet::addButtons()
{
    auto* cancel = plainButton(Text::tr("Cancel"));
    cancel->setObjectName(QStringLiteral("cancel-print"));
    toFile_->setObjectName(QStringLiteral("print-to-file"));
    print_->setObjectName(QStringLiteral("print-now"));
    wearFont(*print_, 1, QFont::DemiBold); // Enter presses it
    addToFoot(toFile_, Side::Left);
    addToFoot(cancel);
    addToFoot(print_);
    connect(cancel, &QPushButton::clicked, this, &Sheet::closeWanted);
    connect(toFile_, &QPushButton::clicked, this, &PrintSheet::printToFile);
    connect(print_, &QPushButton::clicked, this, &PrintSheet::print);
}

void PrintSheet::begin()
{
    app::ExportChoice choice{.format = "pdf"};
    choice.area.window = session_.windowNumber().value_or(0);
    choice.area.layer = session_.pen.layer;
    live_->change(std::move(choice));
}

void PrintSheet::choose(const app::ExportArea& area)
{
    app::ExportChoice choice = live_->choice();
    choice.area = area;
    live_->change(std::move(choice));
}

app::PrintChoice PrintSheet::choice() const { return paper_->choice(); }

void PrintSheet::follow()
{
    area_->follow();
    if (live_->making())
        return;
    QString error = live_->error();
    std::vector<clipping::Window> papers;
    sheets_->setText({});
    if (const auto& made = live_->made()) {
        const auto sheets = app::printSheets(made->drawing, choice(), app::exportSourceOf(session_),
                                             files_.baseName());
        if (sheets) {
            papers = sheets.value->papers();
            sheets_->setText(sheetsText(*sheets.value));
            emit summed(summaryOf(*sheets.value));
        } else
            error = sheets.error;
        paper_->showDivided(!sheets || !sheets.value->single);
    }
    preview_->view().setPapers(std::move(papers));
    error_->setText(error);
    error_->setVisible(!error.isEmpty());
    for (QPushButton* button : {print_, toFile_})
        button->setEnabled(error.isEmpty());
}

void PrintSheet::print()
{
    if (!print_->isEnabled())
        return;
    files_.printTo(live_->job(), choice(), [sheet = QPointer(this)](bool printed) {
        if (printed && sheet)
            emit sheet->closeWanted();
    });
}

void PrintSheet::printToFile()
{
    const QString path =
        files_.questions().fileToWrite(Text::tr("Print to a PDF file"), files_.printProposal(),
                                       Text::tr("PDF document"), QStringLiteral("pdf"));
    if (path.isEmpty())
        return;
    files_.printToFile(live_->job(), choice(), path, [sheet = QPointer(this)](bool printed) {
        if (printed && sheet)
            emit sheet->closeWanted();
    });
}

/// What no field took. Enter in a field with a number only takes the number.
void PrintSheet::keyPressEvent(QKeyEvent* event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && paper_->isAncestorOf(focusWidget()))
        return;
    if (enter)
        return print();
    Sheet::keyPressEvent(event);
}

} // namespace ui

#include "moc_print_sheet.cpp"
