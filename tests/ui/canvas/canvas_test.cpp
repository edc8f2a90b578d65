// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/canvas/canvas_cases.h"

class CanvasTest : public QObject {
    Q_OBJECT

private slots:
    void isTheOneAskedFor()
    {
        Stage stage(backend);
        QCOMPARE(stage.canvas->backend(), backend);
        QVERIFY(!stage.canvas->backendReason().isEmpty());
    }
    void showsWhatIsLeftAndGhostsTheRest() { cases::showsWhatIsLeftAndGhostsTheRest(backend); }
    void everyFrameClipsEverything() { cases::everyFrameClipsEverything(backend); }
    void theWheelZoomsAroundThePointerAndBack()
    {
        cases::theWheelZoomsAroundThePointerAndBack(backend);
    }
    void wheelsAndTouchpadsPan() { cases::wheelsAndTouchpadsPan(backend); }
    void buttonsAndSpacePan() { cases::buttonsAndSpacePan(backend); }
    void keysNavigate() { cases::keysNavigate(backend); }
    void theWindowIsDrawnMovedAndResized() { cases::theWindowIsDrawnMovedAndResized(backend); }
    void theClipFollowsTheGesture() { cases::theClipFollowsTheGesture(backend); }
    void whatDiffersIsColouredAndFollowsTheGesture()
    {
        cases::whatDiffersIsColouredAndFollowsTheGesture(backend);
    }
    void withoutADisplayThereIsNoOpenGl()
    {
        if (QGuiApplication::platformName() != "offscreen")
            QSKIP("for the offscreen platform");
        Stage stage(ui::Backend::OpenGL);
        QCOMPARE(stage.canvas->backend(), ui::Backend::Raster);
    }
    // Slow pictures are painted behind the scenes; what is shown meanwhile is the last one, moved.
    void manyLinesArriveInTheEnd()
    {
        std::vector<app::Shape> shapes;
        for (int i = 0; i < 60'000; ++i)
            shapes.push_back(line({i % 200, i % 97}, {i % 200 + 3, i % 97 + 2}));
        shapes.push_back(line({100, 0}, {100, 100}));
        Stage stage(ui::Backend::Raster, shapes);
        QCOMPARE(stage.colourAt({100, 30}), QColor(0, 0, 200));
        stage.canvas->fitWindow();
        QCOMPARE(stage.colourAt({100, 30}), QColor(0, 0, 200));
        stage.session.drawing.splice(0, shapes.size(), {});
        QCOMPARE(stage.colourAt({100, 30}), QColor(Qt::white));
    }

private:
    static constexpr ui::Backend backend = ui::Backend::Raster;
};

QTEST_MAIN(CanvasTest)
#include "canvas_test.moc"
