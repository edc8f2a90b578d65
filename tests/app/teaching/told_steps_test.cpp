// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences of the algorithms that test regions, corners and cells, computed by hand from the
// published forms.
#include "app/base/numbers.h"
#include "app/teaching/narration.h"

#include <QLocale>
#include <QTest>

#include "tests/test_class.h"

namespace teaching_told_steps_test {

namespace {

constexpr clipping::Window window{{-100, -75}, {100, 75}};
constexpr clipping::Segment line{{-160, -30}, {70, 130}};

/// "7: End 1 lies ...", y up.
QStringList told(const char* key, const clipping::Segment& s = line,
                 const clipping::Window& w = window)
{
    QStringList all;
    for (const auto& narrated :
         app::narrationOf({*app::findVariant(QLatin1StringView(key)), s, w, app::YAxis::Up, {}})
             .steps)
        all << QStringLiteral("%1: %2").arg(narrated.line).arg(narrated.sentence);
    return all;
}

void compare(const QStringList& actual, const QStringList& expected)
{
    for (qsizetype i = 0; i < std::min(actual.size(), expected.size()); ++i)
        QCOMPARE(actual[i], expected[i]);
    QCOMPARE(actual.size(), expected.size());
}

} // namespace

class ToldStepsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    /// Above the window becomes below it by a mirror, and dy its negative: 60 * -160 and -105 *
    /// 230.
    void nichollLeeNicholl()
    {
        compare(told("nln:published"),
                {"2: End 1 lies left of the window (−160 < −100).",
                 "8: End 2 does not lie left of the window (70 > −100).",
                 "9: End 1 does not lie above the window (−30 < 75).",
                 "10: End 1 does not lie below the window (−30 > −75).",
                 "33: End 2 does not lie left of the window (70 > −100).",
                 "34: End 2 does not lie below the window (130 > −75).",
                 "35: End 2 lies above the window (130 > 75): the plane will be mirrored, so that "
                 "one procedure serves both sides.",
                 "35: In the plane of this procedure, End 1 is at (−160, 30) and End 2 at (70, "
                 "−130). The picture is not turned.",
                 "41: From End 1 to End 2, in the plane of this procedure: dx = 230, dy = −160.",
                 "42: Two products compare the line's slope with that of a corner, without a "
                 "division: pxmin = −9600, pymin = −24150.",
                 "43: The line passes the top left corner on the inside (−24150 < −9600): it meets "
                 "the window and enters through the left edge.",
                 "44: End 2 does not lie right of the window (70 < 100).",
                 "48: End 2 moves along the line to the top edge, to (−9.0625, 75). This end is "
                 "now known to be visible.",
                 "49: End 1 moves along the line to the left edge, to (−100, 11.7391). This end is "
                 "now known to be visible.",
                 "35: The plane is turned back, and the ends with it.",
                 "5: No test has ruled the line out.",
                 "6: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
                 "window: it is visible."});
    }
    /// From the corner's region: the products are -75 * 310 and 60 * -260, so that it enters at the
    /// top; then 260 * -260 and -225 * 310, so that it leaves at the right.
    void nichollLeeNichollAsksTheCorners()
    {
        const QStringList all = told("nln:published", {{-160, 150}, {150, -110}});
        QVERIFY(all.contains(
            "16: Slopes are compared as products, without a division (−23250 < −15600): the line "
            "passes the top left corner on the side of the top edge. It can enter only there."));
        QVERIFY(all.contains("19: In the plane of this procedure, End 1 is at (−150, 160) and End "
                             "2 at (110, −150). The picture is not turned."));
        QVERIFY(all.contains("25: The line passes the top right corner on the inside (−67600 < "
                             "−23250): it meets the window and enters through the top edge."));
        QVERIFY(all.contains("28: By the products for the bottom right corner (−67600 > −69750), "
                             "the line leaves through the right edge."));
    }
    /// In the mirrored plane the variables are those of its formulas: End 2 is cut at y2 = ymin.
    /// Turned back they are those of the picture.
    void variablesOfAMirroredPlane()
    {
        const auto variant = app::findVariant(QStringLiteral("nln"));
        QStringList all;
        for (const auto& narrated :
             app::narrationOf({*variant, line, window, app::YAxis::Up, {}}).steps) {
            const auto value = [&](const char* name) {
                const auto& known = narrated.variables;
                const auto found =
                    std::ranges::find(known, QLatin1StringView(name), &app::Variable::name);
                return found == known.end() ? QStringLiteral("-") : app::shortText(found->value);
            };
            QStringList values;
            for (const char* name : {"y1", "x2", "y2", "ymin"})
                values << value(name);
            all << QStringLiteral("%1: %2").arg(narrated.line).arg(values.join(u' '));
        }
        compare(all, {"2: −30 70 130 -", "8: −30 70 130 -", "9: −30 70 130 -", "10: −30 70 130 -",
                      "33: −30 70 130 -", "34: −30 70 130 -", "35: −30 70 130 -",
                      "35: 30 70 −130 −75", "41: 30 70 −130 −75", "42: 30 70 −130 −75",
                      "43: 30 70 −130 −75", "44: 30 70 −130 −75", "48: 30 −9.0625 −75 −75",
                      "49: −11.7391 −9.0625 −75 −75", "35: 11.7391 −9.0625 75 −75",
                      "5: 11.7391 −9.0625 75 −75", "6: 11.7391 −9.0625 75 −75"});
    }

    /// F at the corners: -160 x + 230 y - 18700.
    void skala()
    {
        compare(
            told("skala:published"),
            {"1: The outcode of End 1 is 0001, that of End 2 is 1000. Their bits mean y > ymax, "
             "y < ymin, x > xmax, x < xmin.",
             "2: At least one outcode has a bit set: that end is outside.",
             "4: The outcodes have no bit in common: the line may meet the window.",
             "6: The cross product of both ends is the line as a vector: px = −160, py = 230, pw = "
             "−18700. It tells on which side of the line a point lies.",
             "8: At the bottom left corner, F = −19950.",
             "9: Seen along the line from End 1 to End 2, the bottom left corner lies on the right "
             "(F = −19950, so c[0] = 0).",
             "8: At the bottom right corner, F = −51950.",
             "9: Seen along the line from End 1 to End 2, the bottom right corner lies on the "
             "right (F = −51950, so c[1] = 0).",
             "8: At the top right corner, F = −17450.",
             "9: Seen along the line from End 1 to End 2, the top right corner lies on the right "
             "(F = −17450, so c[2] = 0).",
             "8: At the top left corner, F = 14550.",
             "9: Seen along the line from End 1 to End 2, the top left corner lies on the left "
             "(F = 14550, so c[3] = 1).",
             "10: The four answers make c = 1000, row 8 of the table: the side changes along the "
             "top edge and the left edge. The infinite line crosses exactly these two edges.",
             "11: The corners do not all lie on one side, so the line meets the window.",
             "13: The table names the two edges: edge 2 is the top edge, edge 3 is the left edge.",
             "14: Both ends are outside, so both have to move.",
             "15: The next point to compute is where the line meets the top edge, edge 2 of the "
             "table.",
             "34: The line of the top edge is a vector too: (0, 1, −75).",
             "29: The cross product of both vectors is the point where the line meets the top "
             "edge, times w. Its x is 1450.",
             "30: The y of the cross product is −12000.",
             "31: Its third component is w = −160. Dividing x and y by w gives the point.",
             "16: End 1 is outside, so it becomes the point where the line crosses the top edge: "
             "(−9.0625, 75).",
             "17: The next point to compute is where the line meets the left edge, edge 3 of the "
             "table.",
             "35: The line of the left edge is a vector too: (1, 0, 100).",
             "29: The cross product of both vectors is the point where the line meets the left "
             "edge, times w. Its x is 23000.",
             "30: The y of the cross product is −2700.",
             "31: Its third component is w = −230. Dividing x and y by w gives the point.",
             "18: End 2 moves to the left edge, to (−100, 11.7391). The published table does not "
             "distinguish the edge where the line enters from the edge where it leaves, so the two "
             "ends are now swapped.",
             "27: The remaining part, from (−9.0625, 75) to (−100, 11.7391), lies inside the "
             "window: it is visible."});
    }
    /// dx = 230, dy = 160; f = 230 * -45, 160 * 260, 230 * 105, 160 * 60.
    void skalaCorrected()
    {
        compare(
            told("skala"),
            {"1: The outcode of End 1 is 0001, that of End 2 is 1000. Their bits mean y > ymax, "
             "y < ymin, x > xmax, x < xmin.",
             "2: At least one outcode has a bit set: that end is outside.",
             "4: The outcodes have no bit in common: the line may meet the window.",
             "6: The line is measured from End 1, so it needs no third number, which could lose "
             "digits: dx = 230, dy = 160.",
             "7: Each edge has a product, and the test of a corner compares the products of its "
             "two edges. The product of the bottom edge is −10350, that of the right edge is "
             "41600.",
             "8: Each edge has a product, and the test of a corner compares the products of its "
             "two edges. The product of the top edge is 24150, that of the left edge is 9600.",
             "9: Seen along the line from End 1 to End 2, the bottom left corner lies on the right "
             "(−10350 < 9600, so c[0] = 0).",
             "10: Seen along the line from End 1 to End 2, the bottom right corner lies on the "
             "right (−10350 < 41600, so c[1] = 0).",
             "11: Seen along the line from End 1 to End 2, the top right corner lies on the right "
             "(24150 < 41600, so c[2] = 0).",
             "12: Seen along the line from End 1 to End 2, the top left corner lies on the left "
             "(24150 > 9600, so c[3] = 1).",
             "13: The four answers make c = 1000, row 8 of the table: the side changes along the "
             "top edge and the left edge. The infinite line crosses exactly these two edges.",
             "14: Not all four bits are set: no corner is tested again.",
             "22: The corners do not all lie on one side, so the line meets the window.",
             "24: By the table, the line enters at the left edge and leaves at the top edge.",
             "25: End 2 is outside, with the outcode 1000, and has to move.",
             "27: End 2 is outside, so it becomes the point where the line crosses the top edge: "
             "(−9.0625, 75).",
             "28: End 1 is outside, with the outcode 0001, and has to move.",
             "29: End 1 is outside, so it becomes the point where the line crosses the left edge: "
             "(−100, 11.7391).",
             "31: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
             "window: it is visible."});
    }
    /// Through the corner (0, 2) with the window on the left; and along a window without height.
    void skalaAsksAgain()
    {
        const QStringList touch = told("skala", {{1, 3}, {-1, 1}}, {{0, 0}, {2, 2}});
        QVERIFY(touch.contains(
            "18: The line passes exactly through the top left corner (2 = 2, so c[3] = 0): in the "
            "strict test that corner does not count as left of the line."));
        const QStringList flat = told("skala", {{-1, 0}, {3, 0}}, {{0, 0}, {2, 0}});
        QVERIFY(flat.contains("20: All four corners lie on the line: the window has no area."));
        QVERIFY(flat.contains("21: The line runs along a window without area: its direction "
                              "selects the row of the table, c = 1100."));
    }
    void skalaTellsWhichEndMoves()
    {
        const QStringList second = told("skala:published", {{0, 0}, {200, 100}});
        QVERIFY(second.contains("19: End 1 is inside, so it is End 2 that has to move."));
        QVERIFY2(second.contains("20: The outcode of End 2, 1010, has the bit of the right edge "
                                 "(MASK = 0010): End 2 lies beyond that edge."),
                 qPrintable(second.join('\n')));
        const QStringList first = told("skala:published", {{0, 200}, {10, 0}});
        QVERIFY2(first.contains("24: The outcode of End 1, 1000, does not have the bit of the "
                                "bottom edge (MASK = 0100): End 1 lies beyond the other edge, the "
                                "top edge."),
                 qPrintable(first.join('\n')));
    }
    void skalaSaysWhatItLoses()
    {
        QCOMPARE(told("skala:published", {{-1, 0}, {1, 0}}, {{0, 0}, {2, 2}}).last(),
                 "12: The line misses the window: nothing is visible. That is wrong: from "
                 "(0, 0) to (1, 0) the line is inside.");
    }

    /// m = 160 / 230, c = -18700 / -230.
    void kodituwakkuWijeweeraChamikara()
    {
        compare(
            told("kwc:published"),
            {"2: The line is not vertical (−160 < 70).",
             "3: The line is not horizontal (−30 < 130).",
             "4: The slope of the line is m = 0.695652.",
             "5: The line meets the y axis at c = 81.3043. From now on the line is y = mx + c.",
             "7: End 1 lies left of the window (−160 < −100), so it is pushed to the left edge.",
             "8: End 1 moves along the line to the left edge, to (−100, 11.7391). The part beyond "
             "that edge is removed.",
             "11: End 1 does not lie below the window (11.7391 > −75).",
             "13: End 1 does not lie above the window (11.7391 < 75).",
             "7: End 2 does not lie left of the window (70 > −100).",
             "9: End 2 does not lie right of the window (70 < 100).",
             "11: End 2 does not lie below the window (130 > −75).",
             "13: End 2 lies above the window (130 > 75), so it is pushed to the top edge.",
             "14: End 2 moves along the line to the top edge, to (−9.0625, 75). The part beyond "
             "that edge is removed.",
             "15: Now |x1 − x2| = 90.9375, not less than 1: the line has not shrunk to a point, "
             "so it meets the window.",
             "40: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
             "window: it is visible."});
    }
    void kodituwakkuWijeweeraChamikaraSaysWhatItLoses()
    {
        const QStringList all =
            told("kwc:published", {{100, 0}, {100.5, 300}}, {{0, 0}, {300, 300}});
        compare(all.last(2), {"15: Now |x1 − x2| = 0.5, less than 1. The published form concludes "
                              "that the line has shrunk to a point and misses the window.",
                              "16: The line is rejected: the published form draws nothing. "
                              "That is wrong: from (100, 0) to (100.5, 300) the line is inside."});
    }
    /// It has no m and no c. rise = 160 * 60 / 230, run = 230 * -55 / 160.
    void kodituwakkuWijeweeraChamikaraCorrected()
    {
        compare(
            told("kwc"),
            {"2: The line is not vertical (−160 < 70).",
             "3: The line is not horizontal (−30 < 130).",
             "4: The slope stays a fraction, dy = 160 over dx = 230, so that no quotient is "
             "rounded yet.",
             "5: End 1 is originally at (−160, −30), the other end at (70, 130).",
             "21: End 1 lies left of the window (−160 < −100), so it is pushed to the left "
             "edge.",
             "22: The other end does not lie left of the window, so the left edge does not rule "
             "the line out.",
             "23: From End 1 to the left edge, x changes by 60. Meanwhile y changes by 41.7391.",
             "24: End 1 moves along the line to the left edge, to (−100, 11.7391). The part beyond "
             "that edge is removed.",
             "29: End 1 has moved by 41.7391 in y, and the bottom edge was −45 away (41.7391 > "
             "−45): End 1 has not passed that edge and does not lie below the window.",
             "33: End 1 has moved by 41.7391 in y, and the top edge was 105 away (41.7391 < 105): "
             "End 1 has not passed that edge and does not lie above the window.",
             "6: End 2 is originally at (70, 130), the other end at (−160, −30).",
             "21: End 2 does not lie left of the window (70 > −100).",
             "25: End 2 does not lie right of the window (70 < 100).",
             "29: End 2 does not lie below the window (130 > −75).",
             "33: End 2 lies above the window (130 > 75), so it is pushed to the top edge.",
             "34: The other end does not lie above the window, so the top edge does not rule "
             "the line out.",
             "35: From End 2 to the top edge, y changes by −55. Meanwhile x changes by −79.0625.",
             "36: End 2 moves along the line to the top edge, to (−9.0625, 75). The part beyond "
             "that edge is removed.",
             "7: Rounding has put no end outside the window, so both stay where they are.",
             "18: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
             "window: it is visible."});
        QCOMPARE(told("kwc", {{-160, 0}, {-120, 50}}).last(),
                 "22: Both ends lie left of the window (−160 < −100 and −120 < −100): no point of "
                 "the line can be inside.");
    }

    /// The script of L to T: PL !PT QT.
    void sobkowPospisilYang()
    {
        compare(told("spy:published"),
                {"1: The outcode of End 1 is 0001, that of End 2 is 1000. Their bits mean "
                 "y > ymax, y < ymin, x > xmax, x < xmin.",
                 "2: Both outcodes together are the number 24, the code of this pair of regions. "
                 "The table has a script for each of the 81 pairs. The script of this pair has "
                 "only the cuts and tests that the pair needs.",
                 "3: The table has no × for this pair: the line may meet the window.",
                 "10: End 1 is beyond the left edge, so it moves along the line to that edge, to "
                 "(−100, 11.7391).",
                 "17: End 1 does not lie above the window (11.7391 < 75): here the line does "
                 "not miss the window.",
                 "13: End 2 is beyond the top edge, so it moves along the line to that edge, to "
                 "(−9.0625, 75).",
                 "9: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
                 "window: it is visible."});
    }

    void sobkowPospisilYangSaysWhereItHolds()
    {
        compare(told("spy", {{3, 0.3}, {0.7, 0.9}}, {{0.1, 0.1}, {0.7, 0.9}}).mid(6, 2),
                {"17: Rounding does not put End 1 below the window: y stays.",
                 "18: Rounding would put End 1 above the window: y is held at the edge."});
    }

    /// It passes half a unit in the last place beyond the corner (1, 1).
    void sobkowPospisilYangSaysWhatItInvents()
    {
        const double u = 0x1p-52;
        QVERIFY(
            told("spy:published", {{-1, 1 + 2 * u}, {3, 1 - u}}, {{0, 0}, {1, 1}})
                .last()
                .endsWith(
                    "That is wrong: the line misses the window by less than a rounding error."));
    }

    /// The line turned round: a is End 2. e = 160 * 60 - 230 * 105, and 160 * 200 more in cell 4.
    void slaterBarsky()
    {
        compare(
            told("sb:published", {line.b, line.a}),
            {"3: End 2 lies further left than End 1 (70 > −160). The walk goes to the right, so it "
             "begins at End 2: a = 2 and b = 1.",
             "5: End 2 does not lie right of the window (−160 < 100), and End 1 does not lie left "
             "of it (70 > −100).",
             "7: End 2 lies left of the window (−160 < −100).",
             "10: End 2 does not lie below the window (−30 > −75).",
             "13: End 2 does not lie above the window (−30 < 75).",
             "16: End 2 is in cell 3, the cell left of the window: the walk begins there.",
             "17: At least one end is outside the window: the walk finds the visible part.",
             "18: From End 2 to End 1: dx = 230, dy = 160.",
             "19: The corner ahead is at (−100, 75).",
             "20: The error term e = −14550 tells, without a division, on which side of the corner "
             "ahead the line passes.",
             "22: The walk goes upwards (dy: 160 > 0).",
             "23: By the sign of e (−14550 < 0), the line passes below the corner ahead: the walk "
             "goes right, across the line of the left edge.",
             "24: The walk is not in cell 1, from where it would miss the window.",
             "25: The walk is in cell 3, the cell left of the window: from there it enters the "
             "window.",
             "26: Here the walk enters the window: End 2 moves to the left edge, to (−100, "
             "11.7391).",
             "27: End 1 is not inside: the walk goes on, out of the window again.",
             "31: The walk is in cell 4 now, the middle cell, which is the window. The next corner "
             "ahead gives e = 17450.",
             "22: The walk goes upwards (dy: 160 > 0).",
             "23: By the sign of e (17450 > 0), the line passes left of the corner ahead: the walk "
             "crosses the line of the top edge.",
             "33: The walk is not in cell 3, from where it would miss the window.",
             "34: The walk is not in cell 1, from where it would enter the window.",
             "37: The walk is in cell 4, the middle cell, which is the window: from there it "
             "leaves the window.",
             "38: Here the walk leaves the window: End 1 moves to the top edge, to (−9.0625, 75).",
             "39: The remaining part, from (−9.0625, 75) to (−100, 11.7391), lies inside the "
             "window: it is visible."});
    }
    void slaterBarskyCorrected()
    {
        const QStringList steps = told("sb", {line.b, line.a});
        compare(
            steps.mid(8),
            {"19: The line is neither horizontal nor vertical.",
             "22: The walk goes upwards (dy: 160 > 0).",
             "23: Such a line can enter the window at the bottom edge or the left edge, and leave "
             "it at the top edge or the right edge.",
             "24: The corner ahead is at (−100, 75).",
             "25: The error term e = −14550 tells, without a division, on which side of the corner "
             "ahead the line passes.",
             "27: By the sign of e (−14550 < 0), the line passes below the corner ahead: the walk "
             "goes right, across the line of the left edge.",
             "28: The walk is not in cell 1 or 7, from where it would miss the window.",
             "29: The walk is in cell 3, the cell left of the window: from there it enters the "
             "window.",
             "30: Here the walk enters the window: End 2 moves to the left edge, to (−100, "
             "11.7391).",
             "31: End 1 is not inside: the walk goes on, out of the window again.",
             "35: The walk is in cell 4 now, the middle cell, which is the window. The next corner "
             "ahead gives e = 17450.",
             "27: By the sign of e (17450 > 0), the line passes left of the corner ahead: the walk "
             "crosses the line of the top edge.",
             "37: The walk is not in cell 3, from where it would miss the window.",
             "38: The walk is not in cell 1 or 7, from where it would enter the window.",
             "41: The walk is in cell 4, the middle cell, which is the window: from there it "
             "leaves the window.",
             "42: Here the walk leaves the window: End 1 moves to the top edge, to (−9.0625, 75).",
             "43: The remaining part, from (−9.0625, 75) to (−100, 11.7391), lies inside the "
             "window: it is visible."});
        // Of two steps: e, and the cell.
        QVERIFY(
            told("sb", {{-10, -100}, {20, 90}})
                .contains("45: The walk is in cell 4 now, the middle cell, which is the window."));
        QCOMPARE(told("sb", {{-160, 20}, {-20, 20}}).at(9),
                 "20: Both ends are held inside the window: the remaining part runs from (−100, "
                 "20) to (−20, 20).");
    }
    /// At a corner the line passes both edges at the same time.
    void exactThroughTwoCorners()
    {
        const QStringList all = told("exact", {{-1, -1}, {3, 3}}, {{0, 0}, {2, 2}});
        QVERIFY2(
            all.contains("17: Of the two edges where the line can enter, it passes the left edge "
                         "no earlier than the bottom edge: End 1 is cut at the left edge."),
            qPrintable(all.join('\n')));
        QVERIFY2(all.contains("21: Of the two edges where the line can leave, it passes the right "
                              "edge no later than the top edge: End 2 is cut at the right edge."),
                 qPrintable(all.join('\n')));
    }
    void exactTellsWhichEdgeDoesNotCut()
    {
        const QStringList all = told("exact", {{-1, -2}, {3, 4}}, {{0, 0}, {2, 2}});
        QVERIFY2(all.contains("17: Of the two edges where the line can enter, it passes the bottom "
                              "edge later than the left edge: End 1 is not cut at the left edge."),
                 qPrintable(all.join('\n')));
        QVERIFY2(all.contains("21: Of the two edges where the line can leave, it passes the top "
                              "edge before the right edge: End 2 is not cut at the right edge."),
                 qPrintable(all.join('\n')));
    }
    /// It crosses the left edge's line above the window.
    void anEdgeThatIsNotCrossedDoesNotRuleOut()
    {
        const QStringList all = told("kwc", {{-160, 60}, {-20, 300}});
        QVERIFY2(all.contains("22: The other end does not lie left of the window, so the left edge "
                              "does not rule the line out."),
                 qPrintable(all.join('\n')));
    }
    /// What overflows tells no side, and a rejection that is wrong is called so.
    void overflowDecidesNothing()
    {
        const auto slater =
            told("sb:published", {{-1e200, -1e200}, {2e200, 2e200}}, {{0, 0}, {1, 1}});
        QVERIFY2(slater.filter("on which side").isEmpty(), qPrintable(slater.join('\n')));
        QVERIFY2(slater.filter("By the sign of e").isEmpty(), qPrintable(slater.join('\n')));
        QVERIFY2(slater.contains("23: The products overflow: e is not a number (NaN). The walk "
                                 "nevertheless crosses the line of the bottom edge."),
                 qPrintable(slater.join('\n')));
        const auto skala =
            told("skala:published", {{-1e200, -1e200}, {2e200, 2e200}}, {{0, 0}, {1, 1}});
        QVERIFY(skala.filter("lies on the").isEmpty());
        QCOMPARE(skala.filter("The products overflow").size(), 4);
        const auto matthes =
            told("md:published", {{-1e-300, -1e300}, {2e-300, 1e300}}, {{0, 0}, {1, 1}});
        QVERIFY2(matthes.last().contains("That is wrong"), qPrintable(matthes.last()));
    }

    void slaterBarskySaysWhatItLoses()
    {
        QVERIFY(told("sb:published", {{-1, 0}, {0, 1}}, {{0, 0}, {1, 1}})
                    .last()
                    .endsWith("That is wrong: the line touches the window at (0, 1)."));
        QVERIFY(told("sb:published", {{2, 1}, {2, -1}}, {{0, 0}, {2, 2}}).last().contains("NaN"));
    }
};

} // namespace teaching_told_steps_test

TEST_CLASS(teaching_told_steps_test::ToldStepsTest, None)
#include "tests/app/teaching/told_steps_test.moc"
