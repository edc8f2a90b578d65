// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_geojson_test {

namespace {

const QByteArray map = R"({"type":"LineString","coordinates":[[0,0],[60,60]]})";

Ended run(const QStringList& options) { return clearcut(options, map); }

} // namespace

class GeojsonTest : public QObject {
    Q_OBJECT

private slots:
    void aMapIsDrawnAsAskedAndWrittenInDegrees()
    {
        const auto drawn = run({"convert", "-", "--from", "geojson", "--projection", "web-mercator",
                                "--to", "csv", "-o", "-"});
        QVERIFY2(drawn.out.contains("\n0,0,60,-75.456"), drawn.out);
        QVERIFY2(drawn.err.contains("drawn as Web Mercator"), drawn.err);
        const auto cut =
            run({"clip", "-", "--from", "geojson", "--projection", "web-mercator", "-w",
                 "0,-37.72822,60,0", "--precision", "3", "--to", "geojson", "-o", "-"});
        QVERIFY2(cut.out.contains("[[0,0],[30,35.265]]") || cut.out.contains("[[0,0],[30,35.264]]"),
                 cut.out);
    }
    void aProjectionNeedsAMap()
    {
        const auto none = clearcut({"convert", "-", "--from", "csv", "--projection", "web-mercator",
                                    "--to", "csv", "-o", "-"},
                                   "0,0,9,9\n");
        QCOMPARE(none.code, 2);
        QVERIFY2(none.err.contains("--projection is for geojson maps."), none.err);
        QCOMPARE(
            clearcut({"info", "-", "--from", "csv", "--projection", "plate-carree"}, "0,0,9,9\n")
                .code,
            2);
        const auto unknown = run({"info", "-", "--from", "geojson", "--projection", "round"});
        QCOMPARE(unknown.code, 2);
        QVERIFY2(unknown.err.contains("--projection round: give plate-carree or web-mercator"),
                 unknown.err);
    }
};

} // namespace command_line_geojson_test

TEST_CLASS(command_line_geojson_test::GeojsonTest, Core)
#include "tests/app/command_line/geojson_test.moc"
