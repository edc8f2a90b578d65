// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/left_out.h"

#include <QTest>

#include <limits>

#include "tests/test_class.h"

namespace tiles_tiling_test {

using namespace app;

namespace {

/// 540 × 540 mm; a unit is half a millimetre.
const Page large{{-100, 20}, {1080, 1080}, {540, Unit::Mm}, {540, Unit::Mm}, {}};

Tiling tiled(const TilePlan& plan)
{
    auto tiling = tilingOf(large, plan);
    return tiling ? *tiling.value : Tiling{};
}

} // namespace

class TilingTest : public QObject {
    Q_OBJECT

private slots:
    void byPaper()
    {
        const Tiling tiling = tiled({.sheet = {210, 297}, .margin = 10, .overlap = 10});
        QCOMPARE(tiling.columns, 3); // 190 + 180 + 180 = 550 >= 540
        QCOMPARE(tiling.rows, 2);    // 277 + 267 = 544
        QCOMPARE(tiling.tiles.size(), 6u);
        QCOMPARE(tiling.tiles.front().window.min, large.min);
        QCOMPARE(tiling.tiles.front().window.max, large.min + Point(380, 554));
        QCOMPARE(tiling.tiles[4].row, 2);
        QCOMPARE(tiling.tiles[4].column, 2);
        QCOMPARE(tiling.tiles[4].window.min, large.min + Point(360, 534));
    }

    void byNumber()
    {
        const Tiling tiling = tiled({.columns = 3, .rows = 1, .margin = 5, .overlap = 3});
        QCOMPARE(tiling.sheet, Point(192, 550)); // (540 + 2 * 3) / 3 = 182, and two margins
        QCOMPARE(tiling.tiles.size(), 3u);
        QCOMPARE(tiling.tiles[1].window.min.x, large.min.x + 2 * 179);
        QCOMPARE(tiling.tiles[2].window.max, large.min + large.size);
    }

    void aSheetThatFitsExactlyIsOne()
    {
        const Tiling tiling = tiled({.sheet = {560, 560}, .margin = 10, .overlap = 7});
        QCOMPARE(tiling.tiles.size(), 1u);
        // 3 * 180 = 540: no fourth sheet for a rounding error.
        QCOMPARE(tiled({.sheet = {180, 540}, .margin = 0}).columns, 3);
    }

    // Half as large on paper: a sheet holds twice as much.
    void theScaleIsThatOnPaper()
    {
        const Tiling half = tiled({.sheet = {210, 297}, .margin = 10, .overlap = 10, .scale = 0.5});
        QCOMPARE(half.columns, 2); // 190 + 180 >= 270
        QCOMPARE(half.rows, 1);
        QCOMPARE(half.tiles.front().window.max, large.min + Point(760, 1108));
        QCOMPARE(half.drawing, Point(270, 270));
        QCOMPARE(tilingOf(large, {.scale = 0}).error,
                 "The scale must be between 0.1 % and 100,000 %.");
    }

    // The first sheet begins left of the page; a whole step is no shift.
    void cutsAreShifted()
    {
        const TilePlan plan{.sheet = {210, 297}, .margin = 10, .overlap = 10, .shift = {50, 0}};
        const Tiling shifted = tiled(plan);
        QCOMPARE(shifted.tiles[0].window.min, large.min - Point(100, 0));
        QCOMPARE(shifted.tiles[1].window.min.x, large.min.x + 260);
        TilePlan whole = plan;
        whole.shift = {180, -267};
        QCOMPARE(tiled(whole).tiles[0].window.min, large.min);
    }

    void sheetsAreLeftOut()
    {
        const Tiling some =
            tiled({.sheet = {210, 297}, .margin = 10, .overlap = 10, .leftOut = {2, 6, 9}});
        QCOMPARE(some.tiles.size(), 6u);
        QCOMPARE(some.written(), 4);
        QVERIFY(some.tiles[1].leftOut && some.tiles[5].leftOut && !some.tiles[0].leftOut);
    }

    // The whole page lies in the tiles, and neighbours have the overlap in common.
    void thePageIsCovered()
    {
        for (const double overlap : {0.0, 1.0, 12.5})
            for (const Point sheet : {Point(100, 70), Point(210, 297), Point(333, 31)}) {
                const Tiling tiling = tiled({.sheet = sheet, .margin = 2, .overlap = overlap});
                QCOMPARE(std::size_t(tiling.columns * tiling.rows), tiling.tiles.size());
                const auto& last = tiling.tiles.back().window.max;
                QVERIFY(last.x >= 980 - 1e-9 && last.y >= 1100 - 1e-9);
                if (tiling.columns > 1)
                    QVERIFY(std::abs(tiling.tiles[0].window.max.x - tiling.tiles[1].window.min.x
                                     - 2 * overlap)
                            < 1e-9);
            }
    }

    // 190 × 277 mm, 10 of them in common: a step is 180 × 267 mm, 360 × 534 units.
    void sheetsAreAddedForWhatLiesBeyondThePage_data()
    {
        QTest::addColumn<Point>("min"); // in units, from the page's corners
        QTest::addColumn<Point>("max");
        QTest::addColumn<SheetsBeyond>("beyond");
        QTest::newRow("within") << Point(1, 1) << Point(-1, -1) << SheetsBeyond{};
        QTest::newRow("the page") << Point(0) << Point(0) << SheetsBeyond{};
        QTest::newRow("left") << Point(-1, 5) << Point(-800, -5) << SheetsBeyond{.left = 1};
        QTest::newRow("a whole sheet") << Point(-360, 0) << Point(0) << SheetsBeyond{.left = 1};
        QTest::newRow("more than one") << Point(-361, 0) << Point(0) << SheetsBeyond{.left = 2};
        QTest::newRow("above") << Point(0, -535) << Point(0) << SheetsBeyond{.top = 2};
        // The sheets of the page reach 1100 × 1088 units.
        QTest::newRow("on the last sheets") << Point(0) << Point(20, 8) << SheetsBeyond{};
        QTest::newRow("right") << Point(0) << Point(21, 8) << SheetsBeyond{.right = 1};
        QTest::newRow("below") << Point(0) << Point(0, 9) << SheetsBeyond{.bottom = 1};
        QTest::newRow("all around") << Point(-1, -600) << Point(800, 9) << SheetsBeyond{1, 2, 3, 1};
        QTest::newRow("rounded") << Point(-0.19, -0.19) << Point(20.19, 8.19) << SheetsBeyond{};
        QTest::newRow("far away") << Point(-5000, 0) << Point(-5000, -1000)
                                  << SheetsBeyond{.left = 14};
        const double no = std::nan("");
        QTest::newRow("not a number") << Point(no) << Point(no) << SheetsBeyond{};
    }
    void sheetsAreAddedForWhatLiesBeyondThePage()
    {
        QFETCH(Point, min);
        QFETCH(Point, max);
        QFETCH(SheetsBeyond, beyond);
        const TilePlan plan{.sheet = {210, 297}, .margin = 10, .overlap = 10};
        const clipping::Window drawn{large.min + min, large.min + large.size + max};
        const Tiling page = tiled(plan), tiling = *tilingOf(large, plan, drawn).value;
        QVERIFY(tiling.beyond == beyond);
        QCOMPARE(tiling.pageColumns(), page.columns);
        QCOMPARE(tiling.pageRows(), page.rows);
        QCOMPARE(std::size_t(tiling.columns * tiling.rows), tiling.tiles.size());
        for (const Tile& tile : page.tiles) { // the page's own sheets are where they were
            const auto at = (tile.row - 1 + beyond.top) * tiling.columns + tile.column - 1;
            const Tile& same = tiling.tiles[std::size_t(at + beyond.left)];
            QCOMPARE(same.window.min, tile.window.min);
            QCOMPARE(same.window.max, tile.window.max);
        }
        for (std::size_t i = 0; i < tiling.tiles.size(); ++i)
            QCOMPARE(tiling.numberOf(tiling.tiles[i]), int(i) + 1);
    }

    void byNumberSheetsBeyondThePageAreAsLarge()
    {
        const TilePlan plan{.columns = 3, .rows = 1, .margin = 5, .overlap = 3};
        const clipping::Window drawn{large.min - Point(1, 0), large.min + large.size};
        const Tiling tiling = *tilingOf(large, plan, drawn).value;
        QCOMPARE(tiling.columns, 4);
        QCOMPARE(tiling.sheet, Point(192, 550));
        QCOMPARE(tiling.tiles[1].window.min, large.min);
        QCOMPARE(tiling.drawing, Point(540.5, 540));
    }

    // A shifted first sheet covers some of what is left of the page.
    void aShiftSavesASheet()
    {
        const clipping::Window drawn{large.min - Point(100, 0), large.min + large.size};
        TilePlan plan{.sheet = {210, 297}, .margin = 10, .overlap = 10, .shift = {50, 0}};
        QVERIFY(!tilingOf(large, plan, drawn).value->beyond.any());
        plan.shift.x = 49;
        QCOMPARE(tilingOf(large, plan, drawn).value->beyond.left, 1);
    }

    void whatIsTooFarAwayIsRefused()
    {
        const QString sentence = "What lies beyond the page needs more than 1000 sheets. Hide it, "
                                 "lay a clip window on the page, or choose larger sheets.";
        const TilePlan plan{.sheet = {210, 297}, .margin = 10, .overlap = 10};
        for (const double far : {2e5, 1e18, 1e308, std::numeric_limits<double>::infinity()}) {
            const clipping::Window right{large.min, large.min + Point(far)},
                left{large.min - Point(far, 0), large.min};
            QCOMPARE(tilingOf(large, plan, right).error, sentence);
            QCOMPARE(tilingOf(large, plan, left).error, sentence);
        }
    }

    // The same sheet stays left out while its number becomes another one.
    void sheetsStayLeftOutWhenOthersAreAdded()
    {
        const TilePlan plan{.sheet = {210, 297}, .margin = 10, .overlap = 10, .leftOut = {2, 6}};
        const auto [min, max] = large.rectangle();
        const auto numbers = [&](const TilePlan& of, const clipping::Window& drawn) {
            const Tiling tiling = *tilingOf(large, of, drawn).value;
            std::vector<int> left;
            for (const Tile& tile : tiling.tiles)
                if (tile.leftOut)
                    left.push_back(tiling.numberOf(tile));
            return left;
        };
        const clipping::Window more{min - Point(1), max};
        QCOMPARE(numbers(plan, {min, max}), (std::vector{2, 6}));
        QCOMPARE(numbers(plan, more), (std::vector{7, 12})); // 4 columns, the first row is new
        const Tiling wide = *tilingOf(large, plan, more).value;
        const TilePlan next = toggled(toggled(plan, wide, wide.tiles[0]), wide, wide.tiles[6]);
        QCOMPARE(next.leftOut, (std::vector{1, 12}));
        QCOMPARE(numbers(next, more), (std::vector{1, 12}));
        QCOMPARE(numbers(next, {min, max}), std::vector{6});
        QCOMPARE(numbers(next, {min, max + Point(21, 0)}), std::vector{7}); // 4 columns again
        QVERIFY(toggled(plan, tiled(plan), tiled(plan).tiles[0]).beyond == SheetsBeyond{});
    }

    void wrongPlansAreRefusedInOneSentence_data()
    {
        QTest::addColumn<double>("margin");
        QTest::addColumn<double>("overlap");
        QTest::addColumn<bool>("marks");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("margin")
            << 105.0 << 0.0 << false
            << "The margin of 105\u00a0mm is too large: nothing of a sheet is left.";
        QTest::newRow("overlap") << 10.0 << 190.0 << false
                                 << "Overlap must be less than 190\u00a0mm, the width of a sheet.";
        QTest::newRow("negative") << -1.0 << 0.0 << false
                                  << "Margin and overlap of sheets must not be negative.";
        QTest::newRow("marks") << 4.0 << 0.0 << true
                               << "Marks need a margin of at least 5\u00a0mm on each sheet.";
        QTest::newRow("many") << 104.99 << 0.0 << false
                              << "The drawing needs more than 1000 sheets. Choose larger ones.";
        QTest::newRow("nan") << std::nan("") << 0.0 << false
                             << "Margin and overlap of sheets must not be negative.";
    }
    void wrongPlansAreRefusedInOneSentence()
    {
        QFETCH(double, margin);
        QFETCH(double, overlap);
        QFETCH(bool, marks);
        QFETCH(QString, sentence);
        const auto tiling = tilingOf(large, {.sheet = {210, 297},
                                             .margin = margin,
                                             .overlap = overlap,
                                             .marks = marks ? allMarks : SheetMarks{}});
        QVERIFY(!tiling);
        QCOMPARE(tiling.error, sentence);
    }
};

} // namespace tiles_tiling_test

TEST_CLASS(tiles_tiling_test::TilingTest, Core)
#include "tests/app/tiles/tiling_test.moc"
