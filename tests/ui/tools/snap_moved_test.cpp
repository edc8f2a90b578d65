// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look.h"

#include <glm/geometric.hpp>

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace tools_snap_moved_test {

// Objects and windows that are dragged snap by their own points.
class SnapMovedTest : public QObject {
    Q_OBJECT

    /// A canvas where nothing else is near; ends and alignment are on.
    struct Hand : Stage {
        explicit Hand(const char* kinds)
            : Stage(ui::Backend::Raster, {line({20, 10}, {40, 10}), line({100, 90}, {160, 90.4})})
        {
            app::SnapTo to = app::SnapTo::Nothing;
            for (const QString& kind : QString(kinds).split(u' '))
                to = to.with(kind.toStdString());
            canvas->setSnapping(to);
        }
        clipping::Segment first() const { return session.scene.lines()[0]; }
    };

private slots:
    void anObjectSnapsByItsEndWhereverItWasGrabbed()
    {
        Hand hand("ends");
        hand.drag({27, 10}, {86, 89}); // its right end comes to (99, 89)
        QVERIFY(glm::distance(hand.first().b, app::Point(100, 90)) < 1e-9);
        QVERIFY(glm::distance(hand.first().a, app::Point(80, 90)) < 1e-9);
        QCOMPARE(hand.session.history.count(), 1);
    }
    void ctrlSuspendsSnapping()
    {
        Hand hand("ends");
        hand.drag({27, 10}, {86, 89}, Qt::LeftButton, Qt::ControlModifier);
        QVERIFY(near(hand.first().b, {99, 89}));
        QVERIFY(glm::distance(hand.first().b, app::Point(100, 90)) > 0.4);
    }
    void anObjectIsAlignedWithAnother()
    {
        Hand hand("alignment");
        hand.drag({27, 10}, {108.5, 50}); // its left end comes to 101.5
        QCOMPARE(hand.first().a.x, 100.0);
        QVERIFY(near(hand.first().a, {100, 50}));
    }
    void theGuideIsShownWhileItIsDragged()
    {
        Hand hand("alignment");
        const QColor ground = ui::lookOf(hand.canvas->palette()).guideGround;
        const auto shown = [&] {
            const QImage picture = hand.picture();
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    if (picture.pixelColor(x, y) == ground)
                        return true;
            return false;
        };
        hand.move({27, 10});
        hand.press({27, 10});
        hand.move({80, 30}, Qt::LeftButton);
        QVERIFY(!shown());
        hand.move({108.5, 50}, Qt::LeftButton);
        QVERIFY(shown()); // the distance
        hand.release({108.5, 50});
        QVERIFY(!shown());
    }
    void aHandleOfAWindowSnapsWithBothTools()
    {
        for (const char* tool : {"window", "select"}) {
            Hand hand("ends");
            hand.canvas->setTool(tool);
            hand.drag({150, 80}, {158.5, 89});
            const auto window = hand.session.clipWindow();
            QVERIFY2(window && glm::distance(window->max, app::Point(160, 90.4)) < 1e-9, tool);
            hand.session.history.undo();
            hand.drag({150, 80}, {158.5, 89}, Qt::LeftButton, Qt::ControlModifier);
            QVERIFY(near(hand.session.clipWindow()->max, {158.5, 89}, 0.6));
            QVERIFY(glm::distance(hand.session.clipWindow()->max, app::Point(160, 90.4)) > 0.5);
        }
    }
    void aWindowSnapsByItsCorner()
    {
        for (const char* tool : {"window", "select"}) {
            Hand hand("ends");
            hand.canvas->setTool(tool);
            // The outline between two handles; the corner (150, 80) comes to (158, 89).
            hand.drag({75, 20}, {83, 29});
            const auto window = hand.session.clipWindow();
            QVERIFY2(window && glm::distance(window->max, app::Point(160, 90.4)) < 1e-9, tool);
            QVERIFY(near(window->max - window->min, {100, 60}, 1e-9));
        }
    }
};

} // namespace tools_snap_moved_test

TEST_CLASS(tools_snap_moved_test::SnapMovedTest, Widgets)
#include "tests/ui/tools/snap_moved_test.moc"
