// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look.h"

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace canvas_grid_test {

// The grid under the drawing; a unit is a CSS pixel, and 25.4 mm are 96 units.
class GridTest : public QObject {
    Q_OBJECT

    struct Hand : Stage {
        explicit Hand(const app::Grid& grid)
            : Stage(ui::Backend::Raster, {line({10, 50}, {190, 50})})
        {
            session.changeDisplay([&](app::Display& display) { display.grid = grid; });
        }
    };
    static constexpr double quarterInch = 25.4 / 4; // 24 units

private slots:
    void linesArePaintedOnThePageUnderTheDrawing()
    {
        Hand hand({.shown = true, .spacing = quarterInch});
        const ui::Look& look = ui::lookOf(hand.canvas->palette());
        const QImage picture = hand.picture();
        const auto at = [&](app::Point p) {
            const app::Point s = hand.canvas->view().toScreen(p);
            return picture.pixelColor(int(std::floor(s.x)), int(std::floor(s.y)));
        };
        QCOMPARE(at({24, 40}), look.grid);
        QCOMPARE(at({120, 40}), look.gridMajor);
        QCOMPARE(at({30, 40}), look.paper);
        QCOMPARE(at({-24, 40}), look.canvas);
        QVERIFY(at({24, 50}) != look.grid); // under the line
    }
    void aHiddenGridIsNotPaintedAndNotSnappedTo()
    {
        Hand hand({.spacing = quarterInch});
        QCOMPARE(hand.colourAt({24, 40}), ui::lookOf(hand.canvas->palette()).paper);
        hand.canvas->setTool("line");
        hand.drag({25, 39}, {70, 97}, Qt::LeftButton);
        const auto lines = hand.session.scene.lines();
        QVERIFY(lines[1].a != app::Point(24, 48));
    }
    void drawnPointsSnapToTheGridAndRatherToTheDrawing()
    {
        Hand hand({.shown = true, .spacing = quarterInch});
        hand.canvas->setTool("line");
        hand.drag({25, 25}, {71, 71});
        hand.drag({11, 51}, {95, 71});
        const auto lines = hand.session.scene.lines();
        QCOMPARE(lines.size(), std::size_t(3));
        QCOMPARE(lines[1].a, app::Point(24, 24));
        QCOMPARE(lines[1].b, app::Point(72, 72));
        QCOMPARE(lines[2].a, app::Point(10, 50)); // the line's end
        QCOMPARE(lines[2].b, app::Point(96, 72));
    }
    void dotsArePaintedToo()
    {
        Hand hand({.shown = true, .spacing = quarterInch, .marks = app::Grid::Marks::Dots});
        const ui::Look& look = ui::lookOf(hand.canvas->palette());
        const QImage picture = hand.picture();
        const QPoint dot = hand.at({24, 24});
        bool found = false;
        for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x)
                found |= picture.pixelColor(dot + QPoint(x, y)) == look.border;
        QVERIFY(found);
        QCOMPARE(picture.pixelColor(hand.at({24, 36})), look.paper);
    }
};

} // namespace canvas_grid_test

TEST_CLASS(canvas_grid_test::GridTest, Widgets)
#include "tests/ui/canvas/grid_test.moc"
