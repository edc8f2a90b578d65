// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace csv_wkt_test {

using namespace app;

namespace {

Result<Imported> readTable(QByteArray text)
{
    QBuffer buffer(&text);
    buffer.open(QIODevice::ReadOnly);
    return findFormat(u"csv")->read(buffer);
}

} // namespace

class WktTest : public QObject {
    Q_OBJECT

private slots:
    void aLineStringIsOnePath()
    {
        for (const QByteArray text :
             {"id,WKT,layer\n1,\"LINESTRING (1 2, 3.5 -4,5 6)\",roads\n",
              "layer;the_geom\nroads;linestring(1 2,3.5 -4,5 6)\n",
              "id\tGeometry\tlayer\n1\tLINESTRING Z (1 2 9, 3.5 -4 9,5 6 9)\troads\n",
              "\"LINESTRING (1 2, 3.5 -4, 5 6)\",roads\n"}) {
            const auto read = readTable(text);
            QVERIFY2(read, qPrintable(read.error + text));
            const Sheet sheet = sheetOf(read.value->document);
            QCOMPARE(sheet.shapes.size(), 1u);
            QCOMPARE(sheet.shapes[0].paths,
                     (std::vector{Subpath{{1, 2}, {{{3.5, -4}}, {{5, 6}}}, false}}));
            QCOMPARE(sheet.layers[0].name, "roads");
        }
    }

    void rowsKeepTheirNumbers()
    {
        const auto read = readTable("wkt;width\nMULTILINESTRING ((0 0, 1 1), (2 2, 3 3));2\n"
                                    "LINESTRING EMPTY;\nLINESTRING (4 4, 5 5);\n");
        QVERIFY2(read, qPrintable(read.error));
        const Sheet sheet = sheetOf(read.value->document);
        QCOMPARE(sheet.shapes.size(), 2u);
        QCOMPARE(sheet.shapes[0].paths.size(), 2u);
        QCOMPARE(sheet.shapes[0].style.width, 2.0);
        QCOMPARE(read.value->rows, (std::vector<std::uint32_t>{0, 2}));
    }

    void anythingElseIsRefused()
    {
        for (const QByteArray bad :
             {"POINT (1 2)", "LINESTRING", "LINESTRING (1 2, 3)", "LINESTRING (1 2, 3 4",
              "LINESTRING (1 2, 3 4) x", "LINESTRING (1 2, x 4)", "MULTILINESTRING (1 2, 3 4)",
              "LINESTRING (1 2, 3 1e301)", "LINESTRING Q (1 2, 3 4)"}) {
            const auto read = readTable("wkt;id\n" + bad + ";1\n");
            QVERIFY2(!read && read.error.startsWith("line 2 has a geometry that is no"), bad);
        }
    }

    void coordinatesComeFirst()
    {
        const auto read = readTable("geometry;y2;x2;y1;x1\nanything;4;3;2;1\n");
        QVERIFY2(read, qPrintable(read.error));
        QCOMPARE(sheetOf(read.value->document).shapes[0].paths[0],
                 (Subpath{{1, 2}, {{{3, 4}}}, false}));
    }
};

} // namespace csv_wkt_test

TEST_CLASS(csv_wkt_test::WktTest, Core)
#include "tests/app/formats/csv/wkt_test.moc"
