// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/spline.h"
#include "app/lettering/lettering.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/app/formats/dxf/file.h"
#include "tests/test_class.h"

namespace formats_dxf_entities_test {

using namespace app;
using tests::dxf::boundsOf;
using tests::dxf::file;
using tests::dxf::near;
using tests::dxf::report;
using tests::dxf::section;
using tests::dxf::sheet;

namespace {

/// The section BLOCKS with one block.
QByteArray block(const QByteArray& name, const QByteArray& content,
                 const QByteArray& base = "10|0|20|0")
{
    return "0|BLOCK|2|" + name + "|70|0|" + base + '|' + content + "|0|ENDBLK|";
}

QByteArray blocks(const QByteArray& all) { return section("BLOCKS", all.chopped(1)); }

Subpath line(Point a, Point b) { return {a, {{b}}, false}; }

const QByteArray unitLine = "0|LINE|8|0|11|1|21|0";

} // namespace

class DxfEntitiesTest : public QObject {
    Q_OBJECT

private slots:
    // Inserts
    void aBlockIsMovedTurnedAndScaled()
    {
        const Sheet drawing =
            sheet(file("0|INSERT|2|b|10|10|20|20|41|2|42|3|50|90",
                       blocks(block("B", "0|LINE|10|1|20|1|11|2|21|2", "10|1|20|1"))));
        QCOMPARE(drawing.shapes.size(), 1u);
        // (1, 1) becomes (2, 3) by the scale, (-3, 2) by the turn
        QCOMPARE(drawing.shapes[0].paths, std::vector{line({10, -20}, {7, -22})});
    }
    void blocksAreNestedAndArrayed()
    {
        const Sheet drawing = sheet(
            file("0|INSERT|2|OUTER|70|3|71|2|44|10|45|5",
                 blocks(block("INNER", unitLine) + block("OUTER", "0|INSERT|2|INNER|10|0.5"))));
        QCOMPARE(drawing.shapes.size(), 6u);
        QCOMPARE(drawing.shapes.back().paths, std::vector{line({20.5, -5}, {21.5, -5})});
        QCOMPARE(report(file("0|INSERT|2|A", blocks(block("A", unitLine)))),
                 QStringList{"1 inserted block became separate shapes"});
    }
    void aBlockGivesItsLayerAndColour()
    {
        const QByteArray content = "0|LINE|8|0|62|0|11|1|0|LINE|8|Own|62|256|11|2";
        const Sheet drawing = sheet(file("0|INSERT|8|Walls|2|B|62|3", blocks(block("B", content))));
        QCOMPARE(drawing.shapes.size(), 2u);
        QCOMPARE(drawing.layers[drawing.shapes[0].layer].name, QStringLiteral("Walls"));
        QCOMPARE(drawing.shapes[0].style.stroke, std::optional(Colour{0, 255, 0}));
        QCOMPARE(drawing.layers[drawing.shapes[1].layer].name, QStringLiteral("Own"));
        QCOMPARE(drawing.shapes[1].style.stroke, std::optional(Colour{0, 0, 0}));
    }
    void anInsertionOnAFrozenLayerIsHidden()
    {
        const Sheet drawing =
            sheet(file("0|INSERT|8|F|2|B", section("TABLES", "0|LAYER|2|F|70|1")
                                               + blocks(block("B", "0|LINE|8|Own|11|1"))));
        QVERIFY(drawing.shapes.at(0).hidden);
    }
    void blocksThatContainThemselvesOrAreMissingAreTold()
    {
        const QByteArray all =
            blocks(block("A", unitLine + "|0|INSERT|2|B") + block("B", unitLine + "|0|INSERT|2|A"));
        const QByteArray text = file("0|INSERT|2|A|0|INSERT|2|C", all);
        QCOMPARE(sheet(text).shapes.size(), 2u);
        QCOMPARE(report(text), (QStringList{"4 inserted blocks became separate shapes",
                                            "1 block that contains itself",
                                            "1 insertion of a block that is not in the file"}));
    }
    void aDimensionIsDrawnByItsBlock()
    {
        const QByteArray text =
            file("0|DIMENSION|2|*D1|10|5|20|5|0|DIMENSION|10|5", blocks(block("*D1", unitLine)));
        QCOMPARE(sheet(text).shapes.size(), 1u);
        QCOMPARE(report(text), (QStringList{"1 dimension became separate shapes",
                                            "1 dimension without the block that draws it"}));
    }

    // Planes
    void aMirroredPlane()
    {
        const Sheet drawing = sheet(file("0|LWPOLYLINE|210|0|220|0|230|-1|10|1|20|2|10|3|20|2|42|0|"
                                         "0|ARC|210|0|220|0|230|-1|10|5|20|0|40|1|50|0|51|90"));
        QCOMPARE(drawing.shapes.at(0).paths, std::vector{line({-1, -2}, {-3, -2})});
        QVERIFY(near(boundsOf(drawing.shapes.at(1)), {{-6, -1}, {-5, 0}}));
    }
    void aTurnedCircleIsSeenFromAbove()
    {
        const QByteArray text = file("0|CIRCLE|10|0|20|0|30|0|40|2|210|1|220|0|230|1");
        const clipping::Window box = boundsOf(sheet(text).shapes.at(0));
        const double narrow = 2 * std::sqrt(0.5);
        QVERIFY(near(box, {{-narrow, -2}, {narrow, 2}}));
        QCOMPARE(report(file("0|LINE|11|1|31|5")),
                 QStringList{"1 shape above or below the plane was drawn as seen from above"});
    }

    // Curves
    void anEllipseAndAPartOfOne()
    {
        const Sheet drawing =
            sheet(file("0|ELLIPSE|10|1|20|2|11|4|21|0|40|0.5|41|0|42|6.283185307179586|"
                       "0|ELLIPSE|11|3|21|3|40|0.5|41|0|42|3.141592653589793"));
        QVERIFY(near(boundsOf(drawing.shapes.at(0)), {{-3, -4}, {5, 0}}));
        const double reach = std::hypot(3, 1.5); // of a·cos t ∓ b·sin t
        const clipping::Window box = boundsOf(drawing.shapes.at(1));
        QVERIFY(near(box, {{-reach, -reach}, {3, 3}}));
        QVERIFY(!drawing.shapes.at(1).paths[0].closed);
    }
    // A cubic spline without weights is exactly made of Bézier curves.
    void aCubicSplineIsExact()
    {
        const dxf::Spline spline{3,
                                 {0, 0, 0, 0, 1, 3, 3, 3, 3},
                                 {{0, 0, 1}, {1, 3, 1}, {4, 3, 1}, {6, 0, 1}, {7, 2, 1}}};
        const Subpath path = dxf::pathOf(spline, 1e-3);
        QCOMPARE(path.segments.size(), 2u);
        QVERIFY(near(path.start, {0, 0}) && near(path.segments[1].to, {7, 2}));
        // knots inserted by hand: (1, 3) and (4, 3) divided at 1/3, and so on
        QVERIFY(near(path.segments[0].control1, {1, 3}));
        QVERIFY(near(path.segments[0].control2, {2, 3}));
        const Point joint = Point(2, 3) + (Point(4 + 2.0 / 3, 2) - Point(2, 3)) / 3.0;
        QVERIFY(near(path.segments[0].to, joint));
    }
    // Three quarter circles as a rational spline of degree 2.
    void aRationalSplineIsWithinItsTolerance()
    {
        const double w = std::sqrt(0.5);
        const dxf::Spline spline{2,
                                 {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                                 {{100, 0, 1},
                                  {100 * w, 100 * w, w},
                                  {0, 100, 1},
                                  {-100 * w, 100 * w, w},
                                  {-100, 0, 1},
                                  {-100 * w, -100 * w, w},
                                  {0, -100, 1}}};
        const Subpath path = dxf::pathOf(spline, 1e-3);
        Point last = path.start;
        for (const PathSegment& s : path.segments) {
            const Bezier curve{last, s.control1, s.control2, s.to};
            for (int i = 0; i <= 50; ++i)
                QVERIFY(std::abs(glm::length(curve.at(i / 50.0)) - 100) <= 1e-3);
            last = s.to;
        }
        QVERIFY(near(last, {0, -100}));
    }
    void aSplineThroughPoints()
    {
        const Sheet drawing = sheet(file("0|SPLINE|70|0|71|3|74|3|11|0|21|0|11|5|21|5|11|10|21|0"));
        const Subpath& path = drawing.shapes.at(0).paths[0];
        QCOMPARE(path.segments.size(), 2u);
        QVERIFY(near(path.segments[0].to, {5, -5}));
        // smooth: the handles at the middle point are opposite
        const Point before = path.segments[0].to - path.segments[0].control2;
        const Point after = path.segments[1].control1 - path.segments[0].to;
        QVERIFY(near(before, after) && before.x > 0);
    }
    void badSplinesAreToldAndLeftOut()
    {
        const QByteArray points = "10|0|20|0|10|1|20|1|10|2|20|0|10|3|20|0";
        for (const char* bad : {"71|3|40|0|40|1", "71|99|40|0", "71|0|40|0",
                                "71|3|40|9|40|0|40|0|40|0|40|1|40|1|40|1|40|1"})
            QCOMPARE(report(file(QByteArray("0|SPLINE|") + bad + '|' + points)),
                     QStringList{"1 damaged entity of the type “SPLINE”"});
    }

    // Areas
    void solidsAreFilled()
    {
        const Sheet drawing = sheet(file("0|SOLID|62|1|10|0|20|0|11|1|21|0|12|0|22|1|13|1|23|1"));
        const Shape& solid = drawing.shapes.at(0);
        QCOMPARE(solid.style.fill, std::optional(Colour{255, 0, 0}));
        QVERIFY(!solid.style.stroke);
        QCOMPARE(solid.paths,
                 (std::vector<Subpath>{{{0, 0}, {{{1, 0}}, {{1, -1}}, {{0, -1}}}, true}}));
    }
    void hatchesHaveOutlinesWithHoles()
    {
        const QByteArray square =
            "92|2|72|0|73|1|93|4|10|0|20|0|10|9|20|0|10|9|20|9|10|0|20|9|97|0";
        const QByteArray circle = "92|1|93|1|72|2|10|4|20|4|40|2|50|0|51|360|73|1|97|0";
        const QByteArray hatch = "0|HATCH|10|0|20|0|30|0|2|SOLID|70|1|91|2|" + square + '|' + circle
                                 + "|75|0|76|1|98|1|10|5|20|5";
        const Sheet drawing = sheet(file(hatch));
        const Shape& shape = drawing.shapes.at(0);
        QCOMPARE(shape.paths.size(), 2u);
        QVERIFY(shape.style.fill && shape.style.fillRule == FillRule::EvenOdd);
        Shape hole = shape;
        hole.paths = {shape.paths[1]};
        QVERIFY(near(boundsOf(hole), {{2, -6}, {6, -2}}));
        QCOMPARE(report(file(QByteArray(hatch).replace("70|1|91", "70|0|91"))),
                 QStringList{"1 hatch pattern"});
    }
    void edgesOfAHatchMakeOneOutline()
    {
        const Sheet drawing =
            sheet(file("0|HATCH|70|1|91|1|92|1|93|3|72|1|10|0|20|0|11|4|21|0|"
                       "72|2|10|2|20|0|40|2|50|0|51|90|73|1|72|1|10|2|20|2|11|0|21|0|"
                       "97|0|75|0"));
        QCOMPARE(drawing.shapes.at(0).paths.size(), 1u);
        QCOMPARE(drawing.shapes.at(0).paths[0].segments.size(), 3u);
    }

    // Pens
    void lineTypesBecomeDashes()
    {
        const QByteArray types = section("TABLES", "0|LTYPE|2|DASHDOT|49|6|49|-1|49|0|49|-1|"
                                                   "0|LTYPE|2|GAPFIRST|49|-2|49|4|"
                                                   "0|LAYER|2|L|6|DASHDOT");
        const Sheet drawing = sheet(file("0|LINE|8|L|11|9|0|LINE|8|L|6|GAPFIRST|48|0.5|11|9|"
                                         "0|LINE|8|L|6|CONTINUOUS|11|9",
                                         types));
        QCOMPARE(drawing.shapes.at(0).style.dashes, (std::vector<double>{6, 1, 0, 1}));
        QCOMPARE(drawing.shapes.at(1).style.dashes, (std::vector<double>{2, 1}));
        QCOMPARE(drawing.shapes.at(1).style.dashOffset, 2.0); // begins with the gap
        QVERIFY(drawing.shapes.at(2).style.dashes.empty());
    }
    void weightsOfLayersBlocksAndEntities()
    {
        const QByteArray before =
            section("TABLES", "0|LAYER|2|L|370|70") + blocks(block("B", "0|LINE|11|1|370|-2"));
        const Sheet drawing =
            sheet(file("0|LINE|8|L|11|1|0|LINE|8|L|370|13|11|1|0|LINE|8|L|370|-3|11|1|"
                       "0|INSERT|8|L|2|B|370|200",
                       before));
        QList<double> widths;
        for (const Shape& shape : drawing.shapes)
            widths << shape.style.width;
        QCOMPARE(widths, (QList<double>{0.7, 0.13, 0.25, 2}));
    }

    // Texts
    void aTextStaysAText()
    {
        const auto imported =
            tests::dxf::read(file("0|TEXT|10|5|20|6|40|2.5|1|%%c10%%d \\U+00D7|50|90"));
        const Object object = imported.value->document.objects()[0].copy();
        const auto& recipe = std::get<TextRecipe>(object.particulars.recipe);
        QCOMPARE(recipe.text, QStringLiteral("Ø10° ×"));
        QCOMPARE(recipe.size, 2.5);
        QVERIFY(near(recipe.at, {5, -6}));
        QVERIFY(std::abs(recipe.turn + M_PI / 2) < 1e-9); // upwards
        QVERIFY(!recipe.mirrored);
        const auto paths = object.path.subpaths();
        QVERIFY(makes(recipe, paths));
    }
    void textsAreAligned()
    {
        const auto box = [](const QByteArray& more) {
            return boundsOf(sheet(file("0|TEXT|10|0|20|0|40|10|1|H|" + more)).shapes.at(0));
        };
        const clipping::Window plain = box("72|0");
        QVERIFY(near({plain.max.y, plain.min.y}, {0, -10}));
        const clipping::Window right = box("72|2|73|3|11|100|21|50");
        QVERIFY(near({right.max.x, right.min.y}, {100, -50}));
        const clipping::Window fit = box("72|5|11|30|21|0");
        QVERIFY(near({fit.max.x, fit.min.y}, {30, -10}));
        const clipping::Window twice = box("41|2");
        QVERIFY(near({twice.max.x, 0}, {2 * plain.max.x, 0}));
    }
    void formattedTextIsPlain()
    {
        const Sheet drawing = sheet(file("0|MTEXT|10|0|20|0|40|5|71|1|1|{\\fArial;\\H2x;HH}\\PHH"));
        const clipping::Window box = boundsOf(drawing.shapes.at(0));
        QVERIFY(near({box.min.y, box.max.y}, {0, 5 + 5 * 5.0 / 3}));
        const Sheet wrapped = sheet(file("0|MTEXT|10|0|20|0|40|5|41|12|1|HH HH HH"));
        QVERIFY(boundsOf(wrapped.shapes.at(0)).max.y > 20); // three lines
    }
    void aLongTextIsPutTogether()
    {
        const auto imported = tests::dxf::read(file("0|MTEXT|10|0|20|0|40|5|3|two |3|wo|1|rds"));
        const Recipe recipe = imported.value->document.objects()[0].particulars().recipe;
        QCOMPARE(std::get<TextRecipe>(recipe).text, QStringLiteral("two words"));
    }
    void textsOfOtherCodePages()
    {
        const auto layerOf = [](const QByteArray& name, const QByteArray& page) {
            return sheet(section("HEADER", "9|$DWGCODEPAGE|3|" + page)
                         + section("ENTITIES", "0|LINE|11|1|8|" + name) + "0|EOF|")
                .layers.back()
                .name;
        };
        QCOMPARE(layerOf("Ma\xdf", "ANSI_1252"), QStringLiteral("Maß"));
        QCOMPARE(layerOf("Ma\xc3\x9f", "ANSI_1252"), QStringLiteral("Maß"));
        QCOMPARE(layerOf("\x80", "ANSI_1252"), QStringLiteral("€"));
    }
    void aLeaderIsALineWithoutItsArrowhead()
    {
        const QByteArray text = file("0|LEADER|71|1|72|0|76|3|10|0|20|0|10|5|20|5|10|9|20|5");
        QCOMPARE(sheet(text).shapes.at(0).paths[0].segments.size(), 2u);
        QCOMPARE(report(text), QStringList{"1 arrowhead of a leader"});
    }
    void aPointIsAPoint()
    {
        const Sheet drawing = sheet(file("0|POINT|10|3|20|4"));
        QCOMPARE(drawing.shapes.at(0).paths, (std::vector<Subpath>{{{3, -4}, {}, false}}));
        QVERIFY(drawing.shapes.at(0).style.cap == Cap::Round); // so that it is seen
    }
};

} // namespace formats_dxf_entities_test

TEST_CLASS(formats_dxf_entities_test::DxfEntitiesTest, Core)
#include "tests/app/formats/dxf/entities_test.moc"
