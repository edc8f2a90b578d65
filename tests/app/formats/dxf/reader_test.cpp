// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/aci.h"
#include "app/formats/loss_text.h"

#include <QTemporaryDir>
#include <QTest>

#include "tests/app/formats/dxf/file.h"
#include "tests/app/formats/lossy.h"
#include "tests/test_class.h"

namespace formats_dxf_reader_test {

using namespace app;
using tests::dxf::file;
using tests::dxf::near;
using tests::dxf::report;
using tests::dxf::section;
using tests::dxf::sheet;

namespace {

Subpath line(Point a, Point b) { return {a, {{b}}, false}; }

const QByteArray oneLine = "0|LINE|8|0|10|1|20|2|11|3|21|5";

QByteArray layers(const QByteArray& entries)
{
    return section("TABLES", "0|TABLE|2|LAYER|" + entries + "|0|ENDTAB");
}

// The same file in binary form, with codes of one byte (R12) or two.
QByteArray binary(const QByteArray& text, bool isShort)
{
    QByteArray bytes("AutoCAD Binary DXF\r\n\x1a\0", 22);
    const auto append = [&](auto number) {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    };
    const QByteArrayList lines = text.chopped(1).split('|');
    for (qsizetype i = 0; i + 1 < lines.size(); i += 2) {
        const int code = lines[i].toInt();
        if (isShort && code < 255) {
            append(std::uint8_t(code));
        } else {
            if (isShort)
                append(std::uint8_t(255));
            append(std::int16_t(code));
        }
        if (code >= 10 && code < 60)
            append(lines[i + 1].toDouble());
        else if (code >= 60 && code < 80)
            append(std::int16_t(lines[i + 1].toInt()));
        else if (code >= 420 && code < 430)
            append(std::int32_t(lines[i + 1].toInt()));
        else
            bytes.append(lines[i + 1]).append('\0');
    }
    return bytes;
}

} // namespace

class DxfReaderTest : public QObject {
    Q_OBJECT

private slots:
    void linesHaveTheirCoordinatesAndTheirPageIsAroundThem()
    {
        const Sheet drawing = sheet(file(oneLine));
        QCOMPARE(drawing.shapes.size(), 1u);
        QCOMPARE(drawing.shapes[0].paths, std::vector{line({1, -2}, {3, -5})}); // y down
        const Point margin(drawing.shapes[0].style.width / 2);
        QVERIFY(near(drawing.page.rectangle(), {Point(1, -5) - margin, Point(3, -2) + margin}));
        QVERIFY(near({drawing.page.millimetresPerUnit(), 0}, {1, 0}));
    }

    // Large coordinates keep all their digits.
    void coordinatesAreNotMoved()
    {
        const Sheet drawing =
            sheet(file("0|LINE|10|4500123.0625|20|5812345.123456789|11|4500124|21|5812346"));
        QCOMPARE(drawing.shapes[0].paths,
                 std::vector{line({4500123.0625, -5812345.123456789}, {4500124, -5812346})});
    }

    void unitsGiveTheSizeOfThePage_data()
    {
        QTest::addColumn<int>("code");
        QTest::addColumn<double>("millimetres");
        QTest::newRow("inch") << 1 << 25.4;
        QTest::newRow("foot") << 2 << 304.8;
        QTest::newRow("mm") << 4 << 1.0;
        QTest::newRow("cm") << 5 << 10.0;
        QTest::newRow("m") << 6 << 1000.0;
        QTest::newRow("micrometre") << 13 << 0.001;
        QTest::newRow("survey foot") << 21 << 1200000.0 / 3937;
    }
    void unitsGiveTheSizeOfThePage()
    {
        QFETCH(int, code);
        QFETCH(double, millimetres);
        const Sheet drawing = sheet(section("HEADER", "9|$INSUNITS|70|" + QByteArray::number(code))
                                    + section("ENTITIES", "0|LINE|11|80|21|60|370|50") + "0|EOF|");
        const double unit = drawing.page.millimetresPerUnit();
        QVERIFY(std::abs(unit / millimetres - 1) < 1e-12);
        QVERIFY(std::abs(drawing.shapes[0].style.width * unit - 0.5) < 1e-9); // on paper
    }
    void aFileWithoutAUnitOrAHeaderIsInMillimetres()
    {
        const QByteArray text = section("ENTITIES", oneLine) + "0|EOF|";
        QVERIFY(near({sheet(text).page.millimetresPerUnit(), 0}, {1, 0}));
        QCOMPARE(report(text), QStringList{"1 file without a unit was read in millimetres"});
        QCOMPARE(report(file(oneLine)), QStringList());
    }

    void layersAreKeptWithTheirState()
    {
        const Sheet drawing =
            sheet(file(oneLine + "|0|LINE|8|walls|11|1|21|1|0|LINE|8|New|11|1",
                       layers("0|LAYER|2|0|70|0|62|7|0|LAYER|2|Walls|70|4|62|1|0|LAYER|2|Off|62|-3|"
                              "0|LAYER|2|Frozen|70|1|62|3")));
        QStringList names;
        for (const Layer& layer : drawing.layers)
            names << layer.name + (layer.visible ? "" : " hidden")
                         + (layer.locked ? " locked" : "");
        QCOMPARE(names, (QStringList{"0", "Walls locked", "Off hidden", "Frozen hidden", "New"}));
        QCOMPARE(drawing.shapes.size(), 3u);
        QCOMPARE(drawing.shapes[1].layer, 1u); // names of layers do not depend on capitals
        QCOMPARE(drawing.shapes[1].style.stroke, std::optional(Colour{255, 0, 0}));
    }
    void colours_data()
    {
        QTest::addColumn<QByteArray>("groups");
        QTest::addColumn<QList<int>>("rgb");
        QTest::newRow("by layer") << QByteArray("62|256") << QList{1, 2, 3};
        QTest::newRow("usual") << QByteArray("39|0") << QList{1, 2, 3};
        QTest::newRow("index") << QByteArray("62|5") << QList{0, 0, 255};
        QTest::newRow("black or white") << QByteArray("62|7") << QList{0, 0, 0};
        QTest::newRow("true colour") << QByteArray("62|5|420|16744448") << QList{255, 128, 0};
    }
    void colours()
    {
        QFETCH(QByteArray, groups);
        QFETCH(QList<int>, rgb);
        const Sheet drawing =
            sheet(file("0|LINE|8|A|11|1|" + groups, layers("0|LAYER|2|A|62|9|420|66051")));
        const Colour colour = drawing.shapes.at(0).style.stroke.value();
        QCOMPARE((QList<int>{colour.red, colour.green, colour.blue}), rgb);
    }
    void theIndexHasTheColoursOfOtherPrograms()
    {
        const auto& all = dxf::aciColours;
        QCOMPARE(all[1], 0xff0000u);
        QCOMPARE(all[11], 0xff7f7fu);
        QCOMPARE(all[21], 0xff9f7fu);
        QCOMPARE(all[27], 0x4c2f26u);
        QCOMPARE(all[34], 0x7f3f00u);
        QCOMPARE(all[90], 0x00ff00u);
        QCOMPARE(all[132], 0x00a5a5u);
        QCOMPARE(all[163], 0x5267a5u);
        QCOMPARE(all[200], 0xbf00ffu);
        QCOMPARE(all[243], 0xa55267u);
        QCOMPARE(all[255], 0xffffffu);
    }

    void circlesAndArcs()
    {
        const Sheet drawing = sheet(file("0|CIRCLE|10|10|20|20|40|5|"
                                         "0|ARC|10|0|20|0|40|2|50|350|51|95|"
                                         "0|ARC|10|0|20|0|40|1|50|0|51|360"));
        QCOMPARE(drawing.shapes.size(), 3u);
        QVERIFY(drawing.shapes[0].paths[0].closed);
        QVERIFY(near(tests::dxf::boundsOf(drawing.shapes[0]), {{5, -25}, {15, -15}}));
        const double small = 2 * std::sin(10 * M_PI / 180), left = 2 * std::cos(95 * M_PI / 180);
        QVERIFY(near(tests::dxf::boundsOf(drawing.shapes[1]), {{left, -2}, {2, small}}));
        QVERIFY(!drawing.shapes[1].paths[0].closed);
        QVERIFY(drawing.shapes[2].paths[0].closed);
    }
    void aCircleCanBeEditedAsOne()
    {
        const auto imported = tests::dxf::read(file("0|CIRCLE|10|10|20|20|40|5"));
        const Object object = imported.value->document.objects()[0].copy();
        QCOMPARE(object.particulars.recipe, Recipe(EllipseRecipe{{10, -20}, {5, 5}}));
    }

    void polylinesHaveBulges()
    {
        const QByteArray corners = "10|0|20|0|42|1|10|10|20|0|10|10|20|5|10|0|20|5";
        const Sheet drawing = sheet(file("0|LWPOLYLINE|90|4|70|1|" + corners));
        const Subpath& path = drawing.shapes.at(0).paths[0];
        QVERIFY(path.closed);
        // counterclockwise from (0, 0) to (10, 0): below the line
        QVERIFY(near(tests::dxf::boundsOf(drawing.shapes[0]), {{0, -5}, {10, 5}}));
        QCOMPARE(path.segments.size(), 4u); // two quarter turns and two lines; the third closes it
    }
    void oldPolylinesAreReadWithTheirVertices()
    {
        const Sheet drawing =
            sheet(file("0|POLYLINE|66|1|70|0|0|VERTEX|10|0|20|0|42|-1|0|VERTEX|10|4|"
                       "20|0|0|VERTEX|10|8|20|0|0|SEQEND|"
                       + oneLine));
        QCOMPARE(drawing.shapes.size(), 2u);
        QVERIFY(near(tests::dxf::boundsOf(drawing.shapes[0]), {{0, -2}, {8, 0}}));
    }
    void aPolylineHasAWidth()
    {
        const Sheet drawing = sheet(file("0|LWPOLYLINE|90|2|43|3|10|0|20|0|10|9|20|0|"
                                         "0|LWPOLYLINE|90|2|10|0|20|0|40|1|41|2|10|9|20|0"));
        QCOMPARE(drawing.shapes.at(0).style.width, 3.0);
        QCOMPARE(drawing.shapes.at(1).style.width, 0.25);
    }

    void whatIsNotReadIsCounted()
    {
        QCOMPARE(
            report(file("0|RAY|10|0|0|RAY|10|0|0|ACAD_TABLE|10|0|" + oneLine)),
            (QStringList{"2 entities of the type “RAY”", "1 entity of the type “ACAD_TABLE”"}));
    }
    void paperSpaceIsLeftOutAndTold()
    {
        const QByteArray text = file(oneLine + "|0|LINE|67|1|11|7|0|VIEWPORT|67|1|10|3");
        QCOMPARE(sheet(text).shapes.size(), 1u);
        QCOMPARE(report(text), QStringList{"2 entities in paper space were left out"});
    }

    void aTruncatedFileIsReadToTheDamage()
    {
        const QByteArray text = file(oneLine + "|0|LINE|10|0|20|0|11|9|21|9");
        const QByteArray cut = text.left(text.lastIndexOf("21|9"));
        QCOMPARE(sheet(cut).shapes.size(), 1u); // nothing of half an entity
        QCOMPARE(report(cut), QStringList{"1 end of a file that is cut off here"});
        const QByteArray damaged = file(oneLine + "|0|LINE|x|7|0|LINE|11|4");
        QCOMPARE(sheet(damaged).shapes.size(), 1u);
        QCOMPARE(report(damaged), QStringList{"1 rest of the file, which is damaged here"});
        QVERIFY(isLossy(*tests::dxf::read(damaged).value));
    }
    void anEntityWithBadNumbersIsLeftOut()
    {
        const QByteArray text = file("0|LINE|10|nan|0|CIRCLE|40|1e999|0|LINE|11|inf|" + oneLine);
        QCOMPARE(sheet(text).shapes.size(), 1u);
        QCOMPARE(report(text), (QStringList{"2 damaged entities of the type “LINE”",
                                            "1 damaged entity of the type “CIRCLE”"}));
    }

    void binaryFilesAreReadLikeTexts()
    {
        const QByteArray text = file(oneLine
                                     + "|0|LINE|8|Walls|62|1|420|66051|10|0.1|20|1e-9|"
                                       "11|12345.678|21|-3|1001|APP|0|CIRCLE|40|2");
        const Sheet drawing = sheet(text);
        QCOMPARE(drawing.shapes.size(), 3u);
        for (const bool isShort : {true, false}) {
            const QByteArray bytes = binary(text, isShort);
            QCOMPARE(sheet(bytes), drawing);
            for (qsizetype size = 23; size < bytes.size(); ++size) // ends early anywhere
                tests::dxf::read(bytes.left(size));
            QCOMPARE(report(bytes.chopped(8)), QStringList{"1 end of a file that is cut off here"});
        }
    }
    void otherFilesAreRefusedWithOneSentence_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("error");
        QTest::newRow("empty") << QByteArray() << "it is empty.";
        QTest::newRow("old") << section("HEADER", "9|$ACADVER|1|AC1004")
                             << "DXF version R9 is not read. Save the drawing as DXF R12 to 2018 "
                                "in the program that made it.";
        QTest::newRow("DWG") << QByteArray("AC1032\0\0\0", 9)
                             << "it is a DWG file, which Clearcut does not read. Convert it to DXF "
                                "first, for example with dwg2dxf of LibreDWG or with the ODA File "
                                "Converter.";
        QTest::newRow("SVG") << QByteArray("<svg/>")
                             << "it is no DXF file: its first lines are not 0 and SECTION.";
    }
    void otherFilesAreRefusedWithOneSentence()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, error);
        const auto result = tests::dxf::read(text);
        QVERIFY(!result);
        QCOMPARE(result.error, error);
    }
    void aDwgFileIsNotOpenedByItsName()
    {
        const QTemporaryDir folder;
        QFile dwg(folder.filePath("plan.DWG"));
        QVERIFY(dwg.open(QIODevice::WriteOnly) && dwg.write("AC1027 and more") > 0);
        dwg.close();
        const QString error = readFile(dwg.fileName()).error;
        QVERIFY2(error.contains("plan.DWG: it is a DWG file"), qPrintable(error));
    }
};

} // namespace formats_dxf_reader_test

TEST_CLASS(formats_dxf_reader_test::DxfReaderTest, None)
#include "tests/app/formats/dxf/reader_test.moc"
