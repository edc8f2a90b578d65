// SPDX-License-Identifier: GPL-3.0-or-later
// Each pane is an OpenGL widget of its own; panes share only the main window.
#include "tests/test_class.h"
#include "tests/ui/canvas/pane_stage.h"

namespace canvas_panes_gl_test {

class PanesGlTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { ui::applyTheme(*qApp, ui::Theme::Light); }

    void panesAgreeDuringAGesture()
    {
        PaneStage stage(4, ui::Backend::OpenGL);
        QCOMPARE(stage.canvas->backend(), ui::Backend::OpenGL);
        stage.canvas->setTool("window");
        stage.canvas->activatePane(2);
        const QRect before = stage.orange(1);
        QVERIFY(before.width() > 40);
        const QPointF from = stage.at({100, 50}), by(16, 12);
        stage.send(2, QEvent::MouseButtonPress, from, Qt::LeftButton);
        stage.send(2, QEvent::MouseMove, from + by / 2, Qt::LeftButton);
        stage.send(2, QEvent::MouseMove, from + by, Qt::LeftButton);
        QCOMPARE(stage.orange(0).center(),
                 before.center() + by.toPoint()); // highlighted: it is thicker
        QCOMPARE(stage.orange(1), stage.orange(0));
        QCOMPARE(stage.orange(3), stage.orange(0));
        QCOMPARE(stage.shot(1), stage.shot(3)); // two corrected forms
        QVERIFY(stage.shot(1) != stage.shot(2));
        stage.send(2, QEvent::MouseButtonRelease, from + by, Qt::LeftButton);
        QCOMPARE(stage.session.history.count(), 1);
    }
    void panesAreAddedAndRemoved()
    {
        PaneStage stage(1, ui::Backend::OpenGL);
        const QImage alone = stage.shot(0);
        for (const std::size_t count : {4, 12, 2, 1, 12, 1})
            stage.show(count);
        QCOMPARE(stage.shot(0), alone);
    }
};

} // namespace canvas_panes_gl_test

TEST_CLASS(canvas_panes_gl_test::PanesGlTest, Widgets)
#include "tests/ui/canvas/panes_gl_test.moc"
