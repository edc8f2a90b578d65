// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/choice_list.h"
#include "ui/lessons/lesson_list.h"
#include "ui/lessons/lesson_panel.h"

#include <QAbstractButton>

#include "tests/ui/test_window.h"

namespace {

/// A panel on the screen, with a course of its own.
struct Stage {
    Stage()
    {
        QSettings().clear();
        panel.resize(320, 700);
        panel.show();
        panel.activateWindow();
        if (!QTest::qWaitForWindowActive(&panel))
            QFAIL("the panel does not become active");
    }
    ui::ChoiceList& choices() { return *panel.findChild<ui::ChoiceList*>(); }
    ui::LessonList& list() { return *panel.findChild<ui::LessonList*>(); }
    void press(int key) { QTest::keyClick(QApplication::focusWidget(), Qt::Key(key)); }

    app::Microscope microscope;
    app::Course course{microscope};
    ui::LessonPanel panel{course};
};

} // namespace

class LessonPanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
        QCoreApplication::setOrganizationName(QStringLiteral("Clearcut"));
    }
    void everyLessonPlaysToItsEndByKeys()
    {
        Stage stage;
        stage.list().buttons().front()->setFocus();
        stage.press(Qt::Key_Space);
        QVERIFY(stage.course.lesson());
        QSet<QString> seen;
        int answered = 0;
        for (int presses = 0; presses < 500 && stage.course.lesson(); ++presses) {
            seen << stage.course.lesson()->key;
            if (stage.course.question() && !stage.course.answer()) {
                // Down goes from choice to choice, Enter presses.
                for (int i = 0; i < stage.course.question()->right; ++i)
                    stage.press(Qt::Key_Down);
                stage.press(Qt::Key_Return);
                QVERIFY2(stage.course.answer() == stage.course.question()->right,
                         qPrintable(stage.course.question()->prompt));
                ++answered;
            }
            stage.press(Qt::Key_PageDown);
        }
        QVERIFY(!stage.course.lesson()); // the last one has led back to the list
        QCOMPARE(seen.size(), qsizetype(app::lessons().size()));
        QVERIFY(answered > 15);
        for (const app::Lesson& lesson : app::lessons())
            QVERIFY2(ui::isDone(lesson.key), qPrintable(lesson.key));
    }
    void theMicroscopeFollowsThePages()
    {
        Stage stage;
        QTest::mouseClick(stage.list().buttons()[1], Qt::LeftButton);
        QVERIFY(stage.microscope.isOpen());
        const auto first = stage.microscope.specimen();
        QCOMPARE(first, app::lessons()[1].pages[0].specimen);
        stage.press(Qt::Key_PageDown);
        QCOMPARE(stage.microscope.specimen(), app::lessons()[1].pages[1].specimen);
        stage.press(Qt::Key_PageUp);
        QCOMPARE(stage.microscope.specimen(), first);
    }
    void aWrongAnswerIsToldAndCounts()
    {
        Stage stage;
        stage.course.begin(1); // which outcode?
        const int right = stage.course.question()->right;
        const int wrong = right == 0 ? 1 : 0;
        QTest::mouseClick(stage.choices().buttons()[wrong], Qt::LeftButton);
        QCOMPARE(stage.course.score(), (app::Score{1, 0}));
        QCOMPARE(stage.choices().buttons()[right]->accessibleDescription(), "right");
        QVERIFY(stage.choices().buttons()[wrong]->accessibleDescription().contains("wrong"));
        const auto labels = stage.choices().findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() && label->text().startsWith(QStringLiteral("Not quite"));
        }));
    }

private:
    QTemporaryDir folder_;
};

QTEST_MAIN(LessonPanelTest)
#include "lesson_panel_test.moc"
