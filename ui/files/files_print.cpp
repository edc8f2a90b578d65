// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "ui/files/files.h"
#include "ui/look/text.h"

#include <QFileInfo>
#include <QPageLayout>
#include <QPrinter>

#include <new>

// Printing at true size, on a printer or into a PDF file.

namespace ui {

namespace {

/// How a print ended, and on how many sheets.
struct Printed {
    QString error{}; ///< empty: printed
    int sheets = 0;
    bool stopped = false;
};

QPageSize sizeOf(const app::Point& paper)
{
    return QPageSize(QSizeF(paper.x, paper.y), QPageSize::Millimeter);
}

} // namespace

QString Files::printProposal() const { return proposal(QStringLiteral("-print.pdf")); }

void Files::printTo(const app::ExportJob& job, const app::PrintChoice& choice, Answer printed)
{
    background_.inTurn([=, this](const Turn& turn) {
        emit documentWanted();
        if (!questions_->hasPrinter())
            return emit told({Message::Kind::Warning,
                              Text::tr("There is no printer. Print to a PDF file, or add a printer "
                                       "in the settings of the desktop.")});
        const auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
        printer->setFullPage(true);
        printer->setPageSize(sizeOf(choice.paper));
        printer->setDocName(baseName());
        if (!questions_->choosePrinter(*printer))
            return;
        Printing printing{job, choice, printer->printerName(),
                          [printer](const app::PrintSheets& sheets, const app::Follower& follower) {
                              return app::printOn(*printer, sheets, follower);
                          },
                          printed};
        const QSizeF paper = printer->pageLayout().pageSize().size(QPageSize::Millimeter);
        if (sizeOf(choice.paper) != printer->pageLayout().pageSize())
            printing.choice.paper = {paper.width(), paper.height()};
        printNow(printing, turn);
    });
}

void Files::printToFile(const app::ExportJob& job, const app::PrintChoice& choice,
                        const QString& path, Answer printed)
{
    if (const QString why = refusalToWrite(path); !why.isEmpty()) {
        emit told({Message::Kind::Warning, why});
        return printed ? printed(false) : void();
    }
    background_.inTurn([=, this](const Turn& turn) {
        emit documentWanted();
        printNow({job, choice, QFileInfo(path).fileName(),
                  [path](const app::PrintSheets& sheets, const app::Follower& follower) {
                      return app::printFile(sheets, path, follower);
                  },
                  printed},
                 turn);
    });
}

void Files::printNow(const Printing& printing, const Turn& turn)
{
    const auto work = [printing, title = baseName()](const app::Follower& follower) -> Printed {
        const auto drawing = app::exportDrawing(printing.job, follower);
        if (!drawing)
            return {drawing.error, 0, follower.stop.stop_requested()};
        const auto sheets =
            app::printSheets(*drawing.value, printing.choice, printing.job.source, title);
        if (!sheets)
            return {sheets.error};
        const auto error = printing.print(*sheets.value, follower);
        return {error.value_or(QString()), sheets.value->count(), follower.stop.stop_requested()};
    };
    background_.run(
        Text::tr("Printing…"), work,
        [this, printing, turn](const std::optional<Printed>& made) {
            const bool done = made && made->error.isEmpty() && !made->stopped;
            if (made && !made->error.isEmpty() && !made->stopped)
                emit told({Message::Kind::Warning, made->error});
            if (done)
                emit told({Message::Kind::Done,
                           made->sheets == 1 ? Text::tr("Printed 1 sheet to %1.").arg(printing.onto)
                                             : Text::tr("Printed %1 sheets to %2.")
                                                   .arg(made->sheets)
                                                   .arg(printing.onto)});
            if (printing.printed)
                printing.printed(done);
        },
        InBackground::Cancel::Stops);
}

} // namespace ui
