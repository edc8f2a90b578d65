// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/join_lines.h"

#include <QTest>

#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace nodes_join_lines_test {

using namespace app;

namespace {

Shape line(Point a, Point b, std::uint32_t layer = 0, const Style& style = {.stroke = Colour{}})
{
    return {{{a, {{b}}, false}}, style, {}, layer, false};
}

} // namespace

class JoinLinesTest : public QObject {
    Q_OBJECT

private slots:
    void linesOfALayerAndAStyleAreJoined()
    {
        Sheet sheet;
        sheet.layers = {{"a"}, {"b"}};
        const Style red{.stroke = Colour{255, 0, 0}};
        sheet.shapes = {line({0, 0}, {9, 0}),           line({9, 9}, {9, 0}),
                        line({50, 50}, {60, 60}),       line({9, 9}, {0, 0.05}),
                        line({9, 9}, {20, 20}, 0, red), line({0, 0}, {0, 5}, 1)};
        Document document = documentOf(sheet);
        QCOMPARE(joinLines(document, 0), 2u);
        Sheet joined = sheetOf(document);
        QCOMPARE(joined.shapes.size(), 4u);
        QCOMPARE(joined.shapes[0].paths,
                 (std::vector<Subpath>{{{0, 0}, {{{9, 0}}, {{9, 9}}, {{0, 0.05}}}, false}}));
        QCOMPARE(joined.shapes[1], sheet.shapes[2]); // as it was
        QCOMPARE(joined.shapes[3].layer, 1u);
        QCOMPARE(joinLines(document, 0.1), 1u);
        QVERIFY(sheetOf(document).shapes[0].paths[0].closed);
        QCOMPARE(joinLines(document, 0.1), 0u);
    }
    void otherShapesStayAsTheyAre()
    {
        Sheet sheet;
        sheet.shapes = {{{{{0, 0}, {{{1, 0}}}, false}, {{1, 0}, {{{2, 0}}}, false}},
                         {.stroke = Colour{}},
                         {},
                         0,
                         false},
                        {{{{0, 0}, {}, false}}, {.stroke = Colour{}}, {}, 0, false},
                        line({0, 0}, {1, 0})};
        Document document = documentOf(sheet);
        QCOMPARE(joinLines(document, 1), 0u);
        QCOMPARE(sheetOf(document).shapes, sheet.shapes);
    }
};

} // namespace nodes_join_lines_test

TEST_CLASS(nodes_join_lines_test::JoinLinesTest, None)
#include "tests/app/nodes/join_lines_test.moc"
