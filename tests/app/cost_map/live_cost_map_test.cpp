// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/live_cost_map.h"

#include <QSignalSpy>
#include <QTest>
#include <QThreadPool>

#include "tests/test_class.h"

namespace cost_map_live_cost_map_test {

using app::CostPlan;
using app::LiveCostMap;

namespace {

CostPlan planOf(int columns, int rows)
{
    CostPlan plan = app::usualCostPlan({{0, 0}, {30, 20}});
    plan.columns = columns;
    plan.rows = rows;
    return plan;
}

} // namespace

class LiveCostMapTest : public QObject {
    Q_OBJECT

private slots:
    void aCoarseMapIsFollowedByAFineOne()
    {
        LiveCostMap live;
        const CostPlan plan = planOf(60, 45);
        std::vector<int> widths;
        connect(&live, &LiveCostMap::changed, this,
                [&] { widths.push_back(live.map()->plan.columns); });
        live.ask(plan);
        QVERIFY(!live.upToDate());
        QTRY_VERIFY(live.upToDate());
        QCOMPARE(widths, (std::vector{20, 60}));
        QCOMPARE(live.map()->values, app::costMap(plan).values);
    }

    void theNewestPlanReplacesTheOthers()
    {
        LiveCostMap live;
        for (int columns = 900; columns >= 60; columns -= 60)
            live.ask(planOf(columns, 45));
        live.finish();
        QCOMPARE(live.map()->plan, planOf(60, 45));
        QCOMPARE(live.map()->values, app::costMap(planOf(60, 45)).values);
        QSignalSpy changed(&live, &LiveCostMap::changed);
        QTRY_COMPARE(app::backgroundThreads().activeThreadCount(), 0);
        QTest::qWait(20);
        QVERIFY(changed.isEmpty()); // of the plans before
    }

    void withoutAPlanThereIsNoMap()
    {
        LiveCostMap live;
        QVERIFY(live.upToDate() && !live.map());
        live.finish();
        live.ask(planOf(3000, 2000));
        live.ask(std::nullopt);
        QVERIFY(live.upToDate() && !live.map());
        QTRY_COMPARE(app::backgroundThreads().activeThreadCount(), 0);
        QVERIFY(!live.map());
    }

    void aPlanOfOneCellIsFineAtOnce()
    {
        LiveCostMap live;
        live.ask(planOf(1, 1));
        live.finish();
        QCOMPARE(live.map()->values.size(), std::size_t(1));
    }
};

} // namespace cost_map_live_cost_map_test

TEST_CLASS(cost_map_live_cost_map_test::LiveCostMapTest, Core)
#include "tests/app/cost_map/live_cost_map_test.moc"
