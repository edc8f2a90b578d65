// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/status_bar.h"
#include "ui/docks/start_panel.h"
#include "ui/lessons/choice_list.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/microscope/microscope_page.h"

#include <QDockWidget>
#include <QToolBar>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace teaching_test {

namespace {

struct Stage : ui::TestWindow {
    Stage()
    {
        show();
        open(twoLines());
        QCoreApplication::processEvents();
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QWidget* focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : window.get(), key, modifiers);
        QCoreApplication::processEvents();
    }
    QStringList shownDocks() const
    {
        QStringList names;
        for (const auto* dock : window->findChildren<QDockWidget*>())
            if (!dock->isHidden())
                names << dock->objectName();
        names.sort();
        return names;
    }
    app::Course& course() { return window->session().course; }
};

} // namespace

class TeachingTest : public QObject {
    Q_OBJECT

private slots:
    void f11StartsAndEndsPresentation()
    {
        Stage stage;
        const QStringList docks = stage.shownDocks();
        const double type = stage.window->canvas().font().pointSizeF();
        QVERIFY(!docks.isEmpty());
        stage.press(Qt::Key_F11);
        QVERIFY(stage.window->isPresenting() && stage.window->isFullScreen());
        QCOMPARE(stage.shownDocks(), QStringList());
        QVERIFY(std::abs(stage.window->canvas().font().pointSizeF() / type - 1.5) < 0.01);
        for (const auto* label : stage.window->status().findChildren<QLabel*>())
            QVERIFY(label->font().pointSizeF() > type);
        stage.press(Qt::Key_F11);
        QVERIFY(!stage.window->isPresenting() && !stage.window->isFullScreen());
        QCOMPARE(stage.shownDocks(), docks);
        QCOMPARE(stage.window->canvas().font().pointSizeF(), type);
    }
    void theMicroscopeFollowsPresentation()
    {
        Stage stage;
        const QStringList docks = stage.shownDocks();
        stage.press(Qt::Key_F2);
        stage.press(Qt::Key_Right);
        const std::size_t step = stage.window->session().microscope.step();
        const double type = stage.window->microscopePage()->font().pointSizeF();
        stage.press(Qt::Key_F11);
        QVERIFY(stage.window->microscopePage()->isVisible());
        QVERIFY(stage.window->microscopePage()->font().pointSizeF() > 1.4 * type);
        QCOMPARE(stage.window->session().microscope.step(), step);
        stage.press(Qt::Key_F2); // the canvas, still presented
        QCOMPARE(stage.shownDocks(), QStringList());
        stage.press(Qt::Key_F11);
        QCOMPARE(stage.shownDocks(), docks);
    }
    void aPresentedLayoutIsNotSaved()
    {
        Stage stage;
        const QStringList docks = stage.shownDocks();
        stage.press(Qt::Key_F11);
        stage.window->close();
        const QFont type = QApplication::font();
        const auto next = ui::windowWithMenus();
        next->resize(1280, 800);
        next->show();
        QStringList names;
        for (const auto* dock : next->findChildren<QDockWidget*>())
            if (!dock->isHidden())
                names << dock->objectName();
        QVERIFY(names.contains("algorithm"));
        QVERIFY(!next->isPresenting());
        stage.window.reset();
        QVERIFY(QApplication::font().pointSizeF() < type.pointSizeF()); // it goes with its window
    }
    void aLessonPlaysToItsEndByKeysInTheWindow()
    {
        Stage stage;
        stage.press(Qt::Key_F1, Qt::ControlModifier);
        QVERIFY(stage.window->showsLessons());
        QVERIFY(stage.window->session().microscope.isOpen());
        stage.press(Qt::Key_Space); // the first lesson has the focus
        QVERIFY(stage.course().lesson());
        const QString key = stage.course().lesson()->key;
        for (int presses = 0; presses < 100 && !stage.course().atLastPage(); ++presses) {
            stage.press(Qt::Key_End); // the microscope's keys work meanwhile
            QVERIFY(stage.window->session().microscope.atEnd());
            for (int tries = 0; tries < 2 && stage.course().isOpen(); ++tries)
                stage.press(Qt::Key_Return);
            QVERIFY(!stage.course().isOpen());
            stage.press(Qt::Key_PageDown);
        }
        QCOMPARE(stage.course().lesson()->key, key);
        QVERIFY(stage.course().atLastPage());
    }
    void lessonsCloseWithTheMicroscope()
    {
        Stage stage;
        const QStringList docks = stage.shownDocks();
        stage.press(Qt::Key_F1, Qt::ControlModifier);
        stage.course().begin(2);
        stage.window->session().microscope.close();
        QVERIFY(!stage.window->showsLessons());
        QVERIFY(!stage.course().lesson());
        QCOMPARE(stage.shownDocks(), docks);
    }
    void theStartPanelOpensTheFirstLesson()
    {
        Stage stage;
        emit stage.window->findChild<ui::StartPanel*>()->lessonWanted();
        QVERIFY(stage.window->showsLessons());
        QCOMPARE(stage.course().lesson()->key, app::lessons().front().key);
        QVERIFY(stage.window->findChild<ui::LessonPanel*>()->isVisible());
    }
    void aLessonContinuesWhilePresenting()
    {
        Stage stage;
        stage.press(Qt::Key_F1, Qt::ControlModifier);
        stage.course().begin(1);
        stage.course().showAnswer();
        stage.course().next();
        stage.press(Qt::Key_F11);
        QVERIFY(stage.window->showsLessons());
        QCOMPARE(stage.course().page(), 1U);
        QVERIFY(stage.window->findChild<ui::LessonPanel*>()->isVisible());
        stage.press(Qt::Key_F11);
        QCOMPARE(stage.course().page(), 1U);
    }
};

} // namespace teaching_test

TEST_CLASS(teaching_test::TeachingTest, Widgets)
#include "tests/ui/teaching_test.moc"
