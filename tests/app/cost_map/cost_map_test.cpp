// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/cost_map/files.h"
#include "app/cost_map/regions.h"
#include "app/cost_map/words.h"
#include "app/view/visible_colour.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QTest>

#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace cost_map_cost_map_test {

using namespace clipping;
using namespace app;

namespace {

constexpr Window window{{-100, -75}, {100, 75}};

CostPlan planOf(const Variant& variant, const CostMeasure& measure)
{
    CostPlan plan = usualCostPlan(window);
    plan.shown = variant;
    plan.measure = &measure;
    plan.columns = 24;
    plan.rows = 18;
    return plan;
}

const CostMeasure& costMeasure(const QString& key)
{
    return *std::ranges::find(costMeasures(), key,
                              [](const CostMeasure& measure) { return latin(measure.key); });
}

CostPlan cheapestPlan()
{
    CostPlan plan = planOf({}, costMeasures().front());
    plan.shown.reset();
    return plan;
}

/// What all kinds of sight go by: the lightness L* of a colour.
double lightness(const QColor& colour)
{
    const QColor linear = colour;
    const auto part = [](double x) { return std::pow(x, 2.2); };
    return 0.2126 * part(linear.redF()) + 0.7152 * part(linear.greenF())
           + 0.0722 * part(linear.blueF());
}

} // namespace

class CostMapTest : public QObject {
    Q_OBJECT

private slots:
    void eachMeasureCountsWhatItsNameSays()
    {
        const OperationCounts counts{.additions = 20,
                                     .multiplications = 300,
                                     .divisions = 4000,
                                     .comparisons = 1,
                                     .negations = 50000};
        const auto of = [&](const char* key) {
            return costMeasure(QLatin1StringView(key)).of(counts);
        };
        QCOMPARE(of("comparisons"), 1u);
        QCOMPARE(of("additions"), 20u);
        QCOMPARE(of("multiplications"), 300u);
        QCOMPARE(of("divisions"), 4000u);
        QCOMPARE(of("operations"), 4321u);
    }

    void everyCellIsTheCountOfItsLine_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("measure");
        for (const Variant& variant : variants())
            for (const CostMeasure& measure : costMeasures())
                if (!measure.isTime())
                    QTest::addRow("%s %s", qPrintable(keyOf(variant)), measure.key.data())
                        << keyOf(variant) << latin(measure.key);
    }
    void everyCellIsTheCountOfItsLine()
    {
        QFETCH(QString, key);
        QFETCH(QString, measure);
        const Variant variant = *findVariant(key);
        const CostPlan plan = planOf(variant, costMeasure(measure));
        const CostMap map = costMap(plan);
        QVERIFY(map.complete());
        const auto& uses = functionsOf(variant);
        for (int row = 0; row < plan.rows; ++row)
            for (int column = 0; column < plan.columns; ++column) {
                const Point middle(-300 + 600 * (column + 0.5) / 24, -225 + 450 * (row + 0.5) / 18);
                const Segment line{{-200, -45}, middle};
                const OperationCounts counts = uses.count({&line, 1}, window);
                QCOMPARE(map.values[map.at(column, row)], float(plan.measure->of(counts)));
            }
    }

    void theCheapestAreAllThatCostTheLeast()
    {
        const CostPlan plan = cheapestPlan();
        QCOMPARE(plan.variants.size(), algorithms().size());
        const CostMap map = costMap(plan);
        bool tie = false;
        for (int row = 0; row < plan.rows; ++row)
            for (int column = 0; column < plan.columns; ++column) {
                const Segment line = plan.lineTo(plan.middleOf(column, row));
                const std::size_t cell = map.at(column, row);
                for (std::size_t i = 0; i < plan.variants.size(); ++i) {
                    const double cost = costOf(plan.variants[i], *plan.measure, line, window);
                    QCOMPARE((map.cheapest[cell] >> i & 1) != 0, cost == map.values[cell]);
                    QVERIFY(cost >= map.values[cell]);
                }
                tie = tie || std::popcount(map.cheapest[cell]) > 1;
            }
        QVERIFY(tie);
    }

    void itGrowsInSlices()
    {
        const CostPlan plan = cheapestPlan();
        CostMap map{plan};
        while (!map.complete())
            map = extended(std::move(map), 50);
        QCOMPARE(map.values, costMap(plan).values);
        QCOMPARE(map.cheapest, costMap(plan).cheapest);
    }

    void eitherEndCanBeFixed()
    {
        CostPlan plan = planOf({findAlgorithm("NLN")}, costMeasures().front());
        plan.end = FixedEnd::End2;
        const Segment line = plan.lineTo({1, 2});
        QCOMPARE(line.a, Point(1, 2));
        QCOMPARE(line.b, plan.fixed);
        QCOMPARE(
            costMap(plan).values.front(),
            float(costOf(*plan.shown, *plan.measure, plan.lineTo(plan.middleOf(0, 0)), window)));
    }

    void timesAreNanoseconds()
    {
        CostPlan plan = planOf({findAlgorithm("CS")}, costMeasure("time"));
        plan.columns = plan.rows = 3;
        for (const float nanoseconds : notEmpty(costMap(plan).values))
            QVERIFY2(nanoseconds > 0.1 && nanoseconds < 1e6,
                     qPrintable(QString::number(nanoseconds)));
    }

    void captionsDescribeACell()
    {
        const CostPlan plan = planOf({findAlgorithm("MD")}, costMeasures().front());
        QCOMPARE(costWords(plan, {-200, 100}), "2 operations here; cheapest: NLN = MD = exact 2");
        const Cheapest best = cheapestOf(plan, plan.lineTo({0, 0}));
        QCOMPARE(costWords(plan, {0, 0}), QString("24 operations here; cheapest: %1 %2")
                                              .arg(namesOf(plan, best.which))
                                              .arg(best.cost));
        QCOMPARE(costText(costMeasure("divisions"), 1), "1 division");
    }

    void regionsHangTogether()
    {
        CostPlan plan = planOf({findAlgorithm("MD")}, costMeasures().front());
        plan.columns = 7;
        plan.rows = 5;
        CostMap map{plan};
        for (int row = 0; row < 5; ++row)
            for (int column = 0; column < 7; ++column)
                map.values.push_back(column < 5 ? 1.0F : row == 2 ? 3.0F : 2.0F);
        const auto regions = regionsOf(map);
        QCOMPARE(regions.size(), std::size_t(4));
        QCOMPARE(regions[0].cells, std::size_t(25));
        QCOMPARE(regions[0].column, 2);
        QCOMPARE(regions[0].row, 2);
        QCOMPARE(regions[0].reach, 2);
        QCOMPARE(regions[1].cells, std::size_t(4));
        QCOMPARE(regions[2].cells, std::size_t(2));
    }

    void theLegendKnowsAllValues()
    {
        const CostMap map = costMap(cheapestPlan());
        const CostLegend legend = legendOf(map);
        std::size_t cells = 0;
        for (const auto& share : legend.shares)
            cells += share.cells;
        QCOMPARE(cells, map.plan.cells());
        QCOMPARE(legend.ticks.front(), double(*std::ranges::min_element(map.values)));
        QCOMPARE(legend.ticks.back(), double(*std::ranges::max_element(map.values)));
        QCOMPARE(legend.shareOf(legend.range.low), 0.0);
        QCOMPARE(legend.shareOf(legend.range.high), 1.0);
    }

    void higherCostContrastsMoreWithTheBackground()
    {
        for (const Ground ground : {Ground::Light, Ground::Dark})
            for (int i = 0; i < 100; ++i) {
                const double less = lightness(sequentialColour(i / 100., ground));
                const double more = lightness(sequentialColour((i + 1) / 100., ground));
                QVERIFY2(ground == Ground::Light ? more < less : more > less,
                         qPrintable(QString::number(i)));
            }
    }

    void aPlaceOnTheMapIsThePoint()
    {
        const CostPlan plan = planOf({findAlgorithm("MD")}, costMeasures().front());
        const QRectF place = mapPlace(plan, {10, 20, 400, 1000});
        QCOMPARE(place, QRectF(10, 20, 400, 300));
        QCOMPARE(onMap(plan, place, plan.window.min), place.topLeft() + QPointF(400, 300) / 3);
        const Point back = onPlane(plan, place, onMap(plan, place, {12, 34}));
        QVERIFY(std::abs(back.x - 12) < 1e-9 && std::abs(back.y - 34) < 1e-9);
    }

    void aPictureShowsEveryCellInItsColour()
    {
        const CostMap map = costMap(planOf({findAlgorithm("MD")}, costMeasures().front()));
        const CostMapLook look = costMapLook(Ground::Dark);
        QImage image(240, 180, QImage::Format_RGB32);
        QPainter painter(&image);
        paintMap(painter, {0, 0, 240, 180}, map, look, RegionLabels::None);
        painter.end();
        const CostLegend legend = legendOf(map);
        const auto expected = [&](int column, int row) {
            const double share = legend.shareOf(map.values[map.at(column, row)]);
            return sequentialColour(std::round(share * 255) / 255., Ground::Dark);
        };
        for (const auto& [column, row] : {std::pair(0, 0), {23, 0}, {12, 9}, {20, 16}})
            QCOMPARE(image.pixelColor(column * 10 + 5, row * 10 + 5), expected(column, row));
        const QImage whole = costPicture(map, look);
        QVERIFY(whole.width() > 1000 && !whole.text("Title").isEmpty());
    }

    void theTableHasARowACell()
    {
        CostPlan plan = cheapestPlan();
        plan.columns = 4;
        plan.rows = 3;
        const CostMap map = costMap(plan);
        const Table table = costTable(map);
        QCOMPARE(table.rows.size(), std::size_t(12));
        QCOMPARE(table.names, QStringList({"x", "y", "operations", "cheapest"}));
        QCOMPARE(table.rows.front().mid(0, 2), QStringList({"-225", "-150"}));
        QCOMPARE(table.rows.front()[2].toDouble(), double(map.values.front()));
        QBuffer out;
        out.open(QIODevice::WriteOnly);
        QVERIFY(
            !app::kindOf(costMapFormats(), u"CSV")->write(map, costMapLook(Ground::Light), out));
        QCOMPARE(out.data().count('\n'), 13);
        QVERIFY(writeCostMap(map, "/nowhere/map.unknown", costMapLook(Ground::Light))
                    ->contains(".png"));
    }

    void aWindowWithoutExtentHasPlaneAround()
    {
        for (const Window& thin : {Window{{1, 1}, {1, 1}}, Window{{0, 0}, {5, 0}},
                                   Window{{0, 0}, {0, 0}}, Window{{1e9, 0}, {1e9, 1}}}) {
            const Window area = areaAround(thin);
            QVERIFY(area.min.x < thin.min.x && area.max.x > thin.max.x);
            QVERIFY(area.min.y < thin.min.y && area.max.y > thin.max.y);
        }
    }
};

} // namespace cost_map_cost_map_test

TEST_CLASS(cost_map_cost_map_test::CostMapTest, Gui)
#include "tests/app/cost_map/cost_map_test.moc"
