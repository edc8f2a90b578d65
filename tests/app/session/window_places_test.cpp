// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/window_places.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_window_places_test {

using namespace app;

namespace {

Object line(const Point& a, const Point& b)
{
    return {.path = Path(clipping::Segment{a, b}), .style = {.stroke = Colour{}}};
}

/// Two layers, "Empty" above "Walls" with two lines, on a page of 100 by 50.
struct Plan : Session {
    explicit Plan(std::vector<ClipWindow> windows = {})
    {
        DocumentBuilder builder;
        builder.open({.name = QStringLiteral("Walls")});
        builder.add(line({10, 10}, {40, 20}));
        builder.add(line({60, 5}, {90, 45}));
        builder.close();
        builder.open({.name = QStringLiteral("Empty")});
        builder.close();
        load({builder.take(Page{.size = {100, 50}}, {}, {std::move(windows)}), {}});
    }
    const std::vector<ClipWindow>& list() const { return now().windows().list; }
    clipping::Window box(std::size_t i) const { return *axisAlignedBox(list()[i].shape); }
};

const LayingPlace& place(std::string_view key)
{
    return *std::ranges::find(windowPlaces(), key, &LayingPlace::key);
}

} // namespace

class WindowPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void aWindowIsLaidOnPageSelectionAndLayer()
    {
        Plan plan;
        const ContainerId walls = plan.now().containers().childrenOf(0)[0];
        QVERIFY(!place("window-on-selection").box(plan));
        plan.select({0});
        layWindow(plan, place("window-on-selection"));
        QCOMPARE(plan.box(0), (clipping::Window{{10, 10}, {40, 20}}));
        plan.pen.layer = plan.now().containers().childrenOf(0)[1];
        QVERIFY(!place("window-on-layer").box(plan));
        plan.pen.layer = walls;
        layWindow(plan, place("window-on-layer")); // the only window, an upright rectangle, moves
        QCOMPARE(plan.list().size(), 1u);
        QCOMPARE(plan.box(0), (clipping::Window{{10, 5}, {90, 45}}));
        QCOMPARE(plan.history.undoText(), "Lay clip window on layer");
        plan.history.undo();
        QCOMPARE(plan.box(0), (clipping::Window{{10, 10}, {40, 20}}));
    }
    void besidesSeveralOneIsAdded()
    {
        const RectangleShape box{{{1, 2}, {3, 4}}};
        Plan plan({{.name = "a", .shape = box}, {.name = "b", .shape = box}});
        layWindow(plan, windowPlaces().front());
        QCOMPARE(plan.list().size(), 3u);
        QCOMPARE(plan.box(0), box.box);
        QCOMPARE(plan.box(2), (clipping::Window{{0, 0}, {100, 50}}));
        QCOMPARE(plan.windowNumber(), std::optional<std::size_t>(2));
        Plan rotated({{.shape = RectangleShape{box.box, 1}}});
        layWindow(rotated, windowPlaces().front());
        QCOMPARE(rotated.list().size(), 2u);
    }
    void theNewWindowOfALayerHasItsName()
    {
        Plan plan;
        plan.pen.layer = plan.now().containers().childrenOf(0)[0];
        layWindow(plan, place("window-on-layer"));
        QCOMPARE(plan.list()[0].name, "Walls");
    }
    void theMarginLeavesTheMiddleOfThePage()
    {
        Plan plan;
        QVERIFY(!layWindowInside(plan, PageMargins::same(10)));
        QCOMPARE(plan.box(0), (clipping::Window{{10, 10}, {90, 40}}));
        QVERIFY(!layWindowInside(plan, PageMargins::same(-2.5)));
        QCOMPARE(plan.box(0), (clipping::Window{{-2.5, -2.5}, {102.5, 52.5}}));
        QVERIFY(!layWindowInside(plan, {1, 2, 3, 4}));
        QCOMPARE(plan.box(0), (clipping::Window{{1, 2}, {97, 46}}));
        QVERIFY(layWindowInside(plan, PageMargins::same(25)));
        QVERIFY(layWindowInside(plan, {60, 0, 40, 0}));
        QCOMPARE(plan.history.count(), 3);
    }
};

} // namespace session_window_places_test

TEST_CLASS(session_window_places_test::WindowPlacesTest, Core)
#include "tests/app/session/window_places_test.moc"
