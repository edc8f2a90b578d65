// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_compare_test {

namespace {

const QByteArray windowSaid = "Window (given): 0,0,300,300 in the drawing's coordinates, "
                              "0mm,0mm,79.375mm,79.375mm from the origin.\n";

} // namespace

/// `clearcut compare`, as people call it.
class CompareTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString file() const { return folder_.filePath("lines.csv"); }

private slots:
    /// Published KWC loses the first one: 300 long, and less than one wide.
    void init() { writeText(file(), "100,0,100.5,300\n0,0,300,300\n100,-50,250,350\n"); }

    void listsWhatDiffers()
    {
        const auto run = clearcut(
            {"compare", file(), "-w", "0,0,300,300", "-a", "kwc:published", "--format", "csv"});
        QCOMPARE(run.code, 3);
        QCOMPARE(run.err, windowSaid + "KWC as published loses 1 line that exact keeps.\n");
        const auto lines = run.out.split('\n');
        const auto row = std::ranges::find_if(
            lines, [](const QByteArray& line) { return line.contains("only_b"); });
        QVERIFY2(row != lines.end(), run.out.constData());
        QVERIFY2(row->startsWith("1,1,only_b,5.27766e+15,,,,,100,0,100.5,300,"), row->constData());
        QCOMPARE(run.out.count("only_b"), 1);
    }

    void agreementExitsWith0()
    {
        const auto run = clearcut({"compare", file(), "-a", "md", "-b", "lb", "-w", "0,0,300,300"});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.err, windowSaid + "They agree on all 3 lines here.\n");
        QCOMPARE(run.out, "");
    }

    void saysAtWhichWindow()
    {
        const auto said = [](const QByteArray& windows) {
            const auto run = clearcut({"compare", "-", "--from", "svg", "-a", "md"},
                                      "<svg xmlns='http://www.w3.org/2000/svg' "
                                      "xmlns:c='urn:clearcut:1' width='20mm' height='10mm' "
                                      "viewBox='0 0 20 10'><metadata>"
                                          + windows + "</metadata><path d='M0 0h9'/></svg>");
            return run.err.left(run.err.indexOf('\n'));
        };
        QCOMPARE(said({}), "Window (the page): 0,0,20,10 in the drawing's coordinates.");
        QCOMPARE(said("<c:window xmin='1' ymin='1' xmax='3' ymax='4'/><c:window xmin='2' ymin='2' "
                      "xmax='5' ymax='5'/>"),
                 "Window (saved in the drawing): 1,1,3,4 in the drawing's coordinates.");
        const auto table = clearcut({"compare", file(), "-a", "md"});
        QVERIFY2(
            table.err.startsWith("Window (the bounds of all objects): -0.5,-50.5,300.5,350.5 in "),
            table.err.constData());
    }

    void endsThatAreApartByUlps()
    {
        // One third is no number in binary: formulas round differently.
        writeText(file(), "0,0,3,1\n-1,0.1,2,1.1\n-1,0.7,6,2.3\n-5,0.3,7,1.7\n");
        const auto counted = [&](const char* ulps) {
            return clearcut({"compare", file(), "-w", "1,0,2,2", "-a", "cb:published", "--ulps",
                             ulps, "--format", "csv"});
        };
        const auto none = counted("0"), many = counted("64");
        QCOMPARE(none.code, 3);
        QVERIFY(none.out.contains(",ends,"));
        QCOMPARE(many.code, 0);
        QVERIFY(!many.out.contains(",ends,"));
    }

    void theMisprint()
    {
        const auto run =
            clearcut({"compare", file(), "-w", "0,0,300,300", "-a", "md-step-2", "--summary"});
        QCOMPARE(run.code, 3);
        QCOMPARE(run.out, "");
        QVERIFY2(run.err.contains("\nMD with Step 2 as printed "), run.err.constData());
        const auto quiet = clearcut(
            {"compare", file(), "-w", "0,0,300,300", "-a", "md-step-2", "--summary", "-q"});
        QCOMPARE(quiet.code, 3);
        QCOMPARE(quiet.err, "");
    }

    void summaryIsDataToo()
    {
        const auto run = clearcut({"compare", file(), "-w", "0,0,300,300", "-a", "kwc:published",
                                   "--summary", "-f", "csv"});
        QCOMPARE(run.code, 3);
        QCOMPARE(run.out, "a,b,ulps_allowed,window,lines,differing\n"
                          "kodituwakku-wijeweera-chamikara:published,exact,24.5,"
                          "\"0,0,300,300\",3,1\n");
        const auto json = clearcut({"compare", file(), "-w", "0,0,300,300", "-a", "kwc:published",
                                    "--summary", "-f", "json"});
        QVERIFY2(json.out.contains("\"differing\": 1"), json.out.constData());
    }

    void wrongUsage()
    {
        for (const QStringList& wrong :
             {QStringList{"compare", file()}, QStringList{"compare", file(), "-a", "nobody"},
              QStringList{"compare", file(), "-a", "kwc", "-b", "kwc"},
              QStringList{"compare", file(), "-a", "exact:published"},
              QStringList{"compare", file(), "-a", "md", "--ulps", "-1"},
              QStringList{"compare", file(), "-a", "md", "-w", "9,9,0,0"}}) {
            const auto run = clearcut(wrong);
            QVERIFY2(run.code == 2, qPrintable(wrong.join(u' ')));
            QCOMPARE(run.out, "");
        }
        QCOMPARE(clearcut({"compare", "/nowhere.svg", "-a", "md"}).code, 1);
    }
};

} // namespace command_line_compare_test

TEST_CLASS(command_line_compare_test::CompareTest, None)
#include "tests/app/command_line/compare_test.moc"
