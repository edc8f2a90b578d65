// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/instances.h"

#include "tests/test_class.h"

namespace canvas_instances_test {

using namespace ui;

namespace {

/// A triangle, which ends where it begins, or an angle of two edges.
app::DrawList three(const app::DrawCommand& command, bool closed)
{
    app::DrawList list;
    list.points = {{10, 10}, {90, 20}, {40, 80}};
    if (closed)
        list.points.push_back(list.points.front());
    list.polylines = {{0, std::uint32_t(list.points.size()), closed, true, true}};
    list.commands = {command};
    list.commands.front().polylines = 1;
    return list;
}

Batches triangle(std::uint8_t alpha)
{
    return batches(three({{}, {10, 20, 30, alpha}}, true), {100, 100});
}

Batches angle(std::uint8_t alpha, double width, app::Join join)
{
    app::StrokeStyle style;
    style.colour = {10, 20, 30, alpha};
    style.width = width;
    style.join = join;
    return batches(three({style}, false), {100, 100});
}

} // namespace

class InstancesTest : public QObject {
    Q_OBJECT

private slots:
    void anOpaqueAreaHasAnEdgeAndATranslucentOneHasNot()
    {
        const Batches opaque = triangle(255);
        QCOMPARE(opaque.batches.size(), 2U);
        QVERIFY(opaque.batches[0].filled && !opaque.batches[1].filled);
        QCOMPARE(opaque.batches[1].count, 3U);
        const Batches translucent = triangle(254);
        QCOMPARE(translucent.batches.size(), 1U);
        QVERIFY(translucent.batches[0].filled && translucent.instances.empty());
    }

    void pointsAreFromTheMiddleOfTheView()
    {
        const Batches area = triangle(254);
        QCOMPARE(area.contourCounts.front(), 4);
        QCOMPARE(area.points[0].x, -40.0F);
        QCOMPARE(area.points[2].y, 30.0F);
    }

    void whereJoinsWouldShowAStrokeIsAnArea()
    {
        QVERIFY(!angle(255, 20, app::Join::Round).batches.front().filled);
        QVERIFY(angle(254, 20, app::Join::Round).batches.front().filled);
        QVERIFY(angle(255, 20, app::Join::Miter).batches.front().filled);
        QVERIFY(!angle(255, 0.5, app::Join::Miter).batches.front().filled);
    }

    void joinsOfATranslucentStrokeAreNotPaintedTwice()
    {
        const auto inner = [](const Batches& all) { return all.instances.front().caps >> 2; };
        QVERIFY(inner(angle(255, 20, app::Join::Round)) != 0);
        QCOMPARE(inner(angle(128, 0.5, app::Join::Round)), 0U);
    }
};

} // namespace canvas_instances_test

TEST_CLASS(canvas_instances_test::InstancesTest, None)
#include "tests/ui/canvas/instances_test.moc"
