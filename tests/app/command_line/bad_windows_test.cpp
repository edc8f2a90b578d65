// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <numbers>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_bad_windows_test {

// Windows that no person means: each gives a defined result, or one sentence, and quickly.

namespace {

// The pieces of the line from (-99, 0) to (99, 0), or what was said.
QByteArray pieces(const QStringList& options, const QByteArray& line = "-99,0,99,0")
{
    const auto run = clearcut(
        QStringList{"clip", "-", "--from", "csv", "--to", "csv", "-o", "-", "-q"} + options,
        "x1,y1,x2,y2\n" + line + '\n');
    QByteArray ends;
    for (const QByteArray& row : run.out.split('\n').mid(1))
        if (const auto cells = row.split(','); cells.size() > 3)
            ends += cells[0] + ' ' + cells[2] + ';';
    return run.code == 0 ? ends : run.err;
}

// A drawing with one line and one path of many edges, which crosses the line often.
QByteArray coast(int edges)
{
    QByteArray path = "M";
    for (int i = 0; i < edges; ++i) {
        const double angle = 2 * std::numbers::pi * i / edges;
        const double radius = 40 + 5 * std::sin(97 * angle) + (i % 3) * 0.01;
        path += QByteArray::number(50 + radius * std::cos(angle), 'f', 5) + ','
                + QByteArray::number(50 + radius * std::sin(angle), 'f', 5) + ' ';
    }
    return "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
           "viewBox='0 0 100 100'><path d='M0,50 H100' stroke='black' fill='none'/>"
           "<path id='coast' fill='blue' stroke='black' d='"
           + path + "Z'/></svg>";
}

} // namespace

class BadWindowsTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void polygonsAreWhatTheirFillRuleSays_data()
    {
        QTest::addColumn<QString>("polygon");
        QTest::addColumn<QByteArray>("left");
        QTest::newRow("crosses itself: a bow tie")
            << "-20,-10 20,10 20,-10 -20,10" << QByteArray("-20 20;");
        QTest::newRow("twice around")
            << "0,-5 9,-5 9,5 0,5 0,-5 9,-5 9,5 0,5" << QByteArray("0 9;");
        QTest::newRow("repeated points")
            << "0,-5 0,-5 9,-5 9,-5 9,5 9,5 9,5 0,5" << QByteArray("0 9;");
        QTest::newRow("there and back: no area") << "0,-5 9,5 0,-5" << QByteArray();
        QTest::newRow("one point three times") << "1,0 1,0 1,0" << QByteArray();
        QTest::newRow("all on one line") << "0,0 5,0 9,0" << QByteArray();
        QTest::newRow("clockwise") << "0,5 9,5 9,-5 0,-5" << QByteArray("0 9;");
        QTest::newRow("a spike without area")
            << "0,-5 9,-5 9,0 50,0 9,0 9,5 0,5" << QByteArray("0 9;");
        QTest::newRow("its edge on the line") << "0,0 9,0 9,5 0,5" << QByteArray("0 9;");
        QTest::newRow("its corner on the line") << "0,0 9,5 -9,5" << QByteArray("0 0;");
        QTest::newRow("huge") << "-1e300,-1e300 1e300,-1e300 1e300,1e300 -1e300,1e300"
                              << QByteArray("-99 99;");
        QTest::newRow("tiny") << "0,-1e-300 1e-300,-1e-300 1e-300,1e-300 0,1e-300" << QByteArray();
    }
    void polygonsAreWhatTheirFillRuleSays()
    {
        QFETCH(QString, polygon);
        QFETCH(QByteArray, left);
        QElapsedTimer timer;
        timer.start();
        const QByteArray found = pieces({"-w", "polygon:" + polygon});
        if (qstrcmp(QTest::currentDataTag(), "tiny") != 0)
            QCOMPARE(found, left);
        QVERIFY(!found.contains("nan") && !found.contains("inf"));
        QVERIFY(timer.elapsed() < 10'000);
    }

    void windowsThatTouchAlongAnEdgeLeaveOnePiece()
    {
        QCOMPARE(pieces({"-w", "0,-5,9,5", "-w", "9,-5,20,5"}), "0 20;");
        QCOMPARE(pieces({"-w", "polygon:0,-5 9,-5 9,5 0,5", "-w", "polygon:9,-5 20,-5 20,5 9,5"}),
                 "0 20;");
        QCOMPARE(pieces({"-w", "0,-5,9,5", "-w", "polygon:9,-5 20,-5 20,5 9,5"}), "0 20;");
        QCOMPARE(pieces({"-w", "0,-5,20,5", "--cut-out", "9,-5,30,5"}), "0 9;");
        QCOMPARE(pieces({"-w", "0,-5,9,5", "--cut-out", "polygon:9,-5 20,-5 20,5 9,5"}), "0 9;");
        QCOMPARE(
            pieces({"-w", "polygon:0,-5 9,-5 9,5 0,5", "--intersect", "9,-5,30,5"}, "9,-9,9,9"),
            "9 9;");
    }

    void whatIsNoNumberIsRefused_data()
    {
        QTest::addColumn<QString>("window");
        for (const char* window :
             {"nan,0,1,1", "0,0,inf,1", "0,0,1,1@nan", "circle:0,0,nan", "circle:0,0,0",
              "circle:0,0,-1", "polygon:0,0 nan,1 1,1", "polygon:0,0 1,1",
              "polygon:", "polygon:0,0 1e999,1 1,1", "0,0,1,1@1e999", "shape:", "layer:", "file:"})
            QTest::newRow(window) << QString::fromUtf8(window);
    }
    void whatIsNoNumberIsRefused()
    {
        QFETCH(QString, window);
        const auto run =
            clearcut({"clip", "-", "--from", "csv", "--to", "csv", "-o", "-", "-w", window},
                     "x1,y1,x2,y2\n0,0,1,1\n");
        QVERIFY2(run.code == 1 || run.code == 2, run.err);
        QVERIFY(run.out.isEmpty());
        QCOMPARE(run.err.trimmed().count('\n') <= 1, true);
    }

    // Cutting the window's own shape and a line at it.
    void aWindowOfAHundredThousandEdgesIsQuick()
    {
        const QString path = folder_.filePath("coast.svg");
        writeText(path, coast(100'000));
        for (const QStringList& more :
             {QStringList{}, QStringList{"--keep", "outside"}, QStringList{"--occlude"}}) {
            QElapsedTimer timer;
            timer.start();
            const auto run = clearcut(
                QStringList{"clip", path, "-w", "shape:coast", "-o", folder_.filePath("out.svg")}
                + more);
            QVERIFY2(run.code == 0, run.err);
            QVERIFY2(timer.elapsed() < 20'000, qPrintable(QString::number(timer.elapsed())));
        }
    }
};

} // namespace command_line_bad_windows_test

TEST_CLASS(command_line_bad_windows_test::BadWindowsTest, Core)
#include "tests/app/command_line/bad_windows_test.moc"
