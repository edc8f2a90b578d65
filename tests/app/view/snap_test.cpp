// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snap.h"

#include <QTest>

class SnapTest : public QObject {
    Q_OBJECT

private slots:
    void theNearestPointWins()
    {
        const std::vector<clipping::Segment> lines{{{0, 0}, {10, 0}}};
        const clipping::Window window{{-100, -100}, {100, 100}};
        using app::SnapTo;
        QCOMPARE(app::snap({1, 1}, 3, lines, window, SnapTo::All),
                 (app::Snap{{0, 0}, SnapTo::Ends}));
        QCOMPARE(app::snap({9, -1}, 3, lines, window, SnapTo::All),
                 (app::Snap{{10, 0}, SnapTo::Ends}));
        QCOMPARE(app::snap({5.5, 1}, 3, lines, window, SnapTo::All),
                 (app::Snap{{5, 0}, SnapTo::Middles}));
        QCOMPARE(app::snap({3, 5}, 3, lines, window, SnapTo::All), std::nullopt);
        QCOMPARE(app::snap({5.5, 1}, 3, lines, window, SnapTo::Ends), std::nullopt);
        QCOMPARE(app::snap({1, 1}, 3, lines, window, SnapTo::Nothing), std::nullopt);
    }
    void theWindowSnapsAlongItsEdgesAndAtItsCorners()
    {
        const clipping::Window window{{0, 0}, {100, 50}};
        using app::SnapTo;
        const auto at = [&](app::Point p) { return app::snap(p, 3, {}, window, SnapTo::All); };
        QCOMPARE(at({2, 20}), (app::Snap{{0, 20}, SnapTo::WindowEdges}));
        QCOMPARE(at({40, 52}), (app::Snap{{40, 50}, SnapTo::WindowEdges}));
        QCOMPARE(at({98, 1}), (app::Snap{{100, 0}, SnapTo::WindowEdges}));
        QCOMPARE(at({2, 60}), std::nullopt); // beyond the end of the edge
        QCOMPARE(at({50, 25}), std::nullopt);
    }
};

QTEST_APPLESS_MAIN(SnapTest)
#include "snap_test.moc"
