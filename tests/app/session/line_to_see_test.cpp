// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/line_to_see.h"
#include "app/session/session.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <numbers>
#include <random>

#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace session_line_to_see_test {

using namespace app;
using clipping::Segment;

namespace {

const TracedWindow square{.frame = {clipping::Window{{0, 0}, {10, 10}}}};

SceneLines linesFrom(const std::vector<Segment>& segments)
{
    Sheet sheet;
    for (const Segment& line : segments) {
        Shape shape;
        shape.paths.push_back({line.a, {{line.b}}});
        sheet.shapes.push_back(shape);
    }
    return linesOf(documentOf(sheet));
}

std::size_t seen(const std::vector<Segment>& segments, const TracedWindow& window = square,
                 const ObjectRanges& locked = {})
{
    return lineToSee(linesFrom(segments), window, locked, [] { return false; });
}

const Segment inside{{1, 1}, {9, 9}}, cut{{8, 5}, {12, 5}}, longerCut{{-2, 5}, {4, 6}},
    outside{{20, 20}, {90, 20}};

} // namespace

class LineToSeeTest : public QObject {
    Q_OBJECT

private slots:
    void theLongestThatIsCut()
    {
        QCOMPARE(seen({outside, inside, cut, longerCut}), std::size_t(3));
        QCOMPARE(seen({longerCut, inside, cut}), std::size_t(0));
        QCOMPARE(seen({outside, cut, inside}), std::size_t(1));
    }
    void theFirstOfEquals()
    {
        QCOMPARE(seen({inside, cut, {{5, 8}, {5, 12}}, cut}), std::size_t(1));
        QCOMPARE(seen({{{-1e200, 5}, {1e200, 5}}, {{-1e300, 5}, {1e300, 5}}}), std::size_t(0));
    }
    void withoutACutLine()
    {
        QCOMPARE(seen({outside, {{1, 1}, {2, 2}}, inside}), std::size_t(2));
        QCOMPARE(seen({outside, {{20, 30}, {99, 30}}}), std::size_t(0));
        QCOMPARE(seen({outside, {{5, 5}, {5, 5}}}), std::size_t(1)); // a point inside
    }
    void lockedLinesComeLast()
    {
        QCOMPARE(seen({longerCut, cut, inside}, square, {0}), std::size_t(1));
        QCOMPARE(seen({longerCut, outside}, square, {0}), std::size_t(1));
        QCOMPARE(seen({cut, longerCut}, square, {0, 1}), std::size_t(1));
    }
    void rotatedWindowsAndPolygons()
    {
        const TracedWindow diamond{.frame =
                                       RectangleShape{{{0, 0}, {10, 10}}, std::numbers::pi / 4}};
        // Its corners reach out to −2 and 12; those of the square are outside.
        QCOMPARE(seen({{{-1, 5}, {4, 5}}, {{0.5, 0.5}, {5, 5}}}, diamond), std::size_t(1));
        const TracedWindow triangle{.frame = {clipping::Window{{0, 0}, {10, 10}}},
                                    .corners = {{0, 0}, {10, 0}, {0, 10}}};
        QCOMPARE(seen({{{9, 9}, {6, 6}}, {{4, 4}, {6, 6}}}, triangle), std::size_t(1));
    }
    void anyLineAsBySearchingAll()
    {
        std::mt19937_64 random(4);
        std::uniform_real_distribution<double> anywhere(-15, 25);
        const auto point = [&] { return Point(anywhere(random), anywhere(random)); };
        const auto isCut = [](const Segment& line) {
            const auto visible = clipping::exactAlgorithm().corrected.clip(line, square.frame.box);
            return visible && *visible != line;
        };
        for (int i = 0; i < 50; ++i) {
            std::vector<Segment> lines;
            for (int n = 0; n < 200; ++n)
                lines.push_back({point(), point()});
            const auto longest = std::ranges::max_element(lines, {}, [&](const Segment& line) {
                return isCut(line) ? glm::distance(line.a, line.b) : -1;
            });
            QVERIFY(isCut(*longest));
            QCOMPARE(seen(lines), std::size_t(longest - lines.begin()));
        }
    }
    void enoughIsEnough()
    {
        std::vector<Segment> lines(10'000, cut);
        lines[3] = lines[9'000] = longerCut;
        lines[9'001] = {{-90, 5}, {90, 5}};
        const SceneLines all = linesFrom(lines);
        QCOMPARE(lineToSee(all, square, {}, [] { return false; }), std::size_t(9'001));
        QCOMPARE(lineToSee(all, square, {}, [] { return true; }), std::size_t(3));
    }
};

} // namespace session_line_to_see_test

TEST_CLASS(session_line_to_see_test::LineToSeeTest, Core)
#include "tests/app/session/line_to_see_test.moc"
