// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace canvas_seen_test {

namespace {

void show(Stage& stage, bool overlay, std::string_view algorithm = "CS")
{
    app::Display display = stage.session.display();
    display.overlay = overlay;
    display.variant.algorithm = clipping::findAlgorithm(algorithm);
    stage.session.setDisplay(display);
}

int differing(const QImage& one, const QImage& other)
{
    int pixels = 0;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            pixels += one.pixel(x, y) != other.pixel(x, y);
    return pixels;
}

} // namespace

class SeenTest : public QObject {
    Q_OBJECT

private slots:
    void theOverlayIsShownOnlyOnRequest()
    {
        Stage stage(ui::Backend::Raster);
        const QImage before = stage.picture();
        show(stage, true);
        QVERIFY(differing(stage.picture(), before) > 1000);
        show(stage, false);
        QCOMPARE(differing(stage.picture(), before), 0);
    }

    void everyAlgorithmHasItsOwnOverlay()
    {
        Stage stage(ui::Backend::Raster, {line({10, 90}, {120, 5})});
        stage.session.inspect(0);
        const QImage plain = stage.picture();
        for (const clipping::Algorithm& algorithm : clipping::algorithms()) {
            show(stage, true, algorithm.key);
            QVERIFY2(differing(stage.picture(), plain) > 1000, algorithm.key.data());
        }
    }

    void theRegionUnderThePointerIsTinted()
    {
        Stage stage(ui::Backend::Raster, {});
        show(stage, true);
        stage.move({20, 50});
        const QColor here = stage.colourAt({8, 60}), elsewhere = stage.colourAt({180, 60});
        QCOMPARE(elsewhere, QColor(Qt::white));
        QVERIFY(here.blue() > here.red() + 5);
        stage.move({180, 50});
        QCOMPARE(stage.colourAt({8, 60}), QColor(Qt::white));
    }

    // Nicholl, Lee and Nicholl's rays turn about the first end while a line is drawn.
    void theOverlayFollowsTheDrawnLine()
    {
        Stage stage(ui::Backend::Raster, {});
        show(stage, true, "NLN");
        stage.canvas->setTool("line");
        stage.move({10, 50});
        stage.press({10, 50});
        stage.move({100, 60}, Qt::LeftButton);
        const QImage before = stage.picture();
        stage.move({190, 95}, Qt::LeftButton);
        QVERIFY(differing(stage.picture(), before) > 1000);
        stage.release({190, 95});
        QCOMPARE(stage.session.scene.lines().size(), std::size_t(1));
    }

    void eachPaneShowsItsOwnOverlay()
    {
        Stage stage(ui::Backend::Raster);
        stage.session.inspect(0);
        app::Panes panes = stage.canvas->panes();
        panes.show(2);
        stage.canvas->setPanes(panes);
        const auto surfaces = [&] {
            stage.canvas->settle();
            return std::pair(stage.canvas->paneSurface(0)->grab().toImage(),
                             stage.canvas->paneSurface(1)->grab().toImage());
        };
        app::Display display = stage.session.display();
        display.overlay = true;
        stage.session.setDisplay(display);
        const auto [one, other] = surfaces();
        QVERIFY(differing(one, other) > 1000);
    }

    // The sample "The nine regions" also writes each outcode into its region.
    void theOutcodesInTheSampleStayVisible()
    {
        const auto read =
            app::readFile(QStringLiteral(SOURCE_DIR "/resources/samples/nine-regions.svg"));
        QVERIFY2(read.value.has_value(), qPrintable(read.error));
        Stage stage(ui::Backend::Raster);
        stage.session.load(*read.value);
        const app::Containers& containers = stage.session.now().containers();
        const auto layers = containers.childrenOf(0);
        const auto layer = std::ranges::find_if(layers, [&](app::ContainerId id) {
            return containers[id].name == QStringLiteral("Outcodes");
        });
        QVERIFY(layer != layers.end());
        const app::SceneLines& lines = stage.session.scene.lines();
        for (const double zoom : {0.4, 0.7, 0.8, 0.85, 0.88}) { // the whole page
            show(stage, false);
            stage.canvas->setZoom(zoom);
            const QImage before = stage.picture();
            show(stage, true);
            const QImage after = stage.picture();
            int looked = 0;
            for (std::size_t i = 0; i < lines.size(); ++i) {
                const auto [a, b] = lines[i];
                const QPoint middle = stage.at((a + b) / 2.0);
                if (containers.layerOf(lines.objectOf(i)) != *layer
                    || !before.rect().contains(middle))
                    continue;
                ++looked;
                QVERIFY2(before.pixel(middle) == after.pixel(middle),
                         qPrintable(QStringLiteral("zoom %1, at %2, %3")
                                        .arg(zoom)
                                        .arg(middle.x())
                                        .arg(middle.y())));
            }
            QVERIFY(looked > 50);
        }
    }

    void rotatedAndConvexWindowsHaveOverlays()
    {
        const app::RectangleShape rotated{{{50, 20}, {150, 80}}, 0.4};
        const app::Subpath ring{{40, 20}, {{{160, 30}}, {{110, 90}}}, true};
        Stage stage(ui::Backend::Raster, {line({10, 90}, {120, 5})});
        stage.session.inspect(0);
        for (const app::WindowShape& shape :
             {app::WindowShape(rotated), app::WindowShape(app::PathShape{app::Path({&ring, 1})})}) {
            app::Edit edit;
            edit.windows = app::ClipWindows{{{.shape = shape}}};
            stage.session.document.apply(edit);
            for (const char* row : {"CB", "CS"}) {
                show(stage, false, row);
                const QImage plain = stage.picture();
                show(stage, true, row);
                QVERIFY2(differing(stage.picture(), plain) > 500, row);
            }
        }
    }

    void aClipWindowOutsideTheViewIsAccepted()
    {
        Stage stage(ui::Backend::Raster);
        stage.session.inspect(0);
        for (const clipping::Window& window :
             {clipping::Window{{1e6, 1e6}, {2e6, 2e6}}, clipping::Window{{-1e9, -1e9}, {1e9, 1e9}},
              clipping::Window{{50, 50}, {50, 50}}, clipping::Window{{-500, 20}, {60, 30}}})
            for (const clipping::Algorithm& algorithm : clipping::algorithms()) {
                ::setWindow(stage.session.document, window);
                show(stage, true, algorithm.key);
                QVERIFY(!stage.picture().isNull());
            }
    }
};

} // namespace canvas_seen_test

TEST_CLASS(canvas_seen_test::SeenTest, Widgets)
#include "tests/ui/canvas/seen_test.moc"
