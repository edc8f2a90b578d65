// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/handles.h"

#include <QTest>

#include "tests/test_class.h"

namespace view_handles_test {

namespace {

app::View unitView()
{
    app::View view;
    view.size = {1000, 1000};
    view.centre = {500, 500};
    return view;
}

const clipping::Window start{{100, 200}, {300, 300}};

} // namespace

class HandlesTest : public QObject {
    Q_OBJECT

private slots:
    void eachHandleMovesItsSidesAlone()
    {
        for (const app::Handle handle : app::handles()) {
            const clipping::Window w = app::dragged(start, handle, {7, -5});
            QCOMPARE(w.min.x, handle.x < 0 ? 107.0 : 100.0);
            QCOMPARE(w.max.x, handle.x > 0 ? 307.0 : 300.0);
            QCOMPARE(w.min.y, handle.y < 0 ? 195.0 : 200.0);
            QCOMPARE(w.max.y, handle.y > 0 ? 295.0 : 300.0);
        }
        QCOMPARE(app::dragged(start, {}, {7, -5}), (clipping::Window{{107, 195}, {307, 295}}));
    }
    void draggedOverTheOppositeSideItTurnsOver()
    {
        QCOMPARE(app::dragged(start, {1, 0}, {-250, 0}), (clipping::Window{{50, 200}, {100, 300}}));
        for (const app::Handle handle : app::handles())
            for (const double by : {-1000.0, -100.0, 100.0, 1000.0})
                for (const auto proportion :
                     {app::Proportion::Free, app::Proportion::Kept, app::Proportion::Square})
                    for (const auto anchor : {app::Anchor::Opposite, app::Anchor::Centre}) {
                        const auto w =
                            app::dragged(start, handle, {by, by / 2}, proportion, anchor);
                        QVERIFY(w.min.x <= w.max.x && w.min.y <= w.max.y);
                    }
    }
    void proportionsAreKept()
    {
        for (const app::Handle handle : app::handles()) {
            const auto w = app::dragged(start, handle, {30, 20}, app::Proportion::Kept);
            const app::Point size = w.max - w.min;
            QVERIFY(std::abs(size.x / size.y - 2) < 1e-12);
        }
        const auto corner = app::dragged(start, {1, 1}, {100, 0}, app::Proportion::Kept);
        QCOMPARE(corner, (clipping::Window{{100, 200}, {400, 350}}));
        const auto side = app::dragged(start, {1, 0}, {100, 0}, app::Proportion::Kept);
        QCOMPARE(side, (clipping::Window{{100, 175}, {400, 325}}));
    }
    void fromTheCentreBothSidesMove()
    {
        const auto w =
            app::dragged(start, {1, 0}, {10, 99}, app::Proportion::Free, app::Anchor::Centre);
        QCOMPARE(w, (clipping::Window{{90, 200}, {310, 300}}));
    }
    void aNewRectangleIsOrderedSquareOrCentred()
    {
        QCOMPARE(app::between({5, 9}, {1, 2}), (clipping::Window{{1, 2}, {5, 9}}));
        QCOMPARE(app::between({0, 0}, {3, -7}, app::Proportion::Square),
                 (clipping::Window{{0, -7}, {7, 0}}));
        QCOMPARE(app::between({0, 0}, {3, -7}, app::Proportion::Free, app::Anchor::Centre),
                 (clipping::Window{{-3, -7}, {3, 7}}));
    }
    void handlesAcceptTwentyFourPixels()
    {
        const app::View view = unitView();
        QCOMPARE(app::handleAt({112, 212}, start, view), (app::Handle{-1, -1}));
        QCOMPARE(app::handleAt({88, 188}, start, view), (app::Handle{-1, -1}));
        QCOMPARE(app::handleAt({87, 187}, start, view), std::nullopt);
        QCOMPARE(app::handleAt({200, 311}, start, view), (app::Handle{0, 1}));
        QCOMPARE(app::handleAt({150, 206}, start, view), app::Handle{}); // the outline, from inside
        QCOMPARE(app::handleAt({150, 194}, start, view), app::Handle{});
        QCOMPARE(app::handleAt({150, 230}, start, view), std::nullopt);
    }
    void aSmallWindowHasItsCornersOutside()
    {
        const clipping::Window small{{100, 100}, {300, 140}};
        const auto placed = app::placedHandles(small, unitView());
        QCOMPARE(placed.size(), std::size_t(4));
        for (const auto& p : placed)
            QVERIFY(p.screen.x < 100 || p.screen.x > 300);
    }
};

} // namespace view_handles_test

TEST_CLASS(view_handles_test::HandlesTest, None)
#include "tests/app/view/handles_test.moc"
