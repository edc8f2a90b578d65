// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/sheet_layout.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/test_class.h"

namespace tiles_sheet_layout_test {

using namespace app;

namespace {

/// 540 × 540 mm from (-100, 20); a unit is half a millimetre.
const Page page{{-100, 20}, {1080, 1080}, {540, Unit::Mm}, {540, Unit::Mm}, {}};

Tiling tiling()
{
    return *tilingOf(page, {.sheet = {210, 297}, .margin = 10, .overlap = 10}).value;
}

} // namespace

class SheetLayoutTest : public QObject {
    Q_OBJECT

private slots:
    void apartTheSheetsAreWholePapers()
    {
        const SheetLayout layout = layoutOf(tiling(), 10, SheetArrangement::Apart);
        QCOMPARE(layout.places.size(), 6u);
        for (const SheetPlace& place : layout.places)
            QVERIFY(glm::distance(place.paper.max - place.paper.min, Point(210, 297)) < 1e-9);
        QVERIFY(layout.places[1].paper.min.x > layout.places[0].paper.max.x + 10);
        QVERIFY(layout.places[3].paper.min.y > layout.places[0].paper.max.y + 10);
        QCOMPARE(layout.bounds.min, Point(0, 0));
    }

    void inPlaceTheSheetsOverlap()
    {
        const SheetLayout layout = layoutOf(tiling(), 10, SheetArrangement::InPlace);
        QCOMPARE(layout.places[0].part.max.x - layout.places[1].part.min.x, 10.0);
        QCOMPARE(layout.bounds.min, Point(-50, 10)); // in millimetres
        QCOMPARE(layout.bounds.max, Point(500, 554));
        QCOMPARE(layout.places[0].offset, layout.places[5].offset);
    }

    // The corner of the part on each sheet is the corner of its window in the drawing.
    void pointsOfTheDrawing()
    {
        const Tiling all = tiling();
        for (const auto arrangement : {SheetArrangement::InPlace, SheetArrangement::Apart}) {
            const SheetLayout layout = layoutOf(all, 10, arrangement);
            for (std::size_t i = 0; i < all.tiles.size(); ++i) {
                QCOMPARE(layout.toLayout(i, all.tiles[i].window.min), layout.places[i].part.min);
                QCOMPARE(layout.toDrawing(i, layout.places[i].part.max), all.tiles[i].window.max);
            }
        }
    }

    void sheetsAndEdgesAreFound()
    {
        const SheetLayout layout = layoutOf(tiling(), 10, SheetArrangement::Apart);
        QCOMPARE(layout.sheetAt({5, 5}).value(), 0u);
        QCOMPARE(layout.sheetAt(layout.places[4].paper.max).value(), 4u);
        QVERIFY(!layout.sheetAt({215, 5}));
        QCOMPARE(layout.edgeAt({201, 100}, 3).value(), 0); // at the right of the first part
        QCOMPARE(layout.edgeAt({100, 288}, 3).value(), 1);
        QVERIFY(!layout.edgeAt({10, 100}, 3)); // the outer edge
        QVERIFY(!layout.edgeAt({100, 100}, 3));
    }
};

} // namespace tiles_sheet_layout_test

TEST_CLASS(tiles_sheet_layout_test::SheetLayoutTest, Core)
#include "tests/app/tiles/sheet_layout_test.moc"
