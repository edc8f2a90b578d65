// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QTest>

#include <algorithm>
#include <random>

#include "tests/app/command_line/program.h"
#include "tests/app/command_line/running.h"
#include "tests/app/command_line/silent_input.h"
#include "tests/sanitizer.h"
#include "tests/test_class.h"

namespace command_line_table_clip_test {

namespace {

const QByteArray header = "x1,y1,x2,y2,layer,colour,width,source\n";
const QStringList clip{"clip", "-", "--from", "csv", "--to", "csv", "-o", "-"};

// Rows with everything that a table may have.
QByteArray oddTable()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-200, 200);
    const QByteArrayList layers{"", "a", "b c", "\"x, \"\"y\"\"\"", "\"two\nlines\"", " ä "};
    const QByteArrayList colours{"", "#ff0000", " #00FF0080"}, widths{"", "2.50", "0"};
    QByteArray text = "\xef\xbb\xbf# a remark, \"quoted\n";
    for (int i = 0; i < 9000; ++i) {
        for (int n = 0; n < 4; ++n)
            text += (i % 5 ? QByteArray::number(place(random), 'g', 17)
                           : QByteArray::number(int(place(random))))
                    + ',';
        text += layers[(i / 7) % layers.size()] + ',' + colours[(i / 5) % 3] + ','
                + widths[(i / 3) % 3] + (i % 4 ? "\n" : "\r\n\n");
    }
    return text + "-0,0,0,-0\n5,5,5,5\n-200,75,200,75\n 1 , +2,3e1,-4,last,#112233,1";
}

} // namespace

class TableClipTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    // --occlude changes no table, but needs all lines at once.
    void rowByRowAsAllAtOnce_data()
    {
        QTest::addColumn<QStringList>("options");
        const QStringList window{"-w", "-100,-75,100,75"};
        const QStringList circle{"-w", "circle:0,0,90"};
        QTest::newRow("window") << window;
        QTest::newRow("outside") << window + QStringList{"--keep", "outside"};
        QTest::newRow("rotated") << QStringList{"-w", "-100,-75,100,75@30"};
        QTest::newRow("circle") << circle;
        QTest::newRow("outside a circle") << circle + QStringList{"-k", "outside"};
        QTest::newRow("concave") << QStringList{"-w", "polygon:-90,-90 90,-90 0,0 90,90 -90,90",
                                                "--keep", "outside"};
        QTest::newRow("several") << window + circle
                                        + QStringList{"--cut-out", "-20,-20,20,20", "--intersect",
                                                      "-150,-60,150,60"};
        QTest::newRow("several, by a row without regions")
            << window + QStringList{"--cut-out", "-20,-20,20,20", "-a", "liang-barsky"};
        QTest::newRow("published")
            << window + QStringList{"-a", "liang-barsky", "--form", "published"};
        QTest::newRow("decimals") << window + QStringList{"--precision", "2"};
        QTest::newRow("no short pieces") << window + QStringList{"--min-length", "30"};
        QTest::newRow("millimetres") << QStringList{"-w", "-10mm,-10mm,20mm,20mm"};
        QTest::newRow("no decimals") << window + QStringList{"--precision", "0"};
    }
    void rowByRowAsAllAtOnce()
    {
        QFETCH(QStringList, options);
        static const QByteArray table = oddTable();
        const auto rows = clearcut(clip + options, table);
        const auto whole = clearcut(clip + options + QStringList{"--occlude"}, table);
        QCOMPARE(rows.code, 0);
        QVERIFY(rows.out.count('\n') > 1000);
        QVERIFY(rows.out == whole.out);
        const auto report = [](QByteArray text) { return text.sliced(text.indexOf("Shapes: ")); };
        QCOMPARE(report(rows.err).split('\n').first(), report(whole.err).split('\n').first());
    }

    void columnsMayComeInAnyOrder()
    {
        const auto run = clearcut(clip + QStringList{"-w", "0,0,9,9"},
                                  "Colour,y2,x2,note,Y1,X1\n#ff0000,8,9,?,2,1\n#00ff00,1,1,,0,0\n");
        QCOMPARE(run.out, header + "1,2,9,8,Drawing,#ff0000,1,0\n0,0,1,1,Drawing,#00ff00,1,1\n");
        QVERIFY2(run.err.startsWith("1 × column “note” (not kept)\n"), run.err);
    }

    // Tables with other separators, names and decimal commas: the same rows and the same report,
    // whether they are read row by row or as a drawing.
    void dialectsAreReadAlike_data()
    {
        QTest::addColumn<QByteArray>("table");
        QTest::addColumn<bool>("told");
        QTest::newRow("commas") << QByteArray("x0,y0,x1,y1\n1.5,1.5,20,5\n-1,2,3,4\n") << false;
        QTest::newRow("semicolons") << QByteArray("x1;y1;x2;y2\n1,5;1,5;20;5\n-1;2;3;4\n") << true;
        QTest::newRow("tabs") << QByteArray("1,5\t1,5\t20\t5\r\n-1\t2\t3\t4") << true;
        QTest::newRow("blanks") << QByteArray(" 1.5 1.5  20 5 \n-1 2 3\t4\n") << true;
        QTest::newRow("quotes") << QByteArray("\"1,5\";1,5;20;\"5\"\n-1;2;\"3\";4\n") << true;
    }
    void dialectsAreReadAlike()
    {
        QFETCH(QByteArray, table);
        QFETCH(bool, told);
        const QStringList options = clip + QStringList{"-w", "0,0,10,10"};
        const auto rows = clearcut(options, table);
        const auto whole = clearcut(options + QStringList{"--occlude"}, table);
        QCOMPARE(rows.out, header
                               + "1.5,1.5,10,3.108108108108108,Drawing,#000000,1,0\n"
                                 "0,2.5,3,4,Drawing,#000000,1,1\n");
        QCOMPARE(whole.out, rows.out);
        QCOMPARE(rows.err.contains("1 × table has "), told);
        QCOMPARE(whole.err.contains("1 × table has "), told);
        const QByteArray withBad = table.trimmed() + "\na;b;c;d\n";
        const auto skipped = clearcut(options + QStringList{"--skip-bad"}, withBad);
        QCOMPARE(skipped.out, rows.out);
        QVERIFY(skipped.err.contains("Bad rows skipped: 1."));
    }

    void aFileThatIsNoTableSaysWhatItHas()
    {
        const auto run = clearcut(clip + QStringList{"-w", "0,0,9,9"}, "from;to\n1;2\n");
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("line 1 is neither four numbers nor a header with x1, y1, x2 and "
                                  "y2; it has 2 columns: “from”, “to”."),
                 run.err);
    }

    void piecesComeBeforeTheInputEnds()
    {
        QProcess process;
        process.start(QStringLiteral(CLEARCUT_BINARY), clip + QStringList{"-q", "-w", "0,0,9,9"});
        const auto wait = [&](const QByteArray& expected) {
            QByteArray got;
            while (got.size() < expected.size() && process.waitForReadyRead(20'000))
                got += process.readAllStandardOutput();
            return got;
        };
        process.write("1,1,2,2\n3,3,");
        const QByteArray first = header + "1,1,2,2,Drawing,#000000,1,0\n";
        QCOMPARE(wait(first), first);
        process.write("4,4\n");
        const QByteArray second = "3,3,4,4,Drawing,#000000,1,1\n";
        QCOMPARE(wait(second), second);
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.exitCode(), 0);
    }

    void memoryDoesNotGrow()
    {
        QProcess process, last;
        process.setStandardOutputProcess(&last);
        process.start(QStringLiteral(CLEARCUT_BINARY), clip + QStringList{"-w", "0,0,9,9"});
        last.start(QStringLiteral("tail"), {"-n", "1"});
        QVERIFY(process.waitForStarted());
        const QByteArray rows = QByteArray("-5,0,15,10\n").repeated(15'000);
        for (int i = 0; i < 100; ++i) {
            process.write(rows);
            while (process.bytesToWrite() > 0)
                QVERIFY(process.waitForBytesWritten(20'000));
        }
        const QByteArray most = peakKilobytes(process);
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished(20'000));
        QVERIFY(last.waitForFinished(20'000));
        QCOMPARE(last.readAllStandardOutput(), "0,2.5,9,7,Drawing,#000000,1,1499999\n");
        QVERIFY(most.toInt() > 0);
        QVERIFY2(!memoryCanBeLimited || most.toInt() < 100'000, most);
    }

    void aReaderThatGoesEndsTheWork()
    {
        const auto run = inShell("yes 1,1,2,2 | $clearcut clip - --from csv --to csv -w 0,0,9,9 -o "
                                 "- | head -n 1; echo ${PIPESTATUS[1]}");
        QCOMPARE(run.out, header + "0\n");
        QCOMPARE(run.err, "");
    }

    void aBadRowEndsTheWorkWhileTheInputIsSilent()
    {
        const auto run = endedByBadRow(clip + QStringList{"-w", "0,0,9,9"}, "0,0,1,1\n");
        QCOMPARE(run.code, 1);
        QCOMPARE(run.err,
                 "clearcut clip: Cannot read standard input: line 2 has “bad” where a number is "
                 "needed.\n");
    }

    void aReaderThatGoesEndsTheWorkWhileTheInputIsSilent()
    {
        QProcess process;
        Pipe output;
        process.setChildProcessModifier([&] { ::dup2(output.in, STDOUT_FILENO); });
        process.start(QStringLiteral(CLEARCUT_BINARY), clip + QStringList{"-w", "0,0,9,9"});
        process.write("1,1,2,2\n");
        QVERIFY(process.waitForBytesWritten(20'000));
        output.close(output.in);
        const QByteArray first = header + "1,1,2,2,Drawing,#000000,1,0\n";
        QCOMPARE(readFrom(output.out, first.size()), first);
        output.close(output.out);
        process.write("1,1,2,2\n");
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.exitCode(), 0);
        QCOMPARE(process.readAllStandardError(), "");
    }

    void anInputThatDoesNotBlockIsReadToItsEnd()
    {
        QProcess process;
        Pipe input;
        ::fcntl(input.out, F_SETFL, O_NONBLOCK);
        process.setChildProcessModifier([&] { ::dup2(input.out, STDIN_FILENO); });
        process.start(QStringLiteral(CLEARCUT_BINARY), clip + QStringList{"-q", "-w", "0,0,9,9"});
        QTest::qSleep(100);
        const QByteArray rows = "1,1,2,2\n3,3,4,4\n";
        for (const QByteArray& row : {rows.first(8), rows.sliced(8)}) {
            QCOMPARE(::write(input.in, row.data(), 8), 8);
            process.waitForReadyRead(20'000);
        }
        input.close(input.in);
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.readAllStandardError(), "");
        QCOMPARE(process.readAllStandardOutput(),
                 header + "1,1,2,2,Drawing,#000000,1,0\n3,3,4,4,Drawing,#000000,1,1\n");
    }

    void badRowsAreNamed()
    {
        const QByteArray table = "x1,y1,x2,y2\n1,1,2,2\n\n\"1\n\",2,3\n3,3,4,4\n5,5,6,1e400\n";
        const QStringList window{"-w", "0,0,9,9"};
        const auto ends = clearcut(clip + window, table);
        QCOMPARE(ends.code, 1);
        QCOMPARE(ends.out, header + "1,1,2,2,Drawing,#000000,1,0\n");
        QCOMPARE(ends.err, "clearcut clip: Cannot read standard input: line 4 has “1” where a "
                           "number is needed.\n");
        const auto skips = clearcut(clip + window + QStringList{"--skip-bad"}, table);
        QCOMPARE(skips.code, 0);
        QCOMPARE(skips.out, ends.out + "3,3,4,4,Drawing,#000000,1,2\n");
        QVERIFY2(skips.err.startsWith("Skipped: line 4 has “1” where a number is needed.\n"
                                      "Skipped: line 7 has “1e400”, which is too large"),
                 skips.err);
        QVERIFY2(skips.err.contains("\nBad rows skipped: 2.\nShapes: 2 kept whole"), skips.err);
        const auto many = clearcut(clip + window + QStringList{"--skip-bad"},
                                   "0,0,1,1\n" + QByteArray("bad\n").repeated(50'000));
        QCOMPARE(many.err.count("Skipped: "), 10);
        QVERIFY2(many.err.contains("Bad rows skipped: 50000.\n"), many.err);
    }

    void filesAreWrittenOnlyWhenComplete()
    {
        const QString in = folder_.filePath("in.csv"), out = folder_.filePath("out.csv");
        writeText(in, "0,0,1,1\nbad\n");
        writeText(out, "old");
        const QStringList toFile{"clip", in, "-w", "0,0,9,9", "-o", out};
        const auto run = clearcut(toFile);
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.startsWith("clearcut clip: Cannot read " + in.toUtf8() + ": line 2 has"),
                 run.err);
        QCOMPARE(contentOf(out), "old");
        QCOMPARE(clearcut(toFile + QStringList{"--skip-bad"}).code, 0);
        QCOMPARE(contentOf(out), header + "0,0,1,1,Drawing,#000000,1,0\n");
    }

    void aFileThatIsNotThereIsSaid()
    {
        for (const char* name : {"none", "none.csv"}) {
            const QString in = folder_.filePath(QString::fromUtf8(name));
            const auto run = clearcut({"clip", in, "--to", "csv", "-w", "0,0,9,9", "-o", "-"});
            QCOMPARE(run.code, 1);
            QCOMPARE(run.err,
                     "clearcut clip: Cannot open " + in.toUtf8() + ": there is no such file.\n");
        }
    }

    void optionsOfTablesNeedATable()
    {
        for (const char* option : {"--skip-bad", "--rows-only"}) {
            const auto run = clearcut(clip + QStringList{"--page", option}, "0,0,1,1\n");
            QCOMPARE(run.code, 2);
            QVERIFY2(run.err.contains(QByteArray(option) + " needs a table"), run.err);
        }
    }

    // The example of resources/manual/streams.md.
    void theSameFilterRunsUnderGnuParallel()
    {
        if (QStandardPaths::findExecutable(QStringLiteral("parallel")).isEmpty())
            QSKIP("GNU parallel is not installed");
        writeText(folder_.filePath("lines.csv"), oddTable().replace("\"two\nlines\"", "two"));
        const auto run = inShell(
            "cd " + folder_.path()
            + "; export PATH=$(dirname $clearcut):$PATH; clearcut clip lines.csv -w "
              "-100,-75,100,75 "
              "--rows-only -q --to csv -o - | sort > one.csv; parallel --will-cite --pipe --block "
              "50k -k clearcut clip - --from csv --to csv -w -100,-75,100,75 --rows-only -q -o - < "
              "lines.csv | sort | cmp - one.csv && wc -l < one.csv");
        QVERIFY2(run.code == 0 && run.out.trimmed().toInt() > 1000, run.out + run.err);
    }
};

} // namespace command_line_table_clip_test

TEST_CLASS(command_line_table_clip_test::TableClipTest, Core)
#include "tests/app/command_line/table_clip_test.moc"
