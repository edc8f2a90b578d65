// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_dxf_test {

namespace {

/// A line from (0, 0) to (80, 60) on the layer Walls, and something that is not read.
QByteArray plan(const QByteArray& header = {})
{
    return header
           + "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nWalls\n11\n80\n21\n60\n0\nRAY\n10\n1\n0\nENDSEC"
             "\n"
             "0\nEOF\n";
}

Ended run(const QString& command, const QStringList& options, const QByteArray& text = plan())
{
    return clearcut(QStringList{command, "-", "--from", "dxf"} + options, text);
}

} // namespace

class DxfTest : public QObject {
    Q_OBJECT

private slots:
    void aDrawingIsConverted()
    {
        const auto ended = run("convert", {"--to", "svg", "-o", "-"});
        QCOMPARE(ended.code, 0);
        QVERIFY2(ended.out.contains("\"Walls\"") && ended.out.contains("x2=\"80\" y2=\"-60\""),
                 ended.out);
        QCOMPARE(ended.err, "1 × entity of the type “RAY” (not kept; line 13)\n"
                            "1 × file without a unit was read in millimetres\n");
    }
    void aDrawingIsCutInItsOwnCoordinates()
    {
        const auto ended = run("clip", {"-w", "0,-30,40,0", "--to", "csv", "-o", "-"});
        QCOMPARE(ended.code, 0);
        QVERIFY2(ended.out.contains("\n0,0,40,-30,Walls"), ended.out);
    }
    void theUnitCanBeSaid()
    {
        QVERIFY(run("info", {}).out.contains("\n  unit    1mm\n"));
        const QByteArray inches = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n";
        QVERIFY(run("info", {}, plan(inches)).out.contains("\n  unit    25.4mm\n"));
        for (const QByteArray& header : {QByteArray(), inches}) {
            const auto ended = run("info", {"--unit", "m"}, plan(header));
            QVERIFY2(ended.out.contains("\n  unit    1000mm\n"), ended.out);
            QVERIFY(!ended.out.contains("without a unit"));
        }
        const auto unknown = run("info", {"--unit", "ell"});
        QCOMPARE(unknown.code, 2);
        QVERIFY2(unknown.err.contains("--unit ell: give a unit such as mm, m or in"), unknown.err);
        const auto other = clearcut({"info", "-", "--from", "csv", "--unit", "m"}, "0,0,9,9\n");
        QCOMPARE(other.code, 2);
        QVERIFY2(other.err.contains("--unit: a file of type csv is in its own unit."), other.err);
    }
    void linesAreJoinedWhenAsked()
    {
        const QByteArray corner = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nA\n11\n5\n"
                                  "0\nLINE\n8\nA\n10\n5\n11\n5\n21\n7\n0\nENDSEC\n0\nEOF\n";
        const QStringList options{"--to", "svg", "-o", "-"};
        QVERIFY(run("convert", options, corner).out.count("<line ") == 2);
        for (const char* command : {"convert", "clip"}) {
            const auto ended = run(command, options + QStringList{"--join", "0"}, corner);
            QVERIFY2(ended.out.contains("<polyline points=\"0 0 5 0 5 -7\""), ended.out);
        }
        const auto negative = run("convert", options + QStringList{"--join", "-1"}, corner);
        QVERIFY2(negative.code == 2 && negative.err.contains("--join must not be negative."),
                 negative.err);
    }
};

} // namespace command_line_dxf_test

TEST_CLASS(command_line_dxf_test::DxfTest, None)
#include "tests/app/command_line/dxf_test.moc"
