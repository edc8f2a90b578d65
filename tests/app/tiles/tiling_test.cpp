// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/tiling.h"

#include <QTest>

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
