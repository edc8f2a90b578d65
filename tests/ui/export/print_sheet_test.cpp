// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_preview.h"
#include "ui/export/print_sheet.h"
#include "ui/widgets/tool_list.h"

#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QtPrintSupport/QPrinter>

#include "tests/app/command_line/program.h"
#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/export/output_desk.h"

namespace ui::export_print_sheet_test {

namespace {

/// A printer that prints into a PDF file.
class WithPrinter : public PreparedAnswers {
public:
    using PreparedAnswers::PreparedAnswers;

    QString file;
    bool accepted = true;
    bool hasPrinter() override { return true; }
    bool choosePrinter(QPrinter& printer) override
    {
        printer.setOutputFormat(QPrinter::PdfFormat);
        printer.setOutputFileName(file);
        return accepted;
    }
};

/// The editor with a plan of 400 × 250 mm, and a line along 100 mm of it.
class Desk : public OutputDesk<PrintSheet> {
public:
    Desk() : Desk("width='400mm' height='250mm' viewBox='0 0 400 250'") {}
    explicit Desk(const QString& page)
        : OutputDesk(
            "print", "plan.svg",
            QStringLiteral("<svg xmlns='http://www.w3.org/2000/svg' %1><path d='M20 60H120' "
                           "stroke='#000' fill='none'/></svg>")
                .arg(page)
                .toUtf8())
    {
    }
    void press(const char* name)
    {
        part<QAbstractButton>(name).click();
        window->files().wait();
    }
    void choosePaper(const QString& name)
    {
        auto& papers = part<ToolList>("print-paper");
        papers.setCurrentText(name);
        emit papers.activated(papers.currentIndex());
        settle();
    }
    QString sheetsText() { return part<QLabel>("print-sheets").text(); }
    WithPrinter& addPrinter()
    {
        auto printer = std::make_unique<WithPrinter>(*window);
        auto& added = *printer;
        window->setQuestions(std::move(printer));
        return added;
    }
    static QString pagesOf(const QString& pdf)
    {
        const auto run = runProgram("pdfinfo", {pdf});
        for (const QByteArray& line : run.out.split('\n'))
            if (line.startsWith("Pages:"))
                return QString::fromUtf8(line.mid(6)).trimmed();
        return QString::fromUtf8(run.err);
    }
};

} // namespace

class PrintSheetTest : public QObject {
    Q_OBJECT

private slots:
    void thePreviewShowsThePaper()
    {
        Desk t;
        PrintSheet& sheet = t.openSheet();
        QVERIFY(sheet.shown().isVisible() && !t.window->canvas().isVisible());
        QVERIFY2(t.sheetsText().startsWith("<b>3</b> of 210.00"), qPrintable(t.sheetsText()));
        QVERIFY(t.part("print-overlap").isVisible());
        t.choosePaper("A3");
        QVERIFY2(t.sheetsText().startsWith("<b>1</b> of 420.00"), qPrintable(t.sheetsText()));
        QVERIFY(!t.part("print-overlap").isVisible());
    }
    void thePaperIsThatOfThePageUntilAnotherIsChosen()
    {
        Desk t("width='420mm' height='297mm' viewBox='0 0 420 297'");
        t.openSheet();
        QVERIFY2(t.sheetsText().startsWith("<b>1</b> of 420.00"), qPrintable(t.sheetsText()));
        t.choosePaper("Letter");
        t.press("cancel-print");
        t.openSheet();
        QCOMPARE(t.part<ToolList>("print-paper").currentText(), "Letter");
    }
    void withoutAPrinterASentenceSaysWhatToDo()
    {
        Desk t;
        t.openSheet();
        t.press("print-now");
        QCOMPARE(t.window->message(), "There is no printer. Print to a PDF file, or add a printer "
                                      "in the settings of the desktop.");
        QVERIFY(t.window->sheet());
    }
    void sheetsGoToAFile()
    {
        Desk t;
        t.openSheet();
        t.answers->save = t.path("plan.pdf");
        t.press("print-to-file");
        QVERIFY2(t.window->message().startsWith("Printed 3 sheets to plan.pdf"),
                 qPrintable(t.window->message()));
        QVERIFY(!t.window->sheet());
        QCOMPARE(Desk::pagesOf(t.path("plan.pdf")), "3");
    }
    void sheetsGoToAPrinter()
    {
        Desk t;
        WithPrinter& printer = t.addPrinter();
        t.openSheet();
        printer.file = t.path("out.pdf");
        printer.accepted = false;
        t.press("print-now");
        QVERIFY(t.window->sheet() && contentOf(printer.file).isEmpty()); // cancelled
        printer.accepted = true;
        t.press("print-now");
        QVERIFY2(t.window->message().startsWith("Printed 3 sheets to"),
                 qPrintable(t.window->message()));
        QVERIFY(!t.window->sheet());
        QCOMPARE(Desk::pagesOf(printer.file), "3");
    }
    void aFileThatCannotBeWrittenIsASentence()
    {
        Desk t;
        t.openSheet();
        t.answers->save = t.path("nowhere/plan.pdf");
        t.press("print-to-file");
        QVERIFY2(t.window->message().contains("nowhere/plan.pdf")
                     && t.window->message().endsWith(u'.'),
                 qPrintable(t.window->message()));
        QVERIFY(t.window->sheet());
    }
};

} // namespace ui::export_print_sheet_test

TEST_CLASS(ui::export_print_sheet_test::PrintSheetTest, Widgets)
#include "tests/ui/export/print_sheet_test.moc"
