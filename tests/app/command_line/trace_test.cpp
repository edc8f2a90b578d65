// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_trace_test {

/// `clearcut trace`, as people call it.
class TraceTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    const QStringList md_{"trace", "-a", "md", "--line", "-160,-30,70,130"};

private slots:
    void textIsNumberedSteps()
    {
        const auto run = clearcut(md_);
        QCOMPARE(run.code, 0);
        QCOMPARE(run.err, "");
        QVERIFY2(run.out.startsWith("MD  Matthes-Drakopoulos\n"
                                    "Line:    \u2212160, \u221230 to 70, 130\n"
                                    "Window:  \u2212100, \u221275 to 100, 75, y grows up\n\n"
                                    "  1  "),
                 run.out.constData());
        QVERIFY(run.out.endsWith("\nVisible: \u2212100, 11.73913043478261 to \u22129.0625, 75\n"));
        for (const char* part : {"\n     line ", " = \u22129.0625 (was 70)", "divisions 2\n"})
            QVERIFY2(run.out.contains(part), part);
    }

    void yDownTurnsTheWordsOver()
    {
        QVERIFY(clearcut(md_).out.contains("to the top edge, to (\u22129.0625, 75)"));
        const auto down = clearcut(QStringList(md_) << "--y"
                                                    << "down")
                              .out;
        QVERIFY2(down.contains("to the bottom edge, to (\u22129.0625, 75)"), down);
    }

    void aRotatedWindowIsTracedInItsOwnDirections()
    {
        const auto quarter = clearcut(QStringList(md_) << "-w"
                                                       << "-75,-100,75,100@90");
        QCOMPARE(quarter.code, 0);
        QCOMPARE(quarter.out, clearcut(md_).out); // a quarter turn is along the axes again
        QCOMPARE(quarter.err, "");
        const auto run = clearcut(QStringList(md_) << "-w"
                                                   << "-100,-75,100,75@30");
        QCOMPARE(run.code, 0);
        QVERIFY2(run.err.startsWith("The window is rotated: "), run.err.constData());
        QVERIFY2(run.out.contains("Window:  \u2212100, \u221275 to 100, 75, y grows up\n"),
                 run.out.constData());
        QVERIFY(!run.out.contains("Line:    \u2212160"));
        for (const char* bad : {"0,0,9,9@", "0,0,9,9@x", "0,0,9,9@1@2", "0,0,9@3"})
            QCOMPARE(clearcut(QStringList(md_) << "-w" << bad).code, 2);
    }

    void aConvexWindowHasNumberedEdges()
    {
        const QStringList line{"trace", "--line", "-160,-30,70,130", "-w"};
        const QString square = "polygon:-100,-75 100,-75 100,75 -100,75";
        for (const char* row : {"cb", "skala", "exact", "wn"}) {
            const auto run = clearcut(line + QStringList{square, "-a", row});
            QCOMPARE(run.code, 0);
            QVERIFY2(run.out.contains("End 1 is cut at edge 4: it moves to (\u2212100, 11.7391)."),
                     run.out.constData());
            QVERIFY2(run.out.contains("End 2 is cut at edge 3: it moves to (\u22129.0625, 75)."),
                     run.out.constData());
        }
        const auto json = clearcut(line + QStringList{square, "-a", "exact", "-f", "json"});
        const auto all = QJsonDocument::fromJson(json.out);
        QCOMPARE(all["corners"].toArray()[2].toArray(), (QJsonArray{100, 75}));
        QCOMPARE(clearcut(line + QStringList{"circle:0,0,90", "-a", "cb"}).code, 0);
        const auto refused = [&](const char* window, const char* row) {
            const auto run = clearcut(line + QStringList{window, "-a", row});
            return run.code == 2 ? run.err : QByteArray("not refused");
        };
        QVERIFY(refused("circle:0,0,9", "md")
                    .contains("Matthes-Drakopoulos clips at rectangles only. Choose Cyrus-Beck, "
                              "Skala, Winding "
                              "number or Exact."));
        QVERIFY(refused("circle:0,0,9", "skala:published").contains("Choose the corrected form."));
        QVERIFY(refused("polygon:0,0 9,0 2,2 0,9", "exact").contains("this polygon is not convex"));
        QVERIFY(refused("shape:a", "exact").contains("steps are shown at rectangles, circle:"));
    }

    void jsonIsWhatTheLibraryAnswers()
    {
        const auto run = clearcut(QStringList(md_) << "-f"
                                                   << "json");
        QCOMPARE(run.code, 0);
        const auto all = QJsonDocument::fromJson(run.out);
        QCOMPARE(all["visible"].toArray(), (QJsonArray{-100, 11.73913043478261, -9.0625, 75}));
        QCOMPARE(all["outcome"], "visible");
        QVERIFY(all["steps"].toArray().size() >= 3);
        const auto one = clearcut(QStringList(md_) << "-f"
                                                   << "json"
                                                   << "--step"
                                                   << "2");
        const auto steps = QJsonDocument::fromJson(one.out)["steps"].toArray();
        QCOMPARE(steps.size(), 1);
        QCOMPARE(steps[0], all["steps"][1]);
    }

    void publishedFormsMayNotEnd()
    {
        const auto run = clearcut({"trace", "-a", "cs:published", "--line", "1,1,-1,-1", "-w",
                                   "0.1,0.1,3,3", "-f", "json"});
        QCOMPARE(run.code, 0);
        QCOMPARE(QJsonDocument::fromJson(run.out)["outcome"], "did not end");
    }

    void filesOfEachFormat()
    {
        const QDir dir(folder_.path());
        for (const char* key : {"pdf", "gif", "text", "json"}) {
            const QString path = dir.filePath(QStringLiteral("one.") + key);
            const auto run = clearcut(QStringList(md_) << "-o" << path << "-f" << key);
            QCOMPARE(run.code, 0);
            QCOMPARE(run.err, "Wrote " + path.toUtf8() + '\n');
            QVERIFY(QFileInfo(path).size() > 500);
        }
        const auto run = clearcut(QStringList(md_) << "-f"
                                                   << "png"
                                                   << "-o" << dir.filePath("new/") << "--width"
                                                   << "320"
                                                   << "--picture-only");
        QVERIFY2(run.code == 0, run.err);
        const auto entries = QDir(dir.filePath("new")).entryList(QDir::Files);
        QVERIFY(entries.size() >= 3);
        QCOMPARE(entries.front(), "matthes-drakopoulos-01.png");
        QCOMPARE(QImage(dir.filePath("new/" + entries.front())).size(), QSize(320, 180));
    }

    void aMisprintIsTraced()
    {
        const auto run = clearcut({"trace", "-a", "md-step-2", "--line", "-160,-130,70,130"});
        QCOMPARE(run.code, 0);
        QVERIFY(run.out.startsWith("MD with Step 2 as printed\n"));
        QVERIFY2(run.out.contains("This is the misprint: as meant, run = 181.346."), run.out);
        QVERIFY2(run.out.contains("That is wrong: what lies inside runs from (−100, −62.1739) to "),
                 run.out);
        const auto json =
            clearcut({"trace", "-a", "md-step-2", "--line", "-160,-130,70,130", "-f", "json"});
        QVERIFY(json.out.contains("\"algorithm\": \"md-step-2\""));
    }

    void numberedFilesAreNotReplacedUnasked()
    {
        const QString name = folder_.filePath("talk.svg"), first = folder_.filePath("talk-01.svg");
        writeText(first, "somebody's own");
        const QStringList arguments = QStringList(md_) << "-o" << name;
        const auto refused = clearcut(arguments);
        QCOMPARE(refused.code, 1);
        QCOMPARE(refused.err, "clearcut trace: " + first.toUtf8()
                                  + " already exists. Give another name, or --overwrite.\n");
        QCOMPARE(contentOf(first), "somebody's own");
        QVERIFY(!QFile::exists(folder_.filePath("talk-02.svg")));
        const auto done = clearcut(QStringList(arguments) << "--overwrite"
                                                          << "-q");
        QCOMPARE(done.code, 0);
        QCOMPARE(done.err, "");
        QVERIFY(contentOf(first).contains("<svg"));
        const auto many = clearcut(arguments);
        QVERIFY2(many.err.contains("talk-01.svg and ")
                     && many.err.contains(" more files already exist"),
                 many.err);
    }

    void wrongUsage_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("part");
        const auto row = [](const char* name, const QStringList& given, const char* part) {
            QTest::newRow(name) << given << QByteArray(part);
        };
        row("no line", {}, "Give the line with --line X1,Y1,X2,Y2.");
        row("nan", {"--line", "nan,0,1,1"}, "--line nan,0,1,1: give four numbers");
        row("infinite", {"--line", "0,0,1e999,1"}, "“1e999” is too large");
        row("three", {"--line", "0,0,1"}, "give four numbers");
        row("window", {"--line", "0,0,1,1", "-w", "0,0,1,nan"}, "--window 0,0,1,nan: give four");
        row("min > max", {"--line", "0,0,1,1", "-w", "5,0,1,1"}, "minimum lies beyond its maximum");
        row("nobody", {"--line", "0,0,1,1", "-a", "nobody"}, "There is no algorithm “nobody”");
        row("no form", {"--line", "0,0,1,1", "-a", "exact:published"}, "exact:published");
        row("step 0", {"--line", "0,0,1,1", "--step", "0"}, "a whole number from 1 to");
        row("step beyond", {"--line", "0,0,1,1", "--step", "9999"}, "a whole number from 1 to");
        row("format", {"--line", "0,0,1,1", "-f", "unknown"}, "--format unknown");
        row("ending", {"--line", "0,0,1,1", "-o", "a.unknown"}, "give the format with --format");
        row("no name", {"--line", "0,0,1,1", "-f", "gif"}, "Name a file or a folder");
        row("option", {"--line", "0,0,1,1", "--setp", "1"}, "Did you mean “--step”?");
    }
    void wrongUsage()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, part);
        const auto run = clearcut(QStringList{"trace"} + arguments);
        QCOMPARE(run.code, 2);
        QCOMPARE(run.out, "");
        QVERIFY2(run.err.contains(part), run.err);
        QCOMPARE(run.err.count('\n'), 2); // the sentence, and the way to the help
    }

    void pointsAndWindowsWithoutSizeAreLegal()
    {
        const auto touching = clearcut({"trace", "--line", "0,0,2,2", "-w", "1,1,1,1", "-a", "lb"});
        QCOMPARE(touching.code, 0);
        QVERIFY(touching.out.endsWith("Visible: 1, 1 to 1, 1\n"));
        const auto point = clearcut({"trace", "--line", "9,9,9,9", "-w", "1,1,1,1"});
        QCOMPARE(point.code, 0);
        QVERIFY(point.out.endsWith("Nothing is visible.\n"));
        const auto huge = clearcut({"trace", "--line", "-1e308,-1e308,1e308,1.7e308", "-o",
                                    folder_.filePath("huge.png"), "--step", "1"});
        QVERIFY2(huge.code == 0, huge.err);
    }

    void missingFolderIsReported()
    {
        const auto run = clearcut(QStringList(md_) << "-o" << folder_.filePath("none/a.pdf"));
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("there is no folder"), run.err);
    }
};

} // namespace command_line_trace_test

TEST_CLASS(command_line_trace_test::TraceTest, Core)
#include "tests/app/command_line/trace_test.moc"
