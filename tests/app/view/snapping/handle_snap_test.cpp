// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/handle_snap.h"

#include <QTest>

#include "tests/test_class.h"

namespace view_snapping_handle_snap_test {

// A box from (10, 10) to (30, 20), whose handles snap.
class HandleSnapTest : public QObject {
    Q_OBJECT

    static app::MovedSnap to(const app::Point& place, const app::Point& at)
    {
        return {place - at, app::Snap{place, &app::snapKind("ends")}};
    }

private slots:
    void aCornerGoesToThePlace()
    {
        const app::DraggedHandle corner{{1, 1}, {30, 20}, {10, 10}};
        const auto snap = heldByHandle(corner, {4, 6}, to({35, 25}, corner.at));
        QCOMPARE(snap.by, app::Point(5, 5));
        QVERIFY(snap.place);
    }
    void aSideMovesAcrossItselfOnly()
    {
        const app::DraggedHandle side{{1, 0}, {30, 15}, {10, 15}};
        const auto snap = heldByHandle(side, {4, 6}, to({35, 22}, side.at));
        QCOMPARE(snap.by, app::Point(5, 6));
        QVERIFY(snap.place);
        const auto level = heldByHandle(side, {4, 6}, {{4, 7}, {}, {{1, 22, 0, 50}}});
        QCOMPARE(level.by, app::Point(4, 6));
        QVERIFY(level.lines.empty());
        QVERIFY(!heldByHandle(side, {4, 6}, to({34, 22}, side.at)).place); // it changes nothing
    }
    void inProportionASidePassesThroughThePlace()
    {
        app::DraggedHandle corner{{1, 1}, {30, 20}, {10, 10}, app::Proportion::Kept};
        const auto snap = heldByHandle(corner, {20, 9}, to({50, 28}, corner.at));
        QCOMPARE(snap.by, app::Point(20, 10));
        QVERIFY(snap.place);
        const auto aligned = heldByHandle(corner, {20, 9}, {{20, 11}, {}, {{1, 31, 0, 50}}});
        QCOMPARE(aligned.by, app::Point(22, 11));
        QCOMPARE(heldByHandle(corner, {20, 9}, {{20, 9}}).by, app::Point(20, 9)); // nothing is near
    }
};

} // namespace view_snapping_handle_snap_test

TEST_CLASS(view_snapping_handle_snap_test::HandleSnapTest, None)
#include "tests/app/view/snapping/handle_snap_test.moc"
