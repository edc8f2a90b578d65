// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/words.h"
#include "ui/docks/cost_map_panel.h"

#include <QSignalSpy>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace docks_cost_map_panel_test {

using namespace ui;

namespace {

constexpr clipping::Window window{{0, 0}, {40, 30}};

struct Stage {
    Stage()
    {
        applyTheme(*qApp, Theme::Light);
        ::setWindow(session.document, window);
        panel.resize(572, 560);
        const auto boxes = panel.findChildren<QComboBox*>();
        algorithm = boxes[0];
        measure = boxes[1];
    }
    void show()
    {
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QTRY_VERIFY(panel.live().upToDate());
    }
    QPoint pixelOf(const app::Point& point)
    {
        return app::onMap(*panel.live().asked(), view().place(), point).toPoint();
    }
    CostMapView& view() { return panel.view(); }

    app::Session session;
    CostMapPanel panel{session};
    QComboBox *algorithm, *measure;
};

} // namespace

class CostMapPanelTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsComputedWhileItIsHidden()
    {
        Stage stage;
        QVERIFY(!stage.panel.live().asked());
        ::setWindow(stage.session.document, {{0, 0}, {1, 1}});
        QTest::qWait(20);
        stage.algorithm->setCurrentIndex(0);
        QVERIFY(!stage.panel.live().asked() && !stage.panel.live().map());
        stage.show();
        QVERIFY(stage.panel.live().map());
        stage.panel.hide();
        QVERIFY(!stage.panel.live().asked() && !stage.panel.live().map());
    }

    void theFixedEndFollowsTheMouse()
    {
        Stage stage;
        stage.show();
        const QPoint from = stage.pixelOf(stage.panel.live().asked()->fixed);
        const QPoint to = stage.pixelOf({20, 15});
        QTest::mousePress(&stage.view(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&stage.view(), to);
        QVERIFY(stage.panel.live().map() && stage.panel.live().map()->complete());
        // While dragging, each position soon has a map: at once if it takes less than a slice.
        QTRY_COMPARE(stage.panel.live().map()->plan.fixed, stage.panel.live().asked()->fixed);
        QTest::mouseRelease(&stage.view(), Qt::LeftButton, {}, to);
        const app::Point fixed = stage.panel.live().asked()->fixed;
        QVERIFY(std::abs(fixed.x - 20) < 0.5 && std::abs(fixed.y - 15) < 0.5);
        QTRY_VERIFY(stage.panel.live().upToDate());
        QCOMPARE(stage.panel.live().map()->values,
                 app::costMap(*stage.panel.live().asked()).values);
    }

    void arrowKeysMoveTheFixedEnd()
    {
        Stage stage;
        stage.show();
        stage.view().setFocus();
        const app::Point before = stage.panel.live().asked()->fixed;
        QTest::keyClick(&stage.view(), Qt::Key_Right);
        const double step = stage.panel.live().asked()->fixed.x - before.x;
        QVERIFY(step > 0);
        QTest::keyClick(&stage.view(), Qt::Key_Up, Qt::ShiftModifier);
        const double far = before.y - stage.panel.live().asked()->fixed.y;
        QVERIFY(far > 5 * step);
        for (int i = 0; i < 30; ++i)
            QTest::keyClick(&stage.view(), Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(stage.panel.live().asked()->fixed.x, stage.panel.live().asked()->area.min.x);
    }

    void theCostUnderThePointerIsShown()
    {
        Stage stage;
        stage.show();
        const QPoint pixel = stage.pixelOf({20, 15});
        QTest::mouseMove(&stage.view(), pixel);
        const app::Point point =
            app::onPlane(*stage.panel.live().asked(), stage.view().place(), pixel);
        QCOMPARE(stage.panel.words(), app::costWords(*stage.panel.live().asked(), point));
        QVERIFY(stage.panel.words().startsWith("24 operations here; cheapest: "));
    }

    void everyChoiceShowsAMap()
    {
        Stage stage;
        stage.show();
        for (int row = 0; row < stage.algorithm->count(); ++row)
            for (int measure = 0; measure < stage.measure->count() - 1; ++measure) {
                stage.measure->setCurrentIndex(measure);
                stage.algorithm->setCurrentIndex(row);
                QVERIFY(stage.panel.live().asked()->measure
                        == &app::costMeasures()[std::size_t(measure)]);
                QVERIFY(stage.panel.live().map());
            }
    }

    void theMapIsExported()
    {
        TestWindow test;
        test.show();
        CostMapPanel& panel = test.window->costMapPanel();
        auto prepared = std::make_unique<PreparedAnswers>(panel);
        prepared->save = test.path("map.csv");
        panel.setQuestions(std::move(prepared));
        test.action("cost-map")->trigger();
        QVERIFY(test.window->showsPanel("cost-map"));
        panel.findChild<QAction*>("export-cost-map-csv")->trigger();
        QFile file(test.path("map.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readLine().startsWith("x,y,operations,"));
        QVERIFY(!panel.exportTo(test.path("map.png")));
        QVERIFY(!QImage(test.path("map.png")).isNull());
        QVERIFY(panel.exportTo("/nowhere/at/all.png"));
        test.action("cost-map")->trigger();
        QVERIFY(!panel.live().asked());
    }

    void aFailedExportIsAWarning()
    {
        Stage stage;
        auto prepared = std::make_unique<PreparedAnswers>(stage.panel);
        PreparedAnswers& answers = *prepared;
        stage.panel.setQuestions(std::move(prepared));
        Message message;
        connect(&stage.panel, &CostMapPanel::told, this,
                [&](const Message& told) { message = told; });
        QAction& exportCsv = *stage.panel.findChild<QAction*>("export-cost-map-csv");
        answers.save = "/nowhere/at/all.csv";
        exportCsv.trigger();
        QVERIFY(message.kind == Message::Kind::Warning);
        QVERIFY2(message.sentence.contains("/nowhere/at/all.csv"), qPrintable(message.sentence));
        const QTemporaryDir folder;
        answers.save = folder.filePath("map.csv");
        exportCsv.trigger();
        QVERIFY(message.kind == Message::Kind::Done);
        QCOMPARE(message.sentence, "Wrote " + answers.save + ".");
    }

    void theFixedEndKeepsItsPlaceRelativeToTheWindow()
    {
        Stage stage;
        stage.show();
        const app::CostPlan before = *stage.panel.live().asked();
        const app::Point by(7, 5);
        stage.session.setPreview({.windows = withWindow(stage.session.now().windows(),
                                                        {window.min + by, window.max + by})});
        QCOMPARE(stage.panel.live().asked()->window, window); // the frame comes first
        QTRY_COMPARE(stage.panel.live().asked()->window, stage.session.window());
        QVERIFY(glm::distance(stage.panel.live().asked()->fixed, before.fixed + by) < 1e-9);
        stage.session.setPreview({});
        QTemporaryDir folder;
        QVERIFY(!stage.panel.exportTo(folder.filePath("map.csv")));
        QCOMPARE(stage.panel.live().asked()->window, window); // not the earlier one
    }

    void theMapFollowsTheDrawingsClipWindow()
    {
        TestWindow test;
        test.show();
        QTest::keyClick(test.window.get(), Qt::Key_F2, Qt::ShiftModifier);
        CostMapPanel& panel = test.window->costMapPanel();
        QTRY_VERIFY(panel.live().asked());
        test.open(test.twoLines());
        QTRY_COMPARE(panel.live().asked()->window, test.window->session().window());
    }
};

} // namespace docks_cost_map_panel_test

TEST_CLASS(docks_cost_map_panel_test::CostMapPanelTest, Widgets)
#include "tests/ui/docks/cost_map_panel_test.moc"
