// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/bezier.h"

#include <QSet>
#include <QTest>

#include <algorithm>
#include <cmath>

#include "tests/app/formats/dxf/tags_of.h"
#include "tests/test_class.h"

namespace dxf_write_drawing_test {

using namespace app;

namespace {

const WriteOptions r12{.dxf = DxfVersion::R12};

/// A variable of the header.
QByteArray headerOf(const QByteArray& file, const QByteArray& name)
{
    const auto lines = file.split('\n');
    const auto at = lines.indexOf(name);
    return at < 0 ? QByteArray() : lines[at + 2];
}

Document lineOn(const Page& page)
{
    Sheet sheet;
    sheet.page = page;
    sheet.shapes.push_back({{{{10, 20}, {{{30, 5}}}, false}}, {.stroke = Colour{}}, {}, 0, false});
    return documentOf(sheet);
}

} // namespace

class WriteDrawingTest : public QObject {
    Q_OBJECT

private slots:
    void yPointsUpFromTheLowerLeftCornerOfThePaper()
    {
        for (const WriteOptions& options : {WriteOptions{}, r12}) {
            const QByteArray file = dxfOfSvg("<path d='M10.1 20L30 5.3'/>", options);
            const auto entities = entitiesOf(file);
            QCOMPARE(entities.size(), 1);
            QCOMPARE(entities[0].type, "LINE");
            QCOMPARE(entities[0].point(10), (Point{10.1, 80}));
            QCOMPARE(entities[0].point(11), (Point{30, 100 - 5.3}));
            QCOMPARE(headerOf(file, "$INSUNITS"), "4");
        }
    }

    void lengthsAreRealOnesInTheUnitOfThePage()
    {
        struct Case {
            Page page;
            Point from;
            QByteArray unit;
        };
        const Length mm100{100, Unit::Mm};
        for (const auto& [page, from, unit] : std::initializer_list<Case>{
                 {{{0, 0}, {100, 100}, mm100, mm100}, {10, 80}, "4"},
                 {{{0, 0}, {50, 50}, mm100, mm100}, {20, 60}, "4"},
                 {{{0, 0}, {100, 100}, {10, Unit::Inch}, {10, Unit::Inch}}, {1, 8}, "1"},
                 {{{0, 0}, {100, 100}, {10, Unit::Cm}, {10, Unit::Cm}}, {1, 8}, "5"},
                 {{{-5, 0}, {100, 100}, mm100, mm100}, {10, -20}, "4"}, // with a user origin
                 {{{0, 0}, {100, 100}, mm100, mm100, {}, {}, {50, Unit::Metre}}, {0.5, 4}, "6"}}) {
            const QByteArray file = dxfOf(lineOn(page));
            const Point written = entitiesOf(file).front().point(10);
            QVERIFY(std::hypot(written.x - from.x, written.y - from.y) < 1e-12);
            QCOMPARE(headerOf(file, "$INSUNITS"), unit);
        }
        const Length px100{100, Unit::Px};
        const Page pixels{{0, 0}, {100, 100}, px100, px100};
        const QByteArray table = dxfOf(lineOn(pixels), {.paged = false}); // without a unit
        QCOMPARE(entitiesOf(table).front().point(10), (Point{10, -20}));
        QCOMPARE(headerOf(table, "$INSUNITS"), "0");
    }

    void aPartLiesWhereItWouldLieInTheWhole()
    {
        const Page part{{10, 5}, {20, 15}, {20, Unit::Mm}, {15, Unit::Mm}};
        const auto file = dxfOf(lineOn(part), {.wholePage = clipping::Window{{0, 0}, {100, 100}}});
        QCOMPARE(entitiesOf(file).front().point(10), (Point{10, 80}));
    }

    void circlesAndArcsAreSuch()
    {
        for (const WriteOptions& options : {WriteOptions{}, r12}) {
            const auto entities = entitiesOf(dxfOfSvg("<circle cx='40' cy='30' r='12.5'/>"
                                                      "<path d='M10 10A20 20 0 0 1 30 30'/>"
                                                      "<path d='M10 10A20 20 0 0 0 30 30'/>",
                                                      options));
            QCOMPARE(entities.size(), 3);
            QCOMPARE(entities[0].type, "CIRCLE");
            QVERIFY(std::hypot(entities[0].number(10) - 40, entities[0].number(20) - 70) < 1e-12);
            QVERIFY(std::abs(entities[0].number(40) - 12.5) < 1e-12);
            QCOMPARE(entities[1].type, "ARC"); // around (10, 30), drawn the other way round
            QVERIFY(std::hypot(entities[1].number(10) - 10, entities[1].number(20) - 70) < 1e-9);
            QVERIFY(std::abs(std::remainder(entities[1].number(50), 360)) < 1e-9);
            QVERIFY(std::abs(entities[1].number(51) - 90) < 1e-9);
            QCOMPARE(entities[2].type, "ARC"); // around (30, 10)
            QVERIFY(std::abs(entities[2].number(50) - 180) < 1e-9);
            QVERIFY(std::abs(entities[2].number(51) - 270) < 1e-9);
        }
    }

    void ellipsesAreSuchWhereTheVersionHasThem()
    {
        const QByteArray drawing = "<ellipse cx='50' cy='40' rx='10' ry='30'/>";
        const DxfRecord ellipse = entitiesOf(dxfOfSvg(drawing)).front();
        QCOMPARE(ellipse.type, "ELLIPSE");
        QVERIFY(std::abs(ellipse.number(40) - 1 / 3.0) < 1e-9);
        QVERIFY(std::abs(std::abs(ellipse.number(21)) - 30) < 1e-9);
        QVERIFY(std::abs(ellipse.number(42) - ellipse.number(41) - 2 * M_PI) < 1e-12);
        QCOMPARE(entitiesOf(dxfOfSvg(drawing, r12)).front().type, "POLYLINE");
    }

    void aPathOfLinesAndArcsIsOnePolyline()
    {
        const QByteArray drawing = "<rect x='10' y='20' width='30' height='40' rx='5'/>";
        const DxfRecord line = entitiesOf(dxfOfSvg(drawing)).front();
        QCOMPARE(line.type, "LWPOLYLINE");
        QCOMPARE(line.text(90), "8");
        QVERIFY(line.text(70).toInt() & 1);
        QCOMPARE(line.numbers(42).size(), 4);
        for (const double bulge : line.numbers(42)) // clockwise, as y points up
            QVERIFY(std::abs(bulge + std::tan(M_PI / 8)) < 1e-9);
        const auto old = entitiesOf(dxfOfSvg(drawing, r12));
        QCOMPARE(old.size(), 10);
        QCOMPARE(old.front().type, "POLYLINE");
        QCOMPARE(old.back().type, "SEQEND");
        QCOMPARE(old[1].point(10), line.point(10));
    }

    void otherCurvesAreOneSpline()
    {
        const QByteArray drawing = "<path d='M10 10C20 0 40 60 50 10L60 50Z'/>";
        const DxfRecord spline = entitiesOf(dxfOfSvg(drawing)).front();
        QCOMPARE(spline.type, "SPLINE");
        QCOMPARE(spline.numbers(10).size(), 10); // the curve and two lines
        QCOMPARE(spline.numbers(40), (QList<double>{0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 3}));
        QCOMPARE(spline.numbers(10).last(), 10);
        const auto old = entitiesOf(dxfOfSvg(drawing, r12));
        QCOMPARE(old.front().type, "POLYLINE");
        QVERIFY(old.front().text(70).toInt() & 1);
        QVERIFY(old.size() > 10);
    }

    void layersKeepNameColourLockAndSight()
    {
        Sheet sheet;
        sheet.layers = {{"Wände"}, {"a/b:c", false}, {"A_B_C", true, true}, {"0"}};
        const Style red{.stroke = Colour{255, 0, 0}}, own{.stroke = Colour{18, 52, 86}};
        for (const std::uint32_t layer : {0, 1, 2, 3})
            sheet.shapes.push_back(
                {{{{0, 0}, {{{1, 1}}}, false}}, layer == 2 ? own : red, {}, layer, false});
        const QByteArray file = dxfOf(documentOf(sheet));
        const auto layers = entriesOf(file, "LAYER");
        QList<QByteArray> names;
        for (const DxfRecord& layer : layers)
            names << layer.text(2);
        QCOMPARE(names, (QList<QByteArray>{"0", "W\xe4nde", "a_b_c", "A_B_C (2)"}));
        QCOMPARE(layers[1].text(62), "1");
        QVERIFY(!layers[1].has(420));
        QCOMPARE(layers[2].text(62), "-1"); // off
        QCOMPARE(layers[3].text(420), QByteArray::number(0x123456));
        QCOMPARE(layers[1].text(70), "0");
        QCOMPARE(layers[3].text(70), "4"); // locked
        const auto entities = entitiesOf(file);
        QCOMPARE(entities.size(), 4);
        QCOMPARE(entities[0].text(8), "W\xe4nde");
        QCOMPARE(entities[3].text(8), "0");
        QVERIFY(!entities[0].has(62)); // by layer
    }

    void namesAreInTheCodePageOfTheVersion()
    {
        Sheet sheet;
        sheet.layers = {{QStringLiteral("Größe\n😀 ≤ 5")}, {QStringLiteral("Grobe__ _ 5")}};
        const auto names = [&](const WriteOptions& options) {
            QList<QByteArray> all;
            for (const DxfRecord& layer : entriesOf(dxfOf(documentOf(sheet), options), "LAYER"))
                all << layer.text(2);
            return all;
        };
        QCOMPARE(names({}), (QList<QByteArray>{"0",
                                               "Gr\xf6\xdf"
                                               "e___ \\U+2264 5",
                                               "Grobe__ _ 5"}));
        QCOMPARE(names(r12), (QList<QByteArray>{"0", "Gro_e___ _ 5", "Grobe__ _ 5"}));
    }

    void hiddenObjectsStayHidden()
    {
        const QByteArray drawing = "<path d='M1 1L2 2' display='none'/>"
                                   "<g inkscape:groupmode='layer' inkscape:label='a'>"
                                   "<g id='g' display='none'><path d='M1 1L2 2'/></g></g>";
        const auto entities = entitiesOf(dxfOfSvg(drawing));
        QCOMPARE(entities.size(), 2);
        for (const DxfRecord& entity : entities)
            QCOMPARE(entity.text(60), "1");
        QCOMPARE(entitiesOf(dxfOfSvg(drawing, r12)).size(), 0); // it can hide none
    }

    void coloursAreExactAndNearest()
    {
        const auto look = [](const QByteArray& colour, const WriteOptions& options) {
            const auto entities = entitiesOf(dxfOfSvg("<path d='M1 1L2 2' stroke='#010000'/>"
                                                      "<path d='M1 1L2 2' stroke='"
                                                          + colour + "'/>",
                                                      options));
            return entities[1].text(62) + ' ' + entities[1].text(420);
        };
        QCOMPARE(look("black", {}), "7 ");
        QCOMPARE(look("#ff0000", {}), "1 ");
        QCOMPARE(look("white", {}), "255 ");
        QCOMPARE(look("#a55252", {}), "13 ");
        QCOMPARE(look("#fe0102", {}), "1 " + QByteArray::number(0xfe0102));
        QCOMPARE(look("#fe0102", r12), "1 ");
    }

    void widthsAndDashes()
    {
        const QByteArray drawing = "<path d='M1 1L2 2' stroke-width='0.26' stroke-dasharray='3'/>"
                                   "<path d='M1 1L2 2' stroke-width='9'/>";
        const QByteArray file = dxfOfSvg(drawing);
        const auto entities = entitiesOf(file);
        QCOMPARE(entities[0].text(6), "DASHED");
        QVERIFY(!entities[1].has(6));
        QCOMPARE(entities[1].text(370), "211"); // the widest there is
        const auto layer = entriesOf(file, "LAYER").last();
        QCOMPARE(layer.text(370), "25");
        const auto types = entriesOf(file, "LTYPE");
        QCOMPARE(types.last().text(2), "DASHED");
        QCOMPARE(types.last().numbers(49), (QList<double>{3, -3}));
        QCOMPARE(types.last().number(40), 6);
    }

    void handlesAreUniqueAndTheirOwnersExist()
    {
        const QByteArray file =
            dxfOfSvg("<path d='M1 1L2 2M3 3L4 4L5 1'/><circle r='4' stroke-dasharray='1 2'/>"
                     "<g inkscape:groupmode='layer' inkscape:label='a'><path d='M1 1L2 2'/></g>");
        QSet<qulonglong> handles{0};
        qulonglong greatest = 0;
        for (const DxfRecord& record : recordsOf(file)) {
            const QByteArray text = record.text(record.type == "DIMSTYLE" ? 105 : 5);
            if (text.isEmpty() || record.type == "SECTION")
                continue;
            const qulonglong handle = text.toULongLong(nullptr, 16);
            QVERIFY2(!handles.contains(handle), text);
            handles << handle;
            greatest = std::max(greatest, handle);
        }
        QVERIFY(greatest < headerOf(file, "$HANDSEED").toULongLong(nullptr, 16));
        int pointers = 0;
        for (const DxfRecord& record : recordsOf(file))
            for (const auto& [code, value] : record.tags)
                if (code == 330 || code == 340 || code == 350 || code == 390) {
                    ++pointers;
                    QVERIFY2(handles.contains(value.toULongLong(nullptr, 16)), value);
                }
        QVERIFY(pointers > 30);
        QVERIFY(!dxfOfSvg("<path d='M1 1L2 2'/>", r12).contains("330\n"));
    }

    void decimalsAreMovedIntoTheWindow()
    {
        const WriteOptions options{.precision = 1, .bounds = clipping::Window{{0, 0}, {1.26, 99}}};
        const auto entity = entitiesOf(dxfOfSvg("<path d='M0.04 0.04L1.26 99'/>", options)).front();
        QCOMPARE(entity.point(10), (Point{0, 100}));
        QCOMPARE(entity.point(11), (Point{1.2, 1}));
    }

    void whatIsReadIsWrittenAtTheSamePlace()
    {
        for (const WriteOptions& options : {WriteOptions{}, r12}) {
            QByteArray file = dxfOfSvg("<path d='M10.1 20L30 5.3'/><path d='M1 2L3.7 4L5 9Z'/>"
                                       "<rect x='10' y='20' width='30' height='40' rx='5'/>"
                                       "<circle cx='40' cy='30' r='12.5'/>"
                                       "<path d='M10 10C20 0 40 60 50 10'/>"
                                       "<path d='M10 10A20 20 0 0 1 30 30'/>",
                                       options);
            QBuffer buffer(&file);
            buffer.open(QIODevice::ReadOnly);
            const auto read = findFormat(u"dxf")->read(buffer);
            QVERIFY2(read, qPrintable(read.error));
            WriteOptions again = options;
            again.paged = read.value->paged;
            const QByteArray second = dxfOf(read.value->document, again);
            const auto before = entitiesOf(file), after = entitiesOf(second);
            QCOMPARE(after.size(), before.size());
            for (qsizetype i = 0; i < before.size(); ++i) {
                QCOMPARE(after[i].type, before[i].type);
                for (const int code : {10, 20, 11, 21, 40, 42, 50, 51}) {
                    const auto ours = before[i].numbers(code), theirs = after[i].numbers(code);
                    QCOMPARE(theirs.size(), ours.size());
                    for (qsizetype k = 0; k < ours.size(); ++k)
                        QVERIFY2(std::abs(ours[k] - theirs[k]) < 1e-6,
                                 qPrintable(QStringLiteral("%1 %2: %3, %4")
                                                .arg(QString(before[i].type))
                                                .arg(code)
                                                .arg(ours[k])
                                                .arg(theirs[k])));
                }
            }
            QCOMPARE(headerOf(second, "$INSUNITS"), "4");
        }
    }

    void cutArcsEndWhereTheyWereCut()
    {
        // A quarter of a circle without a short piece, as a cut leaves it.
        const auto read = readText("<svg xmlns='http://www.w3.org/2000/svg' width='100mm' "
                                   "height='100mm' viewBox='0 0 100 100'><circle cx='50' cy='50' "
                                   "r='40' fill='none' stroke='black'/></svg>");
        const Subpath circle = read.value->document.objects()[0].path().subpaths().front();
        Point at = circle.start;
        Subpath arc{at, {}, false};
        for (const PathSegment& segment : {circle.segments[0], circle.segments[1]}) {
            const Bezier whole{at, segment.control1, segment.control2, segment.to};
            const Bezier part = arc.segments.empty() ? whole : whole.part(0, 0.03);
            arc.segments.push_back({part.to, part.control1, part.control2, true});
            at = segment.to;
        }
        Sheet sheet;
        sheet.page = read.value->document.page();
        sheet.shapes.push_back({{arc}, {.stroke = Colour{}}, {}, 0, false});
        const DxfRecord entity = entitiesOf(dxfOf(documentOf(sheet))).front();
        QCOMPARE(entity.type, "ARC");
        const auto end = [&](int code) {
            const double angle = entity.number(code) * M_PI / 180;
            return entity.point(10) + entity.number(40) * Point{std::cos(angle), std::sin(angle)};
        };
        const auto isAt = [](const Point& a, const Point& b) {
            return std::hypot(a.x - b.x, 100 - a.y - b.y) < 1e-9;
        };
        const Point last = arc.segments.back().to;
        QVERIFY((isAt(end(50), arc.start) && isAt(end(51), last))
                || (isAt(end(51), arc.start) && isAt(end(50), last)));
        QVERIFY(std::abs(entity.number(40) - 40) < 0.03); // the Bézier curves are as far from it
    }
};

} // namespace dxf_write_drawing_test

TEST_CLASS(dxf_write_drawing_test::WriteDrawingTest, Core)
#include "tests/app/formats/dxf/write_drawing_test.moc"
