// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/look/look.h"

#include <QThreadPool>

#include <random>

#include "tests/app/document/sheet.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/busy_threads.h"
#include "tests/test_class.h"
#include "tests/ui/canvas/canvas_cases.h"

namespace canvas_canvas_test {

class CanvasTest : public QObject {
    Q_OBJECT

private slots:
    void theRequestedBackendIsUsed()
    {
        Stage stage(backend);
        QCOMPARE(stage.canvas->backend(), backend);
        QVERIFY(!stage.canvas->backendReason().isEmpty());
    }
    void theKeptPartIsShownAndTheRestGhosted()
    {
        cases::theKeptPartIsShownAndTheRestGhosted(backend);
    }
    void everyFrameClipsEverything() { cases::everyFrameClipsEverything(backend); }
    void theWheelZoomsAroundThePointerAndBack()
    {
        cases::theWheelZoomsAroundThePointerAndBack(backend);
    }
    void wheelsAndTouchpadsPan() { cases::wheelsAndTouchpadsPan(backend); }
    void buttonsAndSpacePan() { cases::buttonsAndSpacePan(backend); }
    void keysNavigate() { cases::keysNavigate(backend); }
    void theClipWindowIsDrawnMovedAndResized()
    {
        cases::theClipWindowIsDrawnMovedAndResized(backend);
    }
    void theClipFollowsTheGesture() { cases::theClipFollowsTheGesture(backend); }
    void differencesAreColouredAndFollowTheGesture()
    {
        cases::differencesAreColouredAndFollowTheGesture(backend);
    }
    void withoutADisplayThereIsNoOpenGl()
    {
        if (QGuiApplication::platformName() != "offscreen")
            QSKIP("for the offscreen platform");
        Stage stage(ui::Backend::OpenGL);
        QCOMPARE(stage.canvas->backend(), ui::Backend::Raster);
    }
    // Slow pictures are painted on other threads; meanwhile the last picture is shown, moved.
    void manyLinesAreEventuallyPainted()
    {
        std::vector<app::Shape> shapes;
        for (int i = 0; i < 60'000; ++i)
            shapes.push_back(line({i % 200, i % 97}, {i % 200 + 3, i % 97 + 2}));
        shapes.push_back(line({100, 0}, {100, 100}));
        Stage stage(ui::Backend::Raster, shapes);
        QCOMPARE(stage.colourAt({100, 30}), QColor(0, 0, 200));
        stage.canvas->fitWindow();
        QCOMPARE(stage.colourAt({100, 30}), QColor(0, 0, 200));
        ::splice(stage.session.document, 0, shapes.size(), {});
        QCOMPARE(stage.colourAt({100, 30}), QColor(Qt::white));
    }
    // The wheel comes before the first picture of a large drawing, after an empty page was painted
    // in no time.
    void aLargeDrawingIsNeverPaintedAtOnce()
    {
        Stage stage(ui::Backend::Raster, {});
        stage.canvas->settle();
        bool painting = false;
        connect(stage.canvas.get(), &ui::Canvas::frameShown,
                [&](const app::FrameTimes& times) { painting = times.painting; });
        ::splice(stage.session.document, 0, 0, longLines(60'000));
        stage.canvas->repaint();
        stage.surface().repaint();
        QVERIFY(painting);
        stage.wheel({300, 222}, {0, 120});
        stage.surface().repaint();
        QVERIFY(painting);
        stage.canvas->fitPage();
        stage.surface().repaint();
        QVERIFY(painting);
    }
    // However long the next frame takes: the outline is that of the cut that is shown.
    void theOutlineStaysWithTheCut()
    {
        Stage stage(ui::Backend::Raster, longLines(60'000));
        const auto windowAt = [&](double x) {
            stage.session.document.apply(
                {.windows =
                     app::ClipWindows{{{.shape = app::RectangleShape{{{x, 20}, {190, 80}}}}}}});
        };
        const auto isOutlined = [](const QImage& image, QPoint at) {
            const QColor accent = ui::lookOnPaper(false).accent;
            int nearest = 255;
            for (int x = at.x() - 2; x <= at.x() + 2; ++x) {
                const QColor c = image.pixelColor(x, at.y());
                nearest = std::min(nearest, std::max({std::abs(c.red() - accent.red()),
                                                      std::abs(c.green() - accent.green()),
                                                      std::abs(c.blue() - accent.blue())}));
            }
            return nearest < 100;
        };
        windowAt(50);
        QImage image = stage.picture();
        QVERIFY(isOutlined(image, stage.at({50, 35})) && !isOutlined(image, stage.at({120, 35})));
        {
            const BusyThreads busy;
            windowAt(120);
            image = stage.surface().grab().toImage();
            QVERIFY(isOutlined(image, stage.at({50, 35})));
            QVERIFY(!isOutlined(image, stage.at({120, 35})));
        }
        image = stage.picture();
        QVERIFY(!isOutlined(image, stage.at({50, 35})) && isOutlined(image, stage.at({120, 35})));
    }
    // Its edges cross one another a million times.
    void aWindowThatCrossesItselfIsNeverCutAtOnce()
    {
        app::Shape area = line({20, 10}, {180, 15});
        area.paths.front() = {{20, 10}, {{{180, 10}}, {{180, 90}}, {{20, 90}}}, true};
        area.style.fill = app::Colour{200, 0, 0};
        Stage stage(ui::Backend::Raster, {area});
        stage.canvas->settle();
        bool painting = false;
        connect(stage.canvas.get(), &ui::Canvas::frameShown,
                [&](const app::FrameTimes& times) { painting = times.painting; });
        const app::Path star(scribble(2000).paths);
        stage.session.document.apply(
            {.windows = app::ClipWindows{{{.shape = app::PathShape{star}}}}});
        stage.surface().repaint();
        QVERIFY(painting);
        stage.canvas.reset(); // waits for nothing
        QVERIFY(app::paintingThreads().waitForDone(60'000));
    }
    // Painted in one piece it would take minutes, longer than a test may take; so would waiting
    // for it when the canvas is destroyed.
    void aSelfCrossingStrokeNeverBlocksTheCanvas()
    {
        Stage stage(ui::Backend::Raster);
        bool painting = false;
        int frames = 0;
        connect(stage.canvas.get(), &ui::Canvas::frameShown, [&](const app::FrameTimes& times) {
            painting = times.painting;
            ++frames;
        });
        ::splice(stage.session.document, 0, 1, {scribble(100'000)});
        QTRY_VERIFY(frames > 0);
        QVERIFY(painting);
        QTRY_VERIFY_WITH_TIMEOUT(!painting, 120'000);
        QCOMPARE(stage.colourAt({100, 50}), QColor(0, 0, 200));
        for (int i = 0; i < 3;
             ++i) { // and cancelled: here, where it is painted, and while it waits
            stage.canvas->zoomBy(1.5);
            frames = 0;
            QTRY_VERIFY(frames > 0);
            QVERIFY(painting);
            if (i == 0)
                stage.session.load({stage.session.now(), {}});
        }
        stage.canvas.reset();
        QVERIFY(app::paintingThreads().waitForDone(120'000));
    }

private:
    static std::vector<app::Shape> longLines(int count)
    {
        std::mt19937 random(2);
        const auto point = [&] { return app::Point(random() % 2000, random() % 1000) / 10.0; };
        std::vector<app::Shape> lines;
        while (count-- > 0)
            lines.push_back(line(point(), point()));
        return lines;
    }
    static app::Shape scribble(int points)
    {
        std::mt19937 random(3);
        const auto below = [&](int most) { return double(random() % unsigned(most * 100)) / 100; };
        app::Shape shape = line({below(200), below(100)}, {below(200), below(100)});
        while (points-- > 0)
            shape.paths.front().segments.push_back({{below(200), below(100)}});
        return shape;
    }
    static constexpr ui::Backend backend = ui::Backend::Raster;
};

} // namespace canvas_canvas_test

TEST_CLASS(canvas_canvas_test::CanvasTest, Widgets)
#include "tests/ui/canvas/canvas_test.moc"
