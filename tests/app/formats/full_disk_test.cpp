// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/base/variant.h"
#include "app/base/write_all.h"
#include "app/charts/chart_file.h"
#include "app/charts/record_chart.h"
#include "app/command_line/command.h"
#include "app/cost_map/files.h"
#include "app/experiment/paper_tables.h"
#include "app/export/export_file.h"
#include "app/export/print_job.h"
#include "app/formats/csv/table_cut.h"
#include "app/formats/format.h"
#include "app/judge/example_files.h"
#include "app/report/report.h"
#include "app/report/study_files.h"
#include "app/session/save.h"
#include "app/session/session.h"
#include "app/teaching/trace_file.h"
#include "app/tiles/sheets.h"

#include <QDir>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/app/document/sheet.h"
#include "tests/app/formats/failing_disk.h"
#include "tests/test_class.h"

namespace formats_full_disk_test {

using namespace app;

namespace {

/// Something that writes a file in the place of an old one: nothing, or what went wrong.
struct Writer {
    QString name, file;
    std::function<std::optional<QString>(const QString& path)> write;
};

Sheet twoLines(int times = 1)
{
    Sheet sheet;
    for (int i = 0; i < 2 * times; ++i)
        sheet.shapes.push_back(
            {{{{0, double(i)}, {{{9, 9}}}, false}}, {.stroke = Colour{}}, {}, 0, false});
    return sheet;
}

void writeDxfLines(const QString& path)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("0\nSECTION\n2\nENTITIES\n" + QByteArray("0\nLINE\n11\n9\n").repeated(4000)
               + "0\nENDSEC\n0\nEOF\n");
}

const CostMap& smallCostMap()
{
    CostPlan plan = usualCostPlan({{-100, -75}, {100, 75}});
    plan.measure = &costMeasures().front();
    plan.columns = plan.rows = 4;
    static const CostMap map = costMap(plan);
    return map;
}

TraceExport trace()
{
    TraceExport trace{
        .tracedLine = {{clipping::findAlgorithm("cohen-sutherland"), clipping::Form::Corrected},
                       {{-160, -30}, {70, 130}},
                       {{-100, -75}, {100, 75}},
                       YAxis::Up,
                       {}},
        .narration = {}};
    trace.narration = narrationOf(trace.tracedLine);
    trace.only = 1; // one file, of every format
    return trace;
}

Table table()
{
    return {.names = {"x", "y"}, .rows = {{"1", "2"}, {"3", "4"}}, .title = "T", .key = "t"};
}

/// Writes with Qt's own PDF writer, which does not look whether its device took what it wrote.
std::optional<QString> paintPdf(QIODevice& out)
{
    QPdfWriter writer(&out);
    writer.setPageSize(QPageSize(QPageSize::A6));
    QPainter painter(&writer);
    for (int i = 0; i < 40; ++i)
        painter.drawLine(0, i, 100 * i, 1000);
    return std::nullopt;
}

/// Cuts a table row by row into the file, as clearcut clip does.
std::optional<QString> cutRows(QIODevice& out)
{
    std::string rows;
    for (int i = 0; i < 400; ++i)
        rows += "0," + std::to_string(i % 9) + ",9,9\n";
    const auto source = [rows, at = std::size_t(0)](char* bytes, std::size_t size) mutable {
        const std::size_t count = rows.copy(bytes, size, at);
        at += count;
        return count;
    };
    csv::cutTable(
        source, [&](std::string_view text) { return writeAll(out, text); },
        {.rows = {.cut = {.clipAll = usualAlgorithm().corrected.clipAll,
                          .region = regionOf({{{.shape = RectangleShape{{{1, 1}, {8, 8}}}}}}, 1)},
                  .write = {}},
         .stream = {.threads = 2}});
    return std::nullopt;
}

std::vector<Writer> madeWriters()
{
    std::vector<Writer> all;
    for (const Format& format : formats())
        if (format.write) {
            all.push_back({"drawing", latin(format.key), [](const QString& path) {
                               return writeFile(app::documentOf(twoLines()), path);
                           }});
            all.push_back({"long drawing", latin(format.key), [](const QString& path) {
                               return writeFile(app::documentOf(twoLines(400)), path);
                           }});
        }
    all.push_back({"sheets", "pdf", [](const QString& path) {
                       const Document drawing = documentOf(twoLines());
                       const TilePlan plan{.columns = 2, .rows = 2};
                       return writeSheets({drawing,
                                           plan,
                                           *tilingOf(drawing.page(), plan).value,
                                           {.clipAll = usualAlgorithm().corrected.clipAll},
                                           {}},
                                          path, *findFormat(u"pdf"), {});
                   }});
    all.push_back(
        {"printed sheets", "pdf", [](const QString& path) {
             const Document drawing = documentOf(twoLines());
             const ExportSource source{drawing, {}, usualAlgorithm().corrected.clipAll, {}};
             const auto made = exportDrawing({source, {.area = {ExportPart::Page}}});
             return printFile(*printSheets(*made.value, {.paper = {150, 150}}, source, {}).value,
                              path);
         }});
    for (const Format* format : exportFormats())
        all.push_back({"export", latin(format->key), [format](const QString& path) {
                           const ExportSource source{
                               documentOf(twoLines()), {}, usualAlgorithm().corrected.clipAll, {}};
                           const ExportResult end = exportFile(
                               {source, {.format = std::string(format->key), .dpi = 20}}, path);
                           return end.end == WriteResult::End::Written ? std::nullopt
                                                                       : std::optional(end.error);
                       }});
    all.push_back({"session", "svg", [](const QString& path) {
                       const Saved saved = save(Session().beginSaving(), path);
                       return saved.end == Saved::End::Written ? std::nullopt
                                                               : std::optional(saved.error);
                   }});
    for (const ChartFormat& format : chartFormats())
        all.push_back({"chart", latin(format.key), [](const QString& path) {
                           return writeChart(chartOf(paperTables()[0]), path,
                                             chartLook(Ground::Light));
                       }});
    for (const CostMapFormat& format : costMapFormats())
        all.push_back({"cost map", latin(format.key), [](const QString& path) {
                           return writeCostMap(smallCostMap(), path, costMapLook(Ground::Light));
                       }});
    for (const TraceFormat& format : traceFormats())
        all.push_back({"trace", latin(format.ending),
                       [bytes = *traceBytes(trace(), format)](const QString& path) {
                           return writeTrace({path}, bytes);
                       }});
    for (const TableFormat& format : tableFormats())
        all.push_back({"table", format.ending, [format](const QString& path) {
                           return writeTable(table(), format, path);
                       }});
    for (const ReportFormat& format : reportFormats())
        all.push_back({"report", latin(format.key), [](const QString& path) {
                           return writeReport(
                               {.title = "R", .sections = {{.title = "S", .tables = {table()}}}},
                               path);
                       }});
    all.push_back(
        {"cut table", "csv", [](const QString& path) { return replaceFile(path, cutRows); }});
    all.push_back(
        {"Qt's PDF", "pdf", [](const QString& path) { return replaceFile(path, paintPdf); }});
    return all;
}

const std::vector<Writer>& writers()
{
    static const auto all = madeWriters();
    return all;
}

} // namespace

class FullDiskTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString path(const Writer& writer) const
    {
        return folder_.filePath(QStringLiteral("a.") + writer.file);
    }

    /// Writes where an old file is, and complains unless that is what is there afterwards and
    /// alone.
    void leavesTheOldFile(const Writer& writer, const QString& circumstances)
    {
        const QByteArray what =
            QStringLiteral("%1, %2, %3").arg(writer.name, writer.file, circumstances).toUtf8();
        const auto error = writer.write(path(writer));
        disk::state() = {};
        QVERIFY2(error && !error->isEmpty(), what);
        QVERIFY2(error->endsWith(u'.') && !error->contains(u".."), qPrintable(*error));
        QVERIFY2(contentOf(path(writer)) == "old", what);
        QCOMPARE(QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden),
                 QStringList{QFileInfo(path(writer)).fileName()});
    }

private slots:
    void everyWriter_data()
    {
        QTest::addColumn<int>("row");
        const auto& all = writers();
        for (std::size_t i = 0; i < all.size(); ++i)
            QTest::addRow("%s, %s", qPrintable(all[i].name), qPrintable(all[i].file)) << int(i);
    }
    void everyWriter()
    {
        QFETCH(int, row);
        const Writer& writer = writers()[std::size_t(row)];
        const QString file = path(writer);
        const auto error = writer.write(file);
        QVERIFY2(!error, qPrintable(error.value_or("")));
        const QByteArray whole = contentOf(file);
        QVERIFY(whole.size() > 10);
        writeText(file, "old");
        for (const std::size_t place : disk::placesIn(std::size_t(whole.size()))) {
            const disk::Limit limit(place);
            leavesTheOldFile(writer,
                             QStringLiteral("full at byte %1 of %2").arg(place).arg(whole.size()));
            if (QTest::currentTestFailed())
                return;
        }
        for (const std::size_t room :
             {std::size_t(0), std::size_t(whole.size()) / 2, std::size_t(whole.size()) - 1}) {
            const disk::Failing failing(disk::Step::Write, room);
            leavesTheOldFile(writer, QStringLiteral("no space after byte %1").arg(room));
        }
        {
            const disk::Failing failing(disk::Step::Sync);
            leavesTheOldFile(writer, "fsync fails");
        }
        {
            const disk::Failing failing(disk::Step::Rename);
            leavesTheOldFile(writer, "rename fails");
        }
        QVERIFY(!writer.write(file));
        QVERIFY(contentOf(file) != "old");
        QVERIFY(QFile::remove(file));
    }

    // Of several files each is the old or the new one.
    void theExampleForJudging()
    {
        QTemporaryDir folder;
        for (const QString& name : plug_in::exampleNames())
            writeText(folder.filePath(name), "old");
        const disk::Failing failing(disk::Step::Write, 3);
        const auto written = plug_in::writeExample(folder.path(), plug_in::Existing::Replace);
        disk::state() = {};
        QVERIFY(!written);
        QVERIFY2(written.error.endsWith(": No space left on device."), qPrintable(written.error));
        for (const QString& name : plug_in::exampleNames())
            QCOMPARE(contentOf(folder.filePath(name)), "old");
    }

    // Saved in place of the file, half of a drawing would be all of it.
    void aDiskThatCannotBeReadIsNoShorterDrawing()
    {
        for (const Format& format : formats()) {
            if (!format.read)
                continue;
            const QString file = folder_.filePath(QStringLiteral("read.") + latin(format.key));
            if (format.write)
                QVERIFY(!writeFile(app::documentOf(twoLines(2000)), file));
            else
                writeDxfLines(file);
            QVERIFY(readFile(file));
            const auto size = std::size_t(QFileInfo(file).size());
            for (const std::size_t room :
                 {std::size_t(0), std::size_t(16384), size / 2, size - 1}) {
                const disk::Failing failing(disk::Step::Read, room);
                const auto read = readFile(file);
                QVERIFY(failing.failures() > 0);
                QVERIFY2(read.error.endsWith("it cannot be read to its end. Input/output error."),
                         qPrintable(QStringLiteral("%1 after %2 of %3: %4")
                                        .arg(file)
                                        .arg(room)
                                        .arg(size)
                                        .arg(read.error)));
            }
            QVERIFY(QFile::remove(file));
        }
    }

    // The failing disk would prove nothing if nothing went through it.
    void theDiskIsAsked()
    {
        for (const auto step : {disk::Step::Write, disk::Step::Sync, disk::Step::Rename}) {
            const disk::Failing failing(step);
            QVERIFY(writeFile(app::documentOf(twoLines()), folder_.filePath("asked.svg")));
            QVERIFY(failing.failures() > 0);
        }
        QVERIFY(!QFile::exists(folder_.filePath("asked.svg")));
    }

    void aLinkToItselfStaysALink()
    {
        QVERIFY(QFile::link("self.svg", folder_.filePath("self.svg")));
        QVERIFY(QFile::link("b.svg", folder_.filePath("a.svg")));
        QVERIFY(QFile::link("a.svg", folder_.filePath("b.svg")));
        for (const char* name : {"self.svg", "a.svg", "b.svg"}) {
            const QString path = folder_.filePath(name);
            const auto error = writeFile(app::documentOf(twoLines()), path);
            QVERIFY2(error && error->contains("a link that leads to itself"),
                     qPrintable(error.value_or("written")));
            QVERIFY2(QFileInfo(path).isSymLink(), name);
        }
        for (const char* name : {"self.svg", "a.svg", "b.svg"})
            QVERIFY(QFile::remove(folder_.filePath(name)));
    }

    void aLinkToAFileIsFollowed()
    {
        writeText(folder_.filePath("real.svg"), "old");
        QVERIFY(QFile::link("real.svg", folder_.filePath("link.svg")));
        QVERIFY(QFile::link("new.svg", folder_.filePath("nowhere.svg")));
        QVERIFY(!writeFile(app::documentOf(twoLines()), folder_.filePath("link.svg")));
        QVERIFY(!writeFile(app::documentOf(twoLines()), folder_.filePath("nowhere.svg")));
        QVERIFY(QFileInfo(folder_.filePath("link.svg")).isSymLink());
        for (const char* name : {"real.svg", "new.svg"})
            QVERIFY(contentOf(folder_.filePath(name)).startsWith("<?xml"));
        for (const QString& name : QDir(folder_.path()).entryList(QDir::Files | QDir::System))
            QVERIFY(QFile::remove(folder_.filePath(name)));
    }

    // Qt would write to another name, in which the byte is three others.
    void aNameThatIsNotUtf8IsRefused()
    {
        const QString lost = folder_.filePath(QStringLiteral("caf") + QChar::ReplacementCharacter
                                              + QStringLiteral(".svg"));
        const auto error = writeFile(app::documentOf(twoLines()), lost);
        QVERIFY2(error && error->endsWith(": its name is not UTF-8. Give it another name."),
                 qPrintable(error.value_or("written")));
        QVERIFY(!QFile::exists(lost));
        QVERIFY(readFile(lost).error.endsWith(": its name is not UTF-8. Give it another name."));
        writeText(lost, "old"); // but one that is really named so
        QVERIFY(!writeFile(app::documentOf(twoLines()), lost));
        QVERIFY(QFile::remove(lost));
    }
};

} // namespace formats_full_disk_test

TEST_CLASS(formats_full_disk_test::FullDiskTest, Gui)
#include "tests/app/formats/full_disk_test.moc"
