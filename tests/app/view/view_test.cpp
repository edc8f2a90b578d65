// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/test_class.h"

namespace view_view_test {

namespace {

app::View someView()
{
    app::View view;
    view.size = {1280, 800};
    view.centre = {123.4, -56.7};
    view.zoom = 0.37;
    return view;
}

} // namespace

class ViewTest : public QObject {
    Q_OBJECT

private slots:
    void screenAndDrawingAreInverse()
    {
        const app::View view = someView();
        const app::Point p(10, 700);
        QVERIFY(glm::distance(view.toScreen(view.toDrawing(p)), p) < 1e-9);
    }
    void zoomingKeepsThePointUnderThePointer()
    {
        app::View view = someView();
        const app::Point pointer(1000, 77), before = view.toDrawing(pointer);
        view.zoomAt(pointer, 3.7);
        QVERIFY(glm::distance(view.toDrawing(pointer), before) < 1e-9);
    }
    void theWheelIsReversedExactly()
    {
        app::View view = someView();
        const app::View start = view;
        app::WheelZoom wheel;
        const app::Point pointer(333, 99);
        for (const double notches : {1.0, 1.0, 1.0, -2.0, 5.0, -6.0})
            wheel.turn(view, pointer, notches);
        QVERIFY(view == start);
        for (int i = 0; i < 7; ++i)
            wheel.turn(view, pointer, 0.1);
        QVERIFY(view != start);
        for (int i = 0; i < 7; ++i)
            wheel.turn(view, pointer, -0.1);
        QVERIFY(view == start);
    }
    void aNotchIsTwentyPerCent()
    {
        app::View view = someView();
        app::WheelZoom wheel;
        wheel.turn(view, {1, 1}, 1);
        QCOMPARE(view.zoom, 0.37 * 1.2);
    }
    void turningBackBeginsAtTheLimit()
    {
        for (const double direction : {-1.0, 1.0}) {
            app::View view = someView();
            app::WheelZoom wheel;
            for (int i = 0; i < 1000; ++i)
                wheel.turn(view, {5, 5}, direction);
            const double limit = view.zoom;
            QCOMPARE(limit, direction < 0 ? 1e-9 : 1e9);
            wheel.turn(view, {5, 5}, -2 * direction);
            QVERIFY(view.zoom != limit);
        }
    }
    void anotherViewInBetweenIsNotThrownAway()
    {
        app::View view = someView();
        app::WheelZoom wheel;
        wheel.turn(view, {5, 5}, 1);
        view.pan({100, 0});
        const app::View panned = view;
        wheel.turn(view, {5, 5}, 1);
        wheel.turn(view, {5, 5}, -1);
        QVERIFY(view == panned);
    }
    void fittingShowsAll()
    {
        app::View view = someView();
        view.fit({{-10, -20}, {90, 30}});
        const app::Point a = view.toScreen({-10, -20}), b = view.toScreen({90, 30});
        QCOMPARE(a.x, 24.0);
        QCOMPARE(b.x, 1280 - 24.0);
        QVERIFY(std::abs((a.y + b.y) / 2 - 400) < 1e-9);
    }
    void historyGoesBackAndForth()
    {
        app::ViewHistory history;
        app::View a = someView(), b = a, c = a;
        b.zoom = 2;
        c.zoom = 3;
        history.leave(a, 0);
        history.leave(b, 5000);
        QVERIFY(history.back(c) == b);
        QVERIFY(history.back(b) == a);
        QVERIFY(!history.back(a));
        QVERIFY(history.forth(a) == b);
        QVERIFY(history.forth(b) == c);
        QVERIFY(!history.forth(c));
    }
    void theOldestViewsAreForgotten()
    {
        app::ViewHistory history;
        app::View view = someView();
        for (int i = 0; i < 300; ++i) {
            view.zoom = 1 + i;
            history.leave(view, 5000 * i);
        }
        int count = 0;
        while (const auto before = history.back(view)) {
            QCOMPARE(before->zoom, 300.0 - count++);
            view = *before;
        }
        QCOMPARE(count, 200);
    }
    void aDragIsOneStay()
    {
        app::ViewHistory history;
        app::View view = someView();
        const app::View start = view;
        for (int i = 0; i < 50; ++i) {
            history.leave(view, 1000 + 16 * i);
            view.pan({1, 0});
        }
        QVERIFY(history.back(view) == start);
        QVERIFY(!history.back(start));
    }
};

} // namespace view_view_test

TEST_CLASS(view_view_test::ViewTest, None)
#include "tests/app/view/view_test.moc"
