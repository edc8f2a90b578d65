// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/legend.h"
#include "app/cost_map/measure.h"
#include "app/cost_map/paint.h"
#include "app/cost_map/words.h"

#include <QLocale>
#include <QTest>

#include <map>

#include "tests/painted_texts.h"
#include "tests/test_class.h"

namespace cost_map_cost_map_paint_test {

using namespace app;

namespace {

constexpr QSize size(600, 400);

CostPlan planOf(std::optional<Variant> shown, std::size_t measure)
{
    CostPlan plan = usualCostPlan({{-100, -75}, {100, 75}});
    plan.shown = shown;
    plan.measure = &costMeasures()[measure];
    plan.columns = 60;
    plan.rows = 45;
    return plan;
}

double numberIn(const QString& text)
{
    return QLocale().toDouble(QString(text).replace(u'−', u'-'));
}

std::vector<PaintedText> legendOf(const CostMap& map, const QRectF& room)
{
    return textsPainted(size, [&](QPainter& painter) {
        paintLegend(painter, room, map, costMapLook(Ground::Light));
    });
}

} // namespace

class CostMapPaintTest : public QObject {
    Q_OBJECT

private slots:
    void theLegendNamesTheShareOfEachKindOfCell()
    {
        const CostMap map = costMap(planOf({}, 0));
        std::map<std::uint32_t, int> cells;
        for (const std::uint32_t which : map.cheapest)
            ++cells[which];
        const auto texts = legendOf(map, {10, 10, 500, 200});
        QCOMPARE(texts.size(), cells.size());
        for (const auto& [which, count] : cells) {
            const QString names = namesOf(map.plan, which) + "  ";
            const auto text = std::ranges::find_if(
                texts, [&](const PaintedText& one) { return one.text.startsWith(names); });
            QVERIFY2(text != texts.end(), qPrintable(names));
            const double percent = numberIn(text->text.mid(names.size()).chopped(2));
            QVERIFY2(text->text.endsWith(" %"), qPrintable(text->text));
            QVERIFY2(std::abs(percent - 100. * count / double(map.cheapest.size())) <= 0.05,
                     qPrintable(QString("%1: %2 cells").arg(text->text).arg(count)));
        }
    }

    void theNumbersOfTheScaleStandAtTheirPlaces()
    {
        const QRectF room(10, 10, 400, 40);
        const CostMap map = costMap(planOf(Variant{clipping::findAlgorithm("MD")}, 0));
        const auto [low, high] = std::ranges::minmax(map.values);
        const auto texts = legendOf(map, room);
        QVERIFY(texts.size() >= 3);
        QCOMPARE(texts.back().text, costText(*map.plan.measure, high));
        QCOMPARE(numberIn(texts.front().text), double(low));
        for (std::size_t i = 0; i + 1 < texts.size(); ++i) {
            const double value = numberIn(texts[i].text);
            const double x = room.left() + (value - low) / (high - low) * room.width();
            const double middle = std::clamp(x, room.left() + texts[i].place.width() / 2,
                                             room.right() - texts[i].place.width() / 2);
            QVERIFY2(std::abs(texts[i].place.center().x() - middle) < 1, qPrintable(texts[i].text));
            QVERIFY2(texts[i].place.right() < texts[i + 1].place.left(), qPrintable(texts[i].text));
        }
    }

    void eachNumberOnTheMapIsTheCostThere()
    {
        const QRectF room(0, 0, size.width(), size.height());
        for (const char* key : {"MD", "CS", "NLN"}) {
            const CostMap map = costMap(planOf(Variant{clipping::findAlgorithm(key)}, 0));
            const QRectF place = mapPlace(map.plan, room);
            const auto texts = textsPainted(size, [&](QPainter& painter) {
                paintMap(painter, place, map, costMapLook(Ground::Dark), RegionLabels::Shown);
            });
            QVERIFY(texts.size() >= 5);
            for (const PaintedText& text : texts) {
                const Point there = onPlane(map.plan, place, text.place.center());
                const double cost = costOf(*map.plan.shown, *map.plan.measure,
                                           map.plan.lineTo(there), map.plan.window);
                QVERIFY2(numberIn(text.text) == cost,
                         qPrintable(QString("%1: %2, %3").arg(key, text.text).arg(cost)));
            }
        }
    }

    void eachNameOnTheMapIsTheCheapestThere()
    {
        const QRectF room(0, 0, size.width(), size.height());
        const CostMap map = costMap(planOf({}, 0));
        const QRectF place = mapPlace(map.plan, room);
        const auto texts = textsPainted(size, [&](QPainter& painter) {
            paintMap(painter, place, map, costMapLook(Ground::Light), RegionLabels::Shown);
        });
        QVERIFY(!texts.empty());
        for (const PaintedText& text : texts) {
            const Point there = onPlane(map.plan, place, text.place.center());
            const Cheapest best = cheapestOf(map.plan, map.plan.lineTo(there));
            QCOMPARE(text.text, namesOf(map.plan, best.which));
        }
    }
};

} // namespace cost_map_cost_map_paint_test

TEST_CLASS(cost_map_cost_map_paint_test::CostMapPaintTest, Gui)
#include "tests/app/cost_map/cost_map_paint_test.moc"
