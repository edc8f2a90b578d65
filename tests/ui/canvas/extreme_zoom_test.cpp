// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool.h"

#include <QElapsedTimer>

#include <cmath>

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace canvas_extreme_zoom_test {

// The canvas at the smallest and the largest zoom: everything is painted in time, and every number
// stays finite.
class ExtremeZoomTest : public QObject {
    Q_OBJECT

    static constexpr double least = 1e-9, most = 1e9; // pixels per unit
    static constexpr int longest = 5000;              // milliseconds, on a busy machine

    struct Everything : Stage {
        Everything() : Stage(ui::Backend::Raster, shapes())
        {
            auto display = session.display();
            display.grid.shown = true;
            display.overlay = true;
            session.setDisplay(display);
            session.select({0, 1});
            session.inspect(0);
        }
        static std::vector<app::Shape> shapes()
        {
            app::Shape dashed = line({10, 50}, {190, 51});
            dashed.style.dashes = {3, 1};
            app::Shape area = line({20, 20}, {80, 20});
            area.paths[0] = {{20, 20}, {{{80, 20}}, {{50, 70}, {90, 30}, {60, 60}, true}}, true};
            area.style.fill = app::Colour{200, 220, 240};
            return {dashed, area, line({-3, -4}, {5, 6})};
        }
        void zoomTo(double zoom, app::Point centre)
        {
            app::View view = canvas->view();
            view.zoom = zoom;
            view.centre = centre;
            canvas->go(view);
        }
        bool isFinite() const
        {
            for (const app::Shape& shape : sheetOf(session.now()).shapes)
                for (const app::Subpath& path : shape.paths)
                    for (const app::PathSegment& s : path.segments)
                        if (!std::isfinite(path.start.x + path.start.y + s.to.x + s.to.y))
                            return false;
            return true;
        }
    };

private slots:
    void everythingIsPainted_data()
    {
        QTest::addColumn<double>("zoom");
        QTest::addColumn<QPointF>("centre");
        QTest::newRow("far away") << least << QPointF(100, 50);
        QTest::newRow("close, on a line") << most << QPointF(10, 50);
        QTest::newRow("close, in an area") << most << QPointF(50, 30);
        QTest::newRow("close, far from the page") << most << QPointF(1e6, -1e6);
    }
    void everythingIsPainted()
    {
        QFETCH(double, zoom);
        QFETCH(QPointF, centre);
        Everything stage;
        stage.zoomTo(zoom, {centre.x(), centre.y()});
        QCOMPARE(stage.canvas->view().zoom, zoom);
        QElapsedTimer clock;
        clock.start();
        const QImage picture = stage.canvas->grab().toImage();
        QVERIFY(!picture.isNull());
        QVERIFY(!stage.picture().isNull());
        QVERIFY2(clock.elapsed() < longest, qPrintable(QString::number(clock.elapsed())));
    }
    void everyToolDraws()
    {
        for (const double zoom : {least, most})
            for (const ui::ToolInfo& tool : ui::tools()) {
                Everything stage;
                stage.zoomTo(zoom, {20, 20});
                stage.canvas->setTool(tool.key);
                const app::Point centre = stage.canvas->view().centre;
                const auto place = [&](double x, double y) {
                    return centre + app::Point(x, y) / zoom;
                };
                QElapsedTimer clock;
                clock.start();
                stage.drag(place(-90, -60), place(80, 70));
                stage.move(place(30, 90));
                stage.canvas->grab();
                QVERIFY2(clock.elapsed() < longest, tool.key.data());
                QVERIFY2(stage.isFinite(), tool.key.data());
            }
    }
    void theWheelEndsAtTheLimits()
    {
        Everything stage;
        for (const auto& [turn, limit] : {std::pair{-1200, least}, std::pair{1200, most}}) {
            for (int i = 0; i < 100; ++i)
                stage.wheel({400, 300}, {0, turn}, Qt::ControlModifier);
            QCOMPARE(stage.canvas->view().zoom, limit);
            const app::Point centre = stage.canvas->view().centre;
            QVERIFY(std::isfinite(centre.x) && std::isfinite(centre.y));
        }
        stage.canvas->fitPage(); // and back
        QVERIFY(stage.canvas->view().zoom > 0.1 && stage.canvas->view().zoom < 100);
    }
};

} // namespace canvas_extreme_zoom_test

TEST_CLASS(canvas_extreme_zoom_test::ExtremeZoomTest, Widgets)
#include "tests/ui/canvas/extreme_zoom_test.moc"
