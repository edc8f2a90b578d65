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
    // In a drawing of which a unit is a degree, the map ends at 180.
    void whatLiesOutsideTheMapIsTold()
    {
        const QByteArray table = "0,-180,60,-190\n0,0,181,179.9999999999\n";
        const auto told = [&](const QByteArray& lines, const QStringList& options) {
            return clearcut(QStringList{options.first(), "-", "--from", "csv", "--to", "geojson"}
                                + options.mid(1) + QStringList{"-o", "-"},
                            lines)
                .err;
        };
        const QByteArray end = ": Web Mercator ends at 85.05° of latitude and 180° of longitude.";
        const QStringList convert{"convert", "--projection", "web-mercator"};
        QVERIFY2(told(table, convert)
                     .contains("2 positions lie outside the map and are written as they are" + end),
                 told(table, convert));
        QVERIFY(told("0,-180,60,190\n", convert)
                    .contains("1 position lies outside the map and is written as it is" + end));
        QVERIFY(!told("0,-180,60,180\n", convert).contains("map"));
        QVERIFY(!told(table, {"convert"}).contains("map"));
        const QStringList clip{"clip", "--projection", "web-mercator", "-w", "0,-180,170,180"};
        QVERIFY(!told(table, clip).contains("outside the map")); // no more there
        QVERIFY(told(table, {"clip", "--projection", "web-mercator", "-w", "0,-185,170,180"})
                    .contains("1 position lies outside the map"));
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
