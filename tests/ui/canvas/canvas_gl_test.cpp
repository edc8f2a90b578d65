// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "tests/test_class.h"
#include "tests/ui/canvas/canvas_cases.h"

namespace canvas_canvas_gl_test {

class CanvasGlTest : public QObject {
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
    // At the other end the window cuts it.
    void aCutStrokeKeepsTheCapOfItsOwnEnd()
    {
        app::Shape bent;
        bent.paths = {{{70, 50}, {{{100, 70}}, {{190, 50}}}, false}};
        bent.style.stroke = app::Colour{0, 0, 200, 128};
        bent.style.width = 12;
        bent.style.cap = app::Cap::Round;
        Stage stage(backend, {bent});
        stage.session.changeDisplay(
            [](app::Display& display) { display.removed = app::RemovedPart::Hidden; });
        QVERIFY(stage.colourAt({67, 48}).red() < 200);
        QCOMPARE(stage.colourAt({60, 45}), QColor(Qt::white));
    }
    void softwareOpenGlIsNotChosenByItself()
    {
        Stage stage(ui::Backend::Automatic);
        QCOMPARE(stage.canvas->backend(), ui::Backend::Raster);
        QVERIFY(stage.canvas->backendReason().contains("llvmpipe"));
    }
    void bothCanvasesPaintTheSame_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("most"); // mean difference of a channel, of 255
        const QString samples = QStringLiteral(SOURCE_DIR "/resources/samples/");
        QTest::newRow("strokes and areas")
            << QStringLiteral(SOURCE_DIR "/tests/ui/canvas/styles.svg") << 1.5;
        QTest::newRow("rosette") << samples + "rosette.svg" << 4.0;
        QTest::newRow("random lines") << samples + "random-lines.svg" << 6.0;
    }
    void bothCanvasesPaintTheSame()
    {
        QFETCH(QString, file);
        QFETCH(double, most);
        QImage pictures[2];
        for (const ui::Backend which : {ui::Backend::Raster, ui::Backend::OpenGL}) {
            Stage stage(which);
            auto read = app::readFile(file);
            QVERIFY2(bool(read), qPrintable(read.error));
            stage.session.load(std::move(*read.value), file);
            stage.session.select({0});
            pictures[which == ui::Backend::OpenGL] =
                stage.picture().convertToFormat(QImage::Format_RGB32);
        }
        QCOMPARE(pictures[0].size(), pictures[1].size());
        double sum = 0;
        for (int y = 0; y < pictures[0].height(); ++y)
            for (int x = 0; x < pictures[0].width(); ++x) {
                const QRgb a = pictures[0].pixel(x, y), b = pictures[1].pixel(x, y);
                sum += std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b))
                       + std::abs(qBlue(a) - qBlue(b));
            }
        const double mean = sum / (3.0 * pictures[0].width() * pictures[0].height());
        qInfo("%s: mean difference %.2f of 255", QTest::currentDataTag(), mean);
        QVERIFY(mean < most);
    }
    // The same image, painted by the processor: of a million lines that takes less time than to
    // make and send what a card would paint.
    void aLargeDrawingIsTheSameImage()
    {
        std::mt19937 random(3);
        const auto point = [&] { return app::Point(random() % 200, random() % 100); };
        std::vector<app::Shape> lines;
        for (int i = 0; i < 30'000; ++i) {
            const bool isInCrowd = i % 100 != 0;
            lines.push_back(isInCrowd ? line({199, 99}, {200, 98}) : line(point(), point()));
            lines.back().style.width = 0.3;
        }
        const app::ClipWindows windows{{{.shape = app::RectangleShape{{{60, 20}, {150, 80}}}}}};
        QImage pictures[2];
        QRect kept, removed; // without outline and handles, which OpenGL draws
        for (const ui::Backend which : {ui::Backend::Raster, ui::Backend::OpenGL}) {
            Stage stage(which, lines);
            stage.session.document.apply({.windows = windows});
            stage.canvas->settle();
            stage.drag({-25, -25}, {-15, -30}, Qt::MiddleButton);
            pictures[which == ui::Backend::OpenGL] =
                stage.picture().convertToFormat(QImage::Format_RGB32);
            kept = {stage.at({65, 25}), stage.at({145, 75})};
            removed = {stage.at({2, 2}), stage.at({50, 98})};
        }
        for (const QRect& part : {kept, removed})
            QCOMPARE(pictures[1].copy(part), pictures[0].copy(part));
        QVERIFY(pictures[0].copy(kept) != pictures[0].copy(kept.translated(1, 0)));
    }

private:
    static constexpr ui::Backend backend = ui::Backend::OpenGL;
};

} // namespace canvas_canvas_gl_test

TEST_CLASS(canvas_canvas_gl_test::CanvasGlTest, Widgets)
#include "tests/ui/canvas/canvas_gl_test.moc"
