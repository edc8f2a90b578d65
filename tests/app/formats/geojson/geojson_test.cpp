// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

#include "tests/app/formats/lossy.h"
#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace geojson_test {

using namespace app;

namespace {

/// The text with quotation marks for its apostrophes.
QByteArray json(QByteArray text) { return text.replace('\'', '"'); }

Result<Imported> readMap(const QByteArray& text, const ReadOptions& options = {})
{
    QBuffer buffer;
    buffer.setData(text);
    buffer.open(QIODevice::ReadOnly);
    return findFormat(u"geojson")->readWith(buffer, options);
}

QByteArray mapOf(const Document& document, const WriteOptions& options = {})
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const auto error = findFormat(u"geojson")->write(document, buffer, options);
    return error ? error->toUtf8() : buffer.data();
}

QByteArray lineText(const QByteArray& coordinates, const QByteArray& properties = "{}")
{
    return json("{'type':'Feature','properties':") + properties
           + json(",'geometry':{'type':'LineString','coordinates':") + coordinates + "}}";
}

/// The geometries of a written map.
QJsonArray geometriesOf(const QByteArray& text)
{
    QJsonArray all;
    for (const QJsonValue& feature : QJsonDocument::fromJson(text)["features"].toArray())
        all << feature["geometry"];
    return all;
}

QByteArray compact(const QJsonValue& value)
{
    return QJsonDocument(value.toArray()).toJson(QJsonDocument::Compact);
}

QByteArray mapOfSvg(const QByteArray& elements, const WriteOptions& options = {})
{
    return mapOf(readText(drawing(elements)).value->document, options);
}

} // namespace

class GeojsonTest : public QObject {
    Q_OBJECT

private slots:
    // The square of Web Mercator ends where x and y are 180 degrees. The other place is the example for
    // EPSG:3857 in IOGP's guidance note 373-7-2; its metres are 6,378,137 times as many radians.
    void degreesBecomeWebMercator()
    {
        const ReadOptions mercator{.projection = Projection::WebMercator};
        const auto read =
            readMap(lineText("[[0,0],[180,85.05112877980659],[-100.33333333333333,24.381786944444444]]"), mercator);
        QVERIFY2(read, qPrintable(read.error));
        const Subpath path = read.value->document.objects()[0].path().subpaths()[0];
        const auto isAt = [](const Point& p, double x, double y) {
            return std::abs(p.x - x) < 1e-9 && std::abs(p.y + y) < 1e-9;
        };
        QVERIFY(isAt(path.start, 0, 0));
        QVERIFY(isAt(path.segments[0].to, 180, 180));
        constexpr double metres = 6378137 * 3.14159265358979323846 / 180;
        QVERIFY(std::abs(path.segments[1].to.x * metres + 11169055.58) < 0.01);
        QVERIFY(std::abs(-path.segments[1].to.y * metres - 2800000.00) < 0.01);
        QCOMPARE(read.value->report.front().what,
                 "map in degrees, drawn as Web Mercator: a user unit for each degree of longitude");
    }
    void webMercatorIsWrittenAsDegreesAgain()
    {
        const QByteArray line = "[[-170.5,-85],[9.993682,53.551086],[0,1e-9],[12,60]]";
        const auto read = readMap(lineText(line), {.projection = Projection::WebMercator});
        const QByteArray text =
            mapOf(read.value->document,
                  {.precision = 9, .projection = Projection::WebMercator, .paged = false});
        QCOMPARE(compact(geometriesOf(text)[0].toObject()["coordinates"]),
                 "[[-170.5,-85],[9.993682,53.551086],[0,1e-09],[12,60]]");
    }
    void whereWebMercatorEndsIsTold()
    {
        const ReadOptions mercator{.projection = Projection::WebMercator};
        const auto read = readMap(lineText("[[0,-90],[1,90],[2,80]]"), mercator);
        QCOMPARE(read.value->report[1].what,
                 "positions beyond 85.05° of latitude, where Web Mercator ends");
        QCOMPARE(read.value->report[1].count, 2);
        QVERIFY(!read.value->report[1].remark);
        const auto metres = readMap(lineText("[[0,0],[500000,100]]"), mercator);
        QCOMPARE(metres.error,
                 "its positions are no degrees, so they cannot be drawn as Web Mercator.");
    }
    void linesLieWithNorthAbove()
    {
        const auto read = readMap(lineText("[[8.5,47.25],[9,48],[9.5,-1]]"));
        QVERIFY2(read, qPrintable(read.error));
        const Sheet sheet = sheetOf(read.value->document);
        QCOMPARE(sheet.shapes.size(), 1u);
        QCOMPARE(sheet.shapes[0].paths[0],
                 (Subpath{{8.5, -47.25}, {{{9, -48}}, {{9.5, 1}}}, false}));
        QVERIFY(!isLossy(*read.value));
        QVERIFY(read.value->report[0].what.contains("plate carrée"));
        QVERIFY(sheet.shapes[0].style.width < 0.1); // not as wide as the map
        QVERIFY(!read.value->paged);
        QCOMPARE(sheet.page.height.unit, Unit::Mm); // of a usual size, whatever a degree is
        QVERIFY(std::abs(sheet.page.height.value - 300) < 1e-9);
    }

    void polygonsHaveHolesAndLayersNames()
    {
        const auto read = readMap(
            json("{'type':'FeatureCollection','features':["
                 "{'type':'Feature','properties':{'layer':'lakes','fill':'#00f','fill-opacity':0.5,"
                 "'stroke-width':2,'depth':9},"
                 "'geometry':{'type':'Polygon','coordinates':[[[0,0],[9,0],[9,9],[0,0]],"
                 "[[5,1],[6,2],[5,2],[5,1]]]}},"
                 "{'type':'Feature','properties':null,'geometry':null},"
                 "{'type':'Feature','properties':{},'geometry':{'type':'GeometryCollection','"
                 "geometries':["
                 "{'type':'Point','coordinates':[1,2,300]},"
                 "{'type':'MultiLineString','coordinates':[[[0,0],[500,1]],[[2,2],[3,3]]]}]}}]}"));
        QVERIFY2(read, qPrintable(read.error));
        const Sheet sheet = sheetOf(read.value->document);
        QCOMPARE(sheet.shapes.size(), 3u);
        QCOMPARE(sheet.layers[0].name, "lakes");
        QCOMPARE(sheet.layers[1].name, "Drawing");
        const auto& lake = sheet.shapes[0];
        QCOMPARE(lake.paths[0], (Subpath{{0, 0}, {{{9, 0}}, {{9, -9}}}, true}));
        QCOMPARE(lake.paths.size(), 2u);
        QCOMPARE(lake.style.fill, std::optional(Colour{0, 0, 255, 128}));
        QCOMPARE(sheet.shapes[1].paths[0], (Subpath{{1, -2}, {}, false}));
        QCOMPARE(sheet.shapes[2].paths.size(), 2u);
        QStringList report; // not in degrees
        for (const Loss& loss : read.value->report)
            report << QStringLiteral("%1 %2").arg(loss.count).arg(loss.what);
        QCOMPARE(report.join("; "), "1 property of a feature; 1 height of a position; "
                                    "1 feature without a geometry");
    }

    void sequencesAreRead()
    {
        const QByteArray a = lineText("[[0,0],[1,1]]"), b = lineText("[[2,2],[3,3]]");
        for (const QByteArray& text :
             {"\x1e" + a + "\n\x1e" + b + "\n", a + "\n" + b, a + "\r\n\r\n" + b + "\r\n"}) {
            const auto read = readMap(text);
            QVERIFY2(read, qPrintable(read.error));
            QCOMPARE(read.value->document.objects().size(), 2u);
        }
    }

    void faultsAreNamed()
    {
        QCOMPARE(readMap("{\n\"type\": x}").error.left(22), "line 2 is not JSON: il");
        QVERIFY(readMap(lineText("[[0,0],[1]]")).error.contains("two numbers"));
        QVERIFY(readMap(lineText("[[0,0],[1,\"2\"]]")).error.contains("two numbers"));
        QVERIFY(readMap(lineText("[[0,0],[1,1e301]]")).error.contains("too large"));
        QVERIFY(readMap(json("{'type':'Topology'}")).error.contains("Topology"));
        QByteArray deep;
        for (int i = 0; i < 300; ++i)
            deep += json("{'type':'GeometryCollection','geometries':[");
        for (int i = 0; i < 300; ++i)
            deep += "]}";
        QVERIFY(readMap(deep).error.contains("deep"));
    }

    void aMapComesBack()
    {
        const QByteArray text = lineText("[[8.5,47.25],[9,48]]",
                                         json("{'layer':'a','stroke':'#ff0000','stroke-width':3}"));
        const Document document = readMap(text).value->document;
        const QByteArray written = mapOf(document, {.paged = false});
        QCOMPARE(sheetOf(readMap(written).value->document).shapes, sheetOf(document).shapes);
        QCOMPARE(compact(geometriesOf(written).at(0)["coordinates"]), "[[8.5,47.25],[9,48]]");
    }

    void areasBecomePolygonsWithTheirHoles()
    {
        const auto geometries =
            geometriesOf(mapOfSvg("<path d='M0 0H9V9H0ZM20 0H29V9H20ZM2 2H7V7H2ZM4 4H5V5H4Z' "
                                  "fill='red' fill-rule='evenodd'/>"));
        QCOMPARE(geometries.size(), 1);
        QCOMPARE(geometries[0]["type"].toString(), "MultiPolygon");
        const QJsonArray polygons = geometries[0]["coordinates"].toArray();
        QCOMPARE(polygons.size(), 3);
        QList<qsizetype> rings;
        for (const QJsonValue& polygon : polygons) {
            rings << polygon.toArray().size();
            for (const QJsonValue& ring : polygon.toArray())
                QCOMPARE(ring.toArray().first(), ring.toArray().last());
        }
        QCOMPARE(rings, (QList<qsizetype>{2, 1, 1}));
        // Counterclockwise, from the lower left corner of the page.
        QCOMPARE(compact(polygons[1][0]), "[[20,100],[20,91],[29,91],[29,100],[20,100]]");
    }

    void decimalsStayInTheWindow()
    {
        const WriteOptions options{.precision = 1, .bounds = clipping::Window{{0, 0}, {1.26, 99}}};
        const auto geometries =
            geometriesOf(mapOfSvg("<path d='M0.04 0.04L1.26 99' stroke='red'/>", options));
        QCOMPARE(compact(geometries[0]["coordinates"]), "[[0,100],[1.2,1]]");
    }
};

} // namespace geojson_test

TEST_CLASS(geojson_test::GeojsonTest, Core)
#include "tests/app/formats/geojson/geojson_test.moc"
