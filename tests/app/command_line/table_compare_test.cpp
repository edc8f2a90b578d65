// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/number.h"
#include "app/comparison/difference.h"

#include <QTest>

#include <random>

#include "tests/app/command_line/program.h"
#include "tests/app/command_line/running.h"
#include "tests/app/command_line/silent_input.h"
#include "tests/sanitizer.h"
#include "tests/test_class.h"

namespace command_line_table_compare_test {

namespace {

const QByteArray header = "line,shape,differs,ulps,a_x1,a_y1,a_x2,a_y2,b_x1,b_y1,b_x2,b_y2,"
                          "a,b,ulps_allowed,window\n";
const QStringList compare{"compare", "-", "--from", "csv", "-f", "csv", "-w", "0,0,300,300"};
const QStringList kwc{"-a", "kwc:published"};
const QByteArray lost = "100,0,100.5,300\n"; // by published KWC

QByteArray rowOfLost(int row)
{
    return QByteArray::number(row) + ',' + QByteArray::number(row)
           + ",only_b,5.27766e+15,,,,,100,0,100.5,300,"
             "kodituwakku-wijeweera-chamikara:published,exact,24.5,\"0,0,300,300\"\n";
}

// Published KWC loses every fourth line.
std::vector<clipping::Segment> randomLines()
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> place(-100, 400);
    std::vector<clipping::Segment> lines(20'000);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        auto& [a, b] = lines[i];
        a = {place(random), place(random)};
        b = {i % 4 ? place(random) : a.x + 0.5, place(random)};
    }
    lines[7].b = lines[7].a;
    return lines;
}

QByteArray tableOf(const std::vector<clipping::Segment>& lines)
{
    std::string text = "x1,y1,x2,y2,layer,colour\n";
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto& [a, b] = lines[i];
        for (const double number : {a.x, a.y, b.x, b.y}) {
            app::appendNumber(text, number);
            text += ',';
        }
        text += i % 3 ? "one,#ff0000\n" : "\"tw\"\"o\",\n\n# a remark\n";
    }
    return QByteArray::fromStdString(text);
}

QByteArray textOf(const app::Difference& difference)
{
    const QByteArray row = QByteArray::number(difference.source + 1);
    constexpr std::array words{"only_a", "only_b", "ends"};
    return row + ',' + row + ',' + words[std::size_t(difference.kind)] + ','
           + QByteArray::number(difference.ulps, 'g', 6) + ',';
}

} // namespace

/// `clearcut compare` of tables, row by row.
class TableCompareTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void findsWhatTheLibraryFinds_data()
    {
        QTest::addColumn<QString>("a");
        QTest::addColumn<double>("ulps");
        QTest::newRow("lost lines") << "kwc:published" << 64.0;
        QTest::newRow("ends") << "cb" << 0.0;
        QTest::newRow("a misprint") << "md-step-2" << 8.0;
    }
    void findsWhatTheLibraryFinds()
    {
        QFETCH(QString, a);
        QFETCH(double, ulps);
        const auto lines = randomLines();
        const auto expected = app::differences(lines, {{0, 0}, {300, 300}}, *app::findVariant(a),
                                               app::exactVariant(), ulps);
        const auto run = clearcut(compare + QStringList{"-a", a, "--ulps", QString::number(ulps)},
                                  tableOf(lines));
        QCOMPARE(run.code, 3);
        const QByteArrayList rows = run.out.split('\n');
        QVERIFY(expected.size() > 100);
        QCOMPARE(std::size_t(rows.size()), expected.size() + 2);
        for (std::size_t i = 0; i < expected.size(); ++i)
            QVERIFY2(rows[qsizetype(i) + 1].startsWith(textOf(expected[i])),
                     rows[qsizetype(i) + 1]);
    }

    void tablesWithSemicolonsAndDecimalCommas()
    {
        const QByteArray table = "x1;y1;x2;y2\n100,0;0;100,5;300\n";
        const auto run = clearcut(compare + kwc, table);
        QCOMPARE(run.code, 3);
        QCOMPARE(run.out, header + rowOfLost(1));
        QVERIFY(run.err.startsWith("1 × table has semicolons between its columns; a comma is a "
                                   "decimal comma\n"));
        QCOMPARE(
            clearcut(QStringList{"compare", "-", "--from", "csv", "-f", "csv"} + kwc, table).code,
            clearcut(QStringList{"compare", "-", "--from", "csv", "-f", "csv"} + kwc, lost).code);
    }

    void rowByRowAsADrawing_data()
    {
        QTest::addColumn<QStringList>("options");
        const QStringList ends{"-a", "cb", "--ulps", "0"};
        QTest::newRow("csv") << ends + QStringList{"-w", "0,0,300,300", "-f", "csv"};
        QTest::newRow("text") << ends + QStringList{"-w", "0,0,300,300"};
        QTest::newRow("json") << kwc + QStringList{"-w", "0,0,300,300", "-f", "json"};
        QTest::newRow("summary") << kwc
                                        + QStringList{"-w", "0,0,300,300", "-f", "csv",
                                                      "--summary"};
        QTest::newRow("rotated") << ends + QStringList{"-w", "0,0,300,300@30", "-f", "csv"};
        QTest::newRow("polygon") << QStringList{"-a", "cb",  "-w",     "circle:150,150,90",
                                                "-f", "csv", "--ulps", "0"};
        QTest::newRow("none differ") << QStringList{"-a", "cb", "-w", "0,0,300,300", "-f", "csv"};
    }
    void rowByRowAsADrawing()
    {
        QFETCH(QStringList, options);
        auto lines = randomLines();
        lines.resize(4000);
        const QString table = folder_.filePath("one.csv"), drawing = folder_.filePath("one.svg");
        writeText(table, tableOf(lines).replace("\"tw\"\"o\"", "one"));
        QCOMPARE(clearcut({"convert", table, "-o", drawing}).code, 0);
        const auto rows = clearcut(QStringList{"compare", table} + options);
        const auto whole = clearcut(QStringList{"compare", drawing} + options);
        QVERIFY2(rows.out == whole.out, rows.out.left(2000) + "\n" + whole.out.left(2000));
        QCOMPARE(rows.code, whole.code);
        const auto sentence = [](const QByteArray& report) {
            return report.trimmed().sliced(report.trimmed().lastIndexOf('\n') + 1);
        };
        QCOMPARE(sentence(rows.err), sentence(whole.err)); // a table has no paper
    }

    // Without a window the whole table is read, and grouped by layer.
    void linesAreNumberedByRow()
    {
        const QByteArray table = "0,0,0.25,300,a\n1,1,2,2,b\n3,0,3.25,300,a\n5,0,5.25,300,b\n";
        const QStringList options = kwc + QStringList{"-f", "csv", "-q"};
        const auto numbers = [](const QByteArray& csv) {
            QByteArrayList all;
            for (const QByteArray& line : csv.split('\n'))
                all << line.left(3);
            return all;
        };
        const auto given = clearcut(
            QStringList{"compare", "-", "--from", "csv", "-w", "0,0,300,300"} + options, table);
        QCOMPARE(numbers(given.out), (QByteArrayList{"lin", "1,1", "3,3", "4,4", ""}));
        const auto page =
            clearcut(QStringList{"compare", "-", "--from", "csv", "--page"} + options, table);
        QCOMPARE(numbers(page.out), numbers(given.out));
    }

    void rowsComeBeforeTheInputEnds()
    {
        QProcess process;
        process.start(QStringLiteral(CLEARCUT_BINARY), compare + kwc + QStringList{"-q"});
        const auto wait = [&](const QByteArray& expected) {
            QByteArray got;
            while (got.size() < expected.size() && process.waitForReadyRead(20'000))
                got += process.readAllStandardOutput();
            return got;
        };
        process.write(lost + "3,3,");
        const QByteArray first = header + rowOfLost(1);
        QCOMPARE(wait(first), first);
        process.write("4,4\n" + lost);
        QCOMPARE(wait(rowOfLost(3)), rowOfLost(3));
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.exitCode(), 3);
    }

    void memoryDoesNotGrow()
    {
        QProcess process;
        process.setStandardOutputFile(QProcess::nullDevice());
        process.start(QStringLiteral(CLEARCUT_BINARY), compare + kwc);
        QVERIFY(process.waitForStarted());
        const QByteArray rows = lost.repeated(10'000);
        for (int i = 0; i < 80; ++i) {
            process.write(rows);
            while (process.bytesToWrite() > 0)
                QVERIFY(process.waitForBytesWritten(20'000));
        }
        const QByteArray most = peakKilobytes(process);
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished(20'000));
        QVERIFY(process.readAllStandardError().endsWith(
            "KWC as published loses 800,000 lines that exact keeps.\n"));
        QVERIFY(most.toInt() > 0);
        QVERIFY2(!memoryCanBeLimited || most.toInt() < 100'000, most);
    }

    void aReaderThatGoesEndsTheWork()
    {
        const auto run =
            inShell("yes 100,0,100.5,300 | $clearcut compare - --from csv -f csv -w 0,0,300,300 "
                    "-a kwc:published | head -n 1; echo ${PIPESTATUS[1]}");
        QCOMPARE(run.out, header + "3\n");
        QCOMPARE(run.err, "");
    }

    void aBadRowEndsTheWorkWhileTheInputIsSilent()
    {
        const auto run = endedByBadRow(compare + kwc, lost);
        QCOMPARE(run.code, 1);
        QCOMPARE(run.err,
                 "clearcut compare: Cannot read standard input: line 2 has “bad” where a number "
                 "is needed.\n");
    }

    void badRowsAreCountedAndSkipped()
    {
        const auto run = clearcut(compare + kwc + QStringList{"--skip-bad"},
                                  "x1,y1,x2,y2\nbad\n" + lost + "1,1,2\n0,0,1,1\n");
        QCOMPARE(run.code, 3);
        QCOMPARE(run.out, header + rowOfLost(2));
        QVERIFY2(run.err.startsWith("Skipped: line 2 has “bad” where a number is needed.\n"
                                    "Skipped: line 4 has 3 columns; x1, y1, x2 and y2 are "
                                    "needed.\nBad rows skipped: 2.\nWindow (given): "),
                 run.err);
        QVERIFY2(run.err.endsWith("KWC as published loses 1 line that exact keeps.\n"), run.err);
        const auto noWindow =
            clearcut(QStringList{"compare", "-", "--from", "csv", "--skip-bad"} + kwc, "0,0,1,1\n");
        QCOMPARE(noWindow.code, 2);
        QVERIFY2(noWindow.err.contains("--skip-bad needs a table"), noWindow.err);
    }

    void filesAreWrittenOnlyWhenComplete()
    {
        const QString in = folder_.filePath("in.csv"), out = folder_.filePath("out.csv");
        writeText(in, lost + "bad\n");
        writeText(out, "old");
        const QStringList toFile =
            QStringList{"compare", in, "-w", "0,0,300,300", "-o", out, "-q"} + kwc;
        QCOMPARE(clearcut(toFile).code, 1);
        QCOMPARE(contentOf(out), "old");
        QCOMPARE(clearcut(toFile + QStringList{"--skip-bad"}).code, 3);
        QCOMPARE(contentOf(out), header + rowOfLost(1));
    }
};

} // namespace command_line_table_compare_test

TEST_CLASS(command_line_table_compare_test::TableCompareTest, Core)
#include "tests/app/command_line/table_compare_test.moc"
