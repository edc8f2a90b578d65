// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace command_line_bench_test {

class BenchTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const QString& name) const { return folder_.filePath(name); }

    static QJsonArray tablesOf(const QByteArray& json)
    {
        return QJsonDocument::fromJson(json).array();
    }

private slots:
    void withoutADisplayItDrawsByRaster()
    {
        const QStringList draw{"bench", "-n", "1000", "-r", "1", "-a", "md", "--measure", "draw"};
        const auto run = clearcut(draw + QStringList{"-f", "json"});
        QCOMPARE(run.code, 0);
        QVERIFY(tablesOf(run.out)[0].toObject()["facts"].toObject()["drawn"].toString().startsWith(
            "raster"));
        const auto refused = clearcut(draw + QStringList{"--draw-with", "opengl"});
        QCOMPARE(refused.code, 1);
        QVERIFY(refused.err.contains("OpenGL cannot draw here: it needs a display."));
    }

    // Dots would be read as points by whoever reads the file elsewhere.
    void countsLookTheSameInEveryCountry()
    {
        const auto run = inShell("LC_ALL=de_DE.UTF-8 $clearcut bench --paper table1 --quick "
                                 "--measure clip -f markdown");
        QCOMPARE(run.code, 0);
        QVERIFY(run.out.contains("100,000 lines") && !run.out.contains("100.000"));
    }

    void aDisplayThatIsNotThereIsNone()
    {
        for (const QString display :
             {"DISPLAY=:987", "WAYLAND_DISPLAY=none XDG_RUNTIME_DIR=/tmp", "QT_QPA_PLATFORM=xcb",
              "QT_QPA_PLATFORM=linuxfb:fb=/nonexistent"}) {
            const auto run =
                inShell(display + " $clearcut bench -n 1000 -r 1 -a md --measure draw");
            QCOMPARE(run.code, 0);
            QVERIFY(run.out.contains("raster, Qt"));
            QCOMPARE(run.err, "");
        }
    }

    void aRotatedRectangleIsForAllAndAConvexWindowForSome()
    {
        const QStringList bench{"bench", "-n", "2000", "-r", "1", "-f", "json", "-w"};
        const auto rows = [](const QByteArray& json) {
            return tablesOf(json)[0].toObject()["rows"].toArray();
        };
        const auto rotated = clearcut(bench + QStringList{"-100,-75,100,75@30"});
        QCOMPARE(rotated.code, 0);
        QCOMPARE(rotated.err, "");
        const auto facts = tablesOf(rotated.out)[0].toObject()["facts"].toObject();
        QCOMPARE(facts["window"].toString(), "-100,-75,100,75@30");
        QVERIFY(rows(rotated.out).size() > 20);
        const auto straight = clearcut(bench + QStringList{"-100,-75,100,75"});
        QCOMPARE(rows(rotated.out).size() + 1, rows(straight.out).size()); // not one by one
        const auto circle = clearcut(bench + QStringList{"circle:0,0,90"});
        QCOMPARE(circle.code, 0);
        QVERIFY2(circle.err.startsWith("Left out, because they clip at rectangles only: CS,"),
                 circle.err.constData());
        QCOMPARE(rows(circle.out).size(), 4);
        for (const auto& row : rows(circle.out)) {
            QCOMPARE(row.toObject()["visible"], rows(circle.out)[0].toObject()["visible"]);
            QCOMPARE(row.toObject()["lost"].toVariant().toInt(), 0);
        }
        for (const QStringList& more : {QStringList{"--scene", "inside"},
                                        {"--measure", "operations"},
                                        {"--order", "sorted"},
                                        {"--precision", "single"},
                                        {"-a", "lb"},
                                        {"--paper", "table1"}})
            QCOMPARE(clearcut(bench + QStringList{"circle:0,0,90"} + more).code, 2);
        const QByteArray concave = clearcut(bench + QStringList{"polygon:0,0 90,0 20,20 0,90"}).err;
        QVERIFY2(concave.contains("this window is concave, 4 edges."), concave.constData());
    }

    void peopleReadTheRankFirst()
    {
        const QStringList bench{"bench", "-n", "2000", "-r", "6", "-a", "cs,kwc,md"};
        const auto brief = clearcut(bench), verbose = clearcut(bench + QStringList{"-v"});
        QCOMPARE(brief.code, 0);
        const auto head = [](const QByteArray& text) {
            return text.mid(text.indexOf("algorithm"), 200).simplified();
        };
        QVERIFY2(head(brief.out).startsWith("algorithm form rank median_ns ratio_fastest lost"),
                 head(brief.out));
        for (const char* part : {"processor", "compiler", "-v"})
            QVERIFY2(brief.out.contains(part), part);
        for (const char* part : {"checksum", "spread", "seed", "Low to high"})
            QVERIFY2(!brief.out.contains(part) && verbose.out.contains(part), part);
        for (const auto& line : notEmpty(brief.out.split('\n')))
            QVERIFY2(QString::fromUtf8(line).size() <= 80, line);
        // As data there is everything.
        const auto csv = clearcut(bench + QStringList{"-f", "csv"});
        QVERIFY(csv.out.startsWith("algorithm,form,rank,letters,median_ns,"));
    }

    void everyRunCanHaveARow()
    {
        const auto run = clearcut({"bench", "-n", "1000", "-r", "3", "-a", "cs,md", "--form",
                                   "corrected", "--each-run", "-f", "csv"});
        QCOMPARE(run.code, 0);
        const auto lines = run.out.trimmed().split('\n');
        QCOMPARE(lines.size(), 1 + 2 * 3);
        QVERIFY(lines[0].startsWith("algorithm,form,measure,run,lines,visible,seconds,"));
        QVERIFY(lines[6].startsWith("matthes-drakopoulos,corrected,clip,3,1000,"));
    }

    /// The runs have the same lines as in one process, each run others than the one before.
    void eachRunCanBeAProcess()
    {
        const auto visible = [](const QStringList& more) {
            const auto run = clearcut(QStringList{"bench", "-n", "1000", "-r", "3", "-s", "7", "-a",
                                                  "cs,md", "--each-run", "-f", "json"}
                                      + more);
            const auto table = run.code == 0 ? tablesOf(run.out)[0].toObject() : QJsonObject();
            QStringList all{table["facts"].toObject()["processes"].toString()};
            for (const auto& row : table["rows"].toArray())
                all << row.toObject()["visible"].toVariant().toString();
            return all;
        };
        const QStringList one = visible({}), each = visible({"--processes"});
        QCOMPARE(one.size(), 1 + 2 * 2 * 3);
        QCOMPARE(one.front(), "one");
        QCOMPARE(each.front(), "one for each run");
        QCOMPARE(each.sliced(1), one.sliced(1));
        QVERIFY(one[1] != one[2] || one[2] != one[3]);
    }

    void singlePrecisionIsSaid()
    {
        const auto run =
            clearcut({"bench", "-n", "1000", "-r", "1", "--precision", "single", "-f", "json"});
        QCOMPARE(run.code, 0);
        const auto table = tablesOf(run.out)[0].toObject();
        QCOMPARE(table["facts"].toObject()["precision"].toString(), "single");
        for (const auto& row : notEmpty(table["rows"].toArray()))
            QCOMPARE(row.toObject()["form"].toString(), "corrected");
    }

    void threadsAreTimedByTheWall()
    {
        const auto run =
            clearcut({"bench", "-n", "200000", "-r", "2", "--threads", "2", "-f", "json"});
        if (run.code == 1) {
            QVERIFY(run.err.contains("one core, or Clearcut was built without oneTBB"));
            QSKIP("one core, or no oneTBB");
        }
        const auto table = tablesOf(run.out)[0].toObject();
        QCOMPARE(table["facts"].toObject()["threads"].toInt(), 2);
        QCOMPARE(table["facts"].toObject()["clock"].toString(), "wall");
        const auto rows = table["rows"].toArray();
        const auto alone =
            tablesOf(clearcut({"bench", "-n", "200000", "-r", "1", "-f", "json"}).out);
        const auto others = alone[0].toObject()["rows"].toArray();
        QVERIFY(!rows.isEmpty());
        QCOMPARE(others.size(), rows.size());
        for (int i = 0; i < rows.size(); ++i)
            QCOMPARE(rows[i].toObject()["checksum"], others[i].toObject()["checksum"]);
    }

    void reportsAndChartsAreWrittenBesideTheTables()
    {
        const auto run =
            clearcut({"bench", "--paper", "table1", "-n", "2000", "-r", "2", "--report",
                      path("r.html"), "--charts", path("c.svg"), "-f", "json"});
        QCOMPARE(run.code, 0);
        QVERIFY(!tablesOf(run.out).isEmpty());
        const auto html = contentOf(path("r.html"));
        QVERIFY(html.startsWith("<!DOCTYPE html>"));
        QVERIFY(html.endsWith("</html>\n"));
        for (const char* part : {"Accuracy", "Operations", "--paper=table1", "raster, Qt", "seed"})
            QVERIFY2(html.contains(part), part);
        const auto charts = QDir(folder_.path()).entryList({"c-*.svg"});
        QVERIFY(charts.contains("c-table1-clip-published.svg"));
        QVERIFY(charts.contains("c-table1-total-published-runs.svg"));
        QVERIFY(run.err.contains("Wrote " + path("r.html").toUtf8()));
        QCOMPARE(run.err.count("Wrote "), charts.size() + 1);

        const auto pdf = clearcut({"bench", "-n", "1000", "-r", "2", "-a", "cs,md", "--measure",
                                   "clip", "--report", path("r.pdf"), "-o", path("t.md")});
        QCOMPARE(pdf.code, 0);
        QCOMPARE(pdf.out, "");
        QVERIFY(contentOf(path("r.pdf")).startsWith("%PDF"));
        QVERIFY(contentOf(path("t.md")).startsWith("## Clipping only"));
    }

    void analysesGoWithThePaper()
    {
        const auto run = clearcut({"bench", "--paper", "table1", "-n", "1000", "-r", "1",
                                   "--measure", "clip,operations", "-f", "json"});
        QCOMPARE(run.code, 0);
        const auto tables = tablesOf(run.out);
        QCOMPARE(tables.size(), 2);
        QCOMPARE(tables[0].toObject()["table"].toString(), "table1-clip-published");
        QCOMPARE(tables[1].toObject()["table"].toString(), "operations");
        QCOMPARE(tables[1].toObject()["rows"].toArray()[0].toObject()["form"].toString(),
                 "published");
    }

    void unwritableOutputIsReportedBeforeTheWork()
    {
        const auto missing = clearcut({"bench", "-n", "4000000000", "--report", path("no/r.html")});
        QCOMPARE(missing.code, 1);
        QVERIFY(missing.err.contains("there is no folder"));
    }
};

} // namespace command_line_bench_test

TEST_CLASS(command_line_bench_test::BenchTest, Core)
#include "tests/app/command_line/bench_test.moc"
