// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/document/document_builder.h"
#include "app/document/flatten.h"
#include "app/document/hidden_objects.h"
#include "app/tiles/empty_sheets.h"
#include "app/tiles/sheets.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace tiles_empty_sheets_test {

using namespace app;

namespace {

const Page page{{-50, 20}, {400, 200}, {400, Unit::Mm}, {200, Unit::Mm}, {}};

Document drawingOf(const std::vector<Object>& objects)
{
    DocumentBuilder builder;
    builder.open({.name = "Drawing"});
    for (const Object& object : objects)
        builder.add(object);
    builder.close();
    return builder.take(page);
}

Object polyline(const std::vector<Point>& points, const Style& style, bool closed = false)
{
    Subpath path{points.front(), {}, closed};
    for (std::size_t i = 1; i < points.size(); ++i)
        path.segments.push_back({points[i]});
    return {.path = Path({&path, 1}), .style = style};
}

const Style stroke{.stroke = Colour{}, .width = 0.5};
const Style fill{.stroke = std::nullopt, .fill = Colour{}};

Sheets sheetsOf(const Document& drawing, const TilePlan& plan)
{
    const CutOptions options{.clipAll = usualAlgorithm().corrected.clipAll,
                             .tolerance = usualTolerance(page)};
    const SceneLines lines =
        linesOf(drawing.objects(), drawing.containers().hiddenRanges(), options.tolerance);
    const Tiling tiling =
        withoutEmptySheets(*tilingOf(page, plan).value, plan, lines, drawing.objects(), 0);
    return {drawing, plan, tiling, options, {}};
}

std::vector<int> emptyOf(const Document& drawing, const TilePlan& plan)
{
    const Tiling tiling = sheetsOf(drawing, plan).tiling;
    std::vector<int> empty;
    for (const Tile& tile : tiling.tiles)
        if (tile.empty)
            empty.push_back(tiling.numberOf(tile));
    return empty;
}

const TilePlan fourByTwo{.columns = 4, .rows = 2, .margin = 0};

} // namespace

class EmptySheetsTest : public QObject {
    Q_OBJECT

private slots:
    void aSheetIsEmptyIfNothingIsDrawnOnIt()
    {
        std::mt19937 random(3);
        const auto within = [&](double low, double high) {
            return std::uniform_real_distribution(low, high)(random);
        };
        int empty = 0, full = 0;
        for (int round = 0; round < 150; ++round) {
            std::vector<Object> objects;
            for (int i = 0; i <= round % 4; ++i) {
                const Point middle{within(-80, 380), within(0, 240)};
                const double size = round % 3 ? 30 : 200;
                std::vector<Point> points;
                for (int corner = 0; corner < 2 + i; ++corner)
                    points.push_back(middle + Point(within(-size, size), within(-size, size)));
                objects.push_back(polyline(points, i % 2 ? fill : stroke, i % 3 == 0));
                objects.back().hidden = round % 7 == 0;
            }
            const TilePlan plans[]{fourByTwo,
                                   {.columns = 7, .rows = 5, .margin = 0, .overlap = 12},
                                   {.sheet = {90, 70}, .margin = 5, .shift = {30, 11}}};
            const Sheets sheets =
                sheetsOf(drawingOf(objects), plans[std::size_t(round) % std::size(plans)]);
            for (const Tile& tile : sheets.tiling.tiles) {
                const bool nothing = withoutHidden(sheets.sheet(tile)).objects().empty();
                QVERIFY2(tile.empty == nothing, qPrintable(QStringLiteral("round %1, sheet %2-%3")
                                                               .arg(round)
                                                               .arg(tile.row)
                                                               .arg(tile.column)));
                ++(nothing ? empty : full);
            }
        }
        QVERIFY(empty > 500 && full > 500);
    }

    void aSheetInsideAnAreaIsNotEmpty()
    {
        const std::vector<Point> frame{{-60, 10}, {360, 10}, {360, 230}, {-60, 230}};
        QCOMPARE(emptyOf(drawingOf({polyline(frame, fill, true)}), fourByTwo), std::vector<int>{});
        QCOMPARE(emptyOf(drawingOf({polyline(frame, stroke, true)}), fourByTwo).size(), 8u);
    }

    // A cut leaves no contacts, but points that were points.
    void aLineThatOnlyTouchesIsNotOnTheSheet()
    {
        const auto diamond = polyline({{-50, 20}, {50, 120}, {-50, 219}}, stroke);
        QCOMPARE(emptyOf(drawingOf({diamond}), fourByTwo), (std::vector<int>{2, 3, 4, 6, 7, 8}));
        QCOMPARE(emptyOf(drawingOf({polyline({{200, 30}, {200, 30}}, stroke)}), fourByTwo),
                 (std::vector<int>{1, 2, 4, 5, 6, 7, 8}));
    }

    void theyAreWrittenIfWanted()
    {
        TilePlan plan = fourByTwo;
        plan.empty = EmptySheets::Written;
        plan.leftOut = {1};
        const Document drawing = drawingOf({polyline({{200, 30}, {210, 40}}, stroke)});
        const Sheets all = sheetsOf(drawing, plan);
        QCOMPARE(all.count(), 7u);
        QCOMPARE(emptySheetsText(all.tiling), QString());
        plan.empty = EmptySheets::LeftOut;
        const Sheets some = sheetsOf(drawing, plan);
        QCOMPARE(some.count(), 1u);
        QCOMPARE(emptySheetsText(some.tiling), "7 empty sheets were left out.");
        QVERIFY(!some.tiling.tiles[2].leftOut);
    }
};

} // namespace tiles_empty_sheets_test

TEST_CLASS(tiles_empty_sheets_test::EmptySheetsTest, Core)
#include "tests/app/tiles/empty_sheets_test.moc"
