// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/files.h"
#include "clipping/algorithm.h"

#include <QImage>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_costmap_test {

/// `clearcut costmap`, as people call it.
class CostmapTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void aTableOfWhatTheLibraryCounts()
    {
        const auto run = clearcut({"costmap", "-a", "nln:published", "-w", "0,0,2,2", "--from",
                                   "-1,1", "--area", "-2,-2,4,4", "--size", "3x2", "-o", "-"});
        QCOMPARE(run.code, 0);
        const auto lines = run.out.trimmed().split('\n');
        QCOMPARE(lines.size(), 7);
        QCOMPARE(lines.front(), "x,y,operations,fixed_end,fixed_x,fixed_y,window,algorithm");
        const auto& nln = *clipping::findAlgorithm("nln");
        for (qsizetype row = 1; row < lines.size(); ++row) {
            const auto fields = lines[row].split(',');
            const clipping::Segment line{{-1, 1}, {fields[0].toDouble(), fields[1].toDouble()}};
            const auto c = nln.published->count({&line, 1}, {{0, 0}, {2, 2}});
            QCOMPARE(fields[2].toULongLong(),
                     c.comparisons + c.additions + c.multiplications + c.divisions);
        }
        QVERIFY(lines[1].startsWith("-1,-0.5,") && lines[6].startsWith("3,2.5,"));
    }

    void thePictureAndTheCheapest()
    {
        const QString png = folder_.filePath("map.png"), csv = folder_.filePath("map.csv");
        QCOMPARE(clearcut({"costmap", "--cheapest", "--theme", "dark", "-o", png}).code, 0);
        QVERIFY(QImage(png).width() > 1000);
        QVERIFY(QImage(png).text("Title").startsWith("Cheapest algorithm"));
        QCOMPARE(clearcut({"costmap", "--cheapest", "--form", "published", "--measure", "divisions",
                           "--to", "0,0", "--size", "8x6", "-o", csv})
                     .code,
                 0);
        const QByteArray table = contentOf(csv);
        QVERIFY(table.startsWith("x,y,divisions,cheapest,"));
        QVERIFY(table.contains("nicholl-lee-nicholl:published"));
        QCOMPARE(table.count('\n'), 49);
    }

    void wrongUsageIsRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QStringList& arguments, const QString& says) {
            QTest::newRow(name) << arguments << says;
        };
        row("neither", {"-o", "-"}, "either -a");
        row("both", {"-a", "md", "--cheapest", "-o", "-"}, "either -a");
        row("no output", {"-a", "md"}, "-o");
        row("ending", {"-a", "md", "-o", "map.unknown"}, app::endingsOf(app::costMapFormats()));
        row("algorithm", {"-a", "nobody", "-o", "-"}, "There is no algorithm “nobody”");
        row("point", {"-a", "md", "--from", "1,nan", "-o", "-"}, "two numbers");
        row("ends", {"-a", "md", "--from", "1,2", "--to", "1,2", "-o", "-"}, "one end");
        row("window", {"-a", "md", "-w", "2,0,1,1", "-o", "-"}, "four numbers");
        row("area", {"-a", "md", "--area", "0,0,0,1", "-o", "-"}, "empty");
        row("size", {"-a", "md", "--size", "0x5", "-o", "-"}, "whole numbers");
        row("measure", {"-a", "md", "--measure", "luck", "-o", "-"}, "operations or comparisons");
    }
    void wrongUsageIsRefused()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, says);
        const auto run = clearcut(QStringList("costmap") + arguments);
        QCOMPARE(run.code, 2);
        QVERIFY2(run.err.contains(says.toUtf8()), run.err.constData());
    }

    void unwritableOutputIsReported()
    {
        const auto run = clearcut({"costmap", "-a", "md", "-o", "/nowhere/map.csv"});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("/nowhere/map.csv"), run.err.constData());
    }
};

} // namespace command_line_costmap_test

TEST_CLASS(command_line_costmap_test::CostmapTest, Core)
#include "tests/app/command_line/costmap_test.moc"
