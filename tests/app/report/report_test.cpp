// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/record_chart.h"
#include "app/report/document.h"
#include "app/report/keep_together.h"
#include "app/report/report.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextTable>
#include <QXmlStreamReader>

#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace report_report_test {

namespace {

const QString hostile = QStringLiteral("a</td><script>x()</script>&amp;\"'\n%1 %2 \x01<b>");

app::Report sample()
{
    app::Report report{
        .title = "Title & <more>", .summary = {"First sentence.", hostile}, .sections = {}};
    const app::PaperTable paper = app::paperTables()[0];
    report.sections.push_back({.title = "Part one",
                               .sentences = {"What it says."},
                               .charts = {app::chartOf(paper)},
                               .tables = {{.names = {"who", "median_ns"},
                                           .rows = {{hostile, "1.50"}, {"cs", "-12"}},
                                           .title = "Times <here>",
                                           .facts = {{"seed", "1"}},
                                           .notes = {"A note."}}}});
    report.sections.push_back({.title = "Part two",
                               .code = "clearcut bench --seed 1",
                               .charts = {app::chartOf(app::paperTables()[1])}});
    return report;
}

QByteArray written(const QString& key, const app::Report& report)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    for (const app::ReportFormat& format : app::reportFormats())
        if (app::latin(format.key) == key && !format.write(report, buffer))
            return buffer.data();
    qFatal("not written");
}

/// What a reader of XML finds: names of elements, attributes, all text.
struct Page {
    QStringList elements, ids, references, cells;
    QString text, error;
};

Page pageOf(const QByteArray& bytes)
{
    Page page;
    QXmlStreamReader reader(bytes);
    while (!reader.atEnd()) {
        reader.readNext();
        if (reader.isStartElement()) {
            page.elements << reader.name().toString();
            for (const auto& attribute : reader.attributes()) {
                if (attribute.name() == u"id")
                    page.ids << attribute.value().toString();
                if (attribute.name() == u"href" || attribute.name() == u"src")
                    page.references << attribute.value().toString();
            }
            if (reader.name() == u"td")
                page.cells << QString();
        } else if (reader.isCharacters()) {
            page.text += reader.text();
            if (!page.cells.isEmpty())
                page.cells.back() += reader.text();
        }
    }
    page.error = reader.errorString();
    return page;
}

QByteArray outputOf(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished() || process.exitCode() != 0)
        qFatal("%s: %s", qPrintable(program), process.readAllStandardError().constData());
    return process.readAllStandardOutput();
}

} // namespace

class ReportTest : public QObject {
    Q_OBJECT

private slots:
    void noRowIsAloneOnAPage()
    {
        app::Report report{.title = "Pages", .summary = {}, .sections = {}};
        for (int i = 0; i < 12; ++i)
            report.sections.push_back(
                {.title = "Part",
                 .tables = {{.names = {"who", "median_ns"},
                             .rows = std::vector(std::size_t(4 + i % 3), QStringList{"a", "1"}),
                             .title = "Times",
                             .facts = {},
                             .notes = {"A note."}}}});
        int torn = 0; // as they come
        for (int height = 300; height < 420; height += 7)
            for (const bool kept : {false, true}) {
                const auto document = app::documentOf(report, 96);
                document->setPageSize(QSizeF(500, height));
                if (kept)
                    app::keepTogether(*document);
                const auto page = [&](const QTextBlock& block) {
                    return qRound(document->documentLayout()->blockBoundingRect(block).top())
                           / height;
                };
                for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
                    const QTextTable* table = QTextCursor(block).currentTable();
                    const auto row = [&](int r) {
                        return page(table->cellAt(r, 0).firstCursorPosition().block());
                    };
                    const bool alone =
                        table ? row(0) != row(2) || row(table->rows() - 1) != row(table->rows() - 2)
                              : (block.text() == "Part" || block.text() == "Times")
                                    && page(block) != page(block.next());
                    torn += !kept && alone;
                    QVERIFY2(!kept || !alone, qPrintable(QString::number(height)));
                }
            }
        QVERIFY(torn > 0);
    }
    void numbersHaveARealMinus()
    {
        QCOMPARE(app::readable("-3.5", true), "−3.5");
        QCOMPARE(app::readable("-a", false), "-a");
        QCOMPARE(app::readable("3.5", true), "3.5");
    }

    void aPageIsWellFormedAndTakesNothingForMarkup()
    {
        const Page page = pageOf(written("html", sample()));
        QCOMPARE(page.error, QString());
        QVERIFY(!page.elements.contains("script") && !page.elements.contains("b"));
        QCOMPARE(page.cells[0], "a</td><script>x()</script>&amp;\"'\n%1 %2 <b>");
        for (const char* text :
             {"Title & <more>", "First sentence.", "Part one", "Part two", "Times <here>", "Median",
              "A note.", "seed: 1", "clearcut bench --seed 1"})
            QVERIFY2(page.text.contains(text), text);
    }

    void aPageNeedsNothingElse()
    {
        const QByteArray bytes = written("html", sample());
        const Page page = pageOf(bytes);
        for (const QString& reference : notEmpty(page.references))
            QVERIFY2(reference.startsWith('#') || reference.startsWith("data:"),
                     qPrintable(reference));
        static const QRegularExpression address("(?:https?:)?//(?!www\\.w3\\.org/)[^ <]*");
        const auto outside = address.match(QString::fromUtf8(bytes));
        QVERIFY2(!outside.hasMatch(), qPrintable(outside.captured()));
        QVERIFY(!bytes.contains("@import") && !bytes.contains("<link"));
        for (const QString& reference : page.references)
            QVERIFY(!reference.startsWith('#') || page.ids.contains(reference.mid(1)));
    }

    void chartsAreThereInLightAndDark()
    {
        const QByteArray bytes = written("html", sample());
        const Page page = pageOf(bytes);
        QCOMPARE(page.elements.count("svg"), 4);
        QCOMPARE(bytes.count("<svg class=\"light\""), 2);
        QCOMPARE(bytes.count("<svg class=\"dark\""), 2);
        QCOMPARE(page.ids.size(), QSet<QString>(page.ids.begin(), page.ids.end()).size());
        QVERIFY(bytes.contains("prefers-color-scheme: dark"));
        QVERIFY(bytes.contains("@media print"));
        const app::PaperTable paper = app::paperTables()[0];
        for (const app::PaperColumn& column : paper.columns)
            QVERIFY2(page.text.contains(column.name), qPrintable(column.name));
    }

    void aPdfSaysTheSameOnPages()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("report.pdf");
        QCOMPARE(app::writeReport(sample(), path), std::nullopt);
        const QString text = QString::fromUtf8(outputOf("pdftotext", {"-layout", path, "-"}));
        for (const char* part :
             {"Title & <more>", "First sentence.", "Part one", "Part two", "Times <here>", "Median",
              "A note.", "seed: 1", "clearcut bench --seed 1", "</td><script>", "1 of "})
            QVERIFY2(text.contains(part), qPrintable(part + text));
        QCOMPARE(outputOf("pdfimages", {"-list", path}).count('\n'), 2); // a heading, no picture
        QVERIFY(outputOf("pdfinfo", {path}).contains("A4"));
    }

    void longTablesGoOnWithTheirHeading()
    {
        app::Report report{.title = "Long", .sections = {{.title = "Part"}}};
        app::Table table{.names = {"number", "what"}};
        for (int i = 0; i < 300; ++i)
            table.rows.push_back({QString::number(i), "row"});
        report.sections[0].tables = {table};
        QTemporaryDir folder;
        const QString path = folder.filePath("long.pdf");
        QCOMPARE(app::writeReport(report, path), std::nullopt);
        const QString text = QString::fromUtf8(outputOf("pdftotext", {"-layout", path, "-"}));
        const auto pages = text.split('\f', Qt::SkipEmptyParts);
        QVERIFY(pages.size() > 2);
        for (const QString& page : pages)
            QVERIFY(page.contains("number"));
        for (int i = 0; i < 300; ++i)
            QVERIFY(text.contains(QRegularExpression(QString("\\b%1 +row").arg(i))));
    }

    void theNameTellsTheFormat()
    {
        QTemporaryDir folder;
        QStringList endings;
        for (const app::ReportFormat& format : app::reportFormats()) {
            endings << u'.' + app::latin(format.key);
            const QString path = folder.filePath("Report." + endings.last().sliced(1).toUpper());
            QVERIFY(!app::writeReport(sample(), path));
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(file.read(4), format.key == "pdf" ? "%PDF" : "<!DO");
            QVERIFY(!format.name.isEmpty());
        }
        QCOMPARE(*app::writeReport(sample(), "report.unknown"),
                 "Cannot write report.unknown: end its name with " + endings.join(" or ") + u'.');
        const auto error = app::writeReport(sample(), folder.filePath("no/report.html"));
        QVERIFY(error && error->contains("No such file or directory"));
    }
};

} // namespace report_report_test

TEST_CLASS(report_report_test::ReportTest, Gui)
#include "tests/app/report/report_test.moc"
