// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"
#include "ui/lessons/choice_list.h"
#include "ui/lessons/lesson_list.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/lessons/page_dots.h"

#include <QAbstractButton>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace lessons_lesson_panel_test {

namespace {

/// A panel on the screen, with a course of its own.
struct Stage {
    Stage()
    {
        QSettings().clear();
        course.setSeed(0); // as the files have it
        panel.resize(320, 700);
        panel.show();
        panel.activateWindow();
        if (!QTest::qWaitForWindowActive(&panel))
            QFAIL("the panel does not become active");
    }
    ui::ChoiceList& choices() { return *panel.findChild<ui::ChoiceList*>(); }
    ui::LessonList& list() { return *panel.findChild<ui::LessonList*>(); }
    QPushButton& button(const QString& text) const
    {
        const auto buttons = panel.currentWidget()->findChildren<QPushButton*>();
        return **std::ranges::find(buttons, text, &QPushButton::text);
    }
    const QLabel& label(const QString& text) const
    {
        const auto labels = panel.findChildren<QLabel*>();
        return **std::ranges::find(labels, text, &QLabel::text);
    }
    bool says(const QString& words) const
    {
        const auto labels = panel.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }
    void press(int key) { QTest::keyClick(QApplication::focusWidget(), Qt::Key(key)); }

    app::Microscope microscope;
    app::Course course{microscope};
    app::Practice practice{microscope, course};
    ui::LessonPanel panel{course, practice};
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
            if (stage.course.isOpen()) {
                // Down goes from choice to choice, Enter presses.
                for (int i = 0; i < stage.course.question()->right; ++i)
                    stage.press(Qt::Key_Down);
                stage.press(Qt::Key_Return);
                QVERIFY2(!stage.course.isOpen() && stage.course.answer().tries.size() == 1,
                         qPrintable(stage.course.question()->prompt));
                ++answered;
            }
            stage.press(Qt::Key_PageDown);
        }
        QVERIFY(!stage.course.lesson()); // the last one has led back to the list
        QCOMPARE(seen.size(), qsizetype(app::lessons().size()));
        QVERIFY(answered > 15);
        for (const app::Lesson& lesson : app::lessons())
            QVERIFY2(app::bestRight(QSettings(), lesson) == app::questionsOf(lesson),
                     qPrintable(lesson.key));
    }
    void theMicroscopeFollowsThePages()
    {
        Stage stage;
        QTest::mouseClick(stage.list().buttons()[1], Qt::LeftButton);
        QVERIFY(stage.microscope.isOpen());
        const auto first = stage.microscope.tracedLine();
        QCOMPARE(first, app::lessons()[1].pages[0].tracedLine);
        stage.press(Qt::Key_PageDown); // its question is open
        QCOMPARE(stage.microscope.tracedLine(), first);
        QTest::mouseClick(stage.panel.findChild<QPushButton*>(QStringLiteral("show-answer")),
                          Qt::LeftButton);
        stage.press(Qt::Key_PageDown);
        QCOMPARE(stage.microscope.tracedLine(), app::lessons()[1].pages[1].tracedLine);
        stage.press(Qt::Key_PageUp);
        QCOMPARE(stage.microscope.tracedLine(), first);
    }
    void aWrongAnswerGivesAHintAndASecondTry()
    {
        Stage stage;
        stage.course.begin(1); // which outcode?
        const int right = stage.course.question()->right;
        const int wrong = right == 0 ? 1 : 0;
        QTest::mouseClick(stage.choices().buttons()[wrong], Qt::LeftButton);
        QVERIFY(stage.course.isOpen());
        QVERIFY(stage.says("Not quite") && stage.says(stage.course.question()->hint));
        QVERIFY(!stage.says(stage.course.question()->reason));
        QVERIFY(!stage.choices().buttons()[wrong]->isEnabled());
        QVERIFY(stage.choices().buttons()[wrong]->accessibleDescription().contains("wrong"));
        QVERIFY(stage.choices().buttons()[right]->accessibleDescription().isEmpty());
        QTest::mouseClick(stage.choices().buttons()[right], Qt::LeftButton);
        QVERIFY(!stage.course.isOpen());
        QCOMPARE(stage.course.score(), (app::Score{1, 0}));
        QVERIFY(stage.says("Right.") && stage.says(stage.course.question()->reason));
        QCOMPARE(stage.choices().buttons()[right]->accessibleDescription(), "right");
    }
    void aPageHasItsPlaceAndTitle()
    {
        Stage stage;
        QTest::mouseClick(stage.list().buttons()[0], Qt::LeftButton);
        QVERIFY(stage.says("Lesson 1") && stage.says("Why clip a line?") && stage.says("1 of 9"));
        QCOMPARE(stage.panel.currentWidget()->findChild<ui::PageDots*>()->accessibleName(),
                 "Page 1 of 9");
        const double type = QFontInfo(stage.panel.font()).pixelSize();
        QVERIFY(QFontInfo(stage.label("Why clip a line?").font()).pixelSize() >= 1.9 * type);
        QVERIFY(stage.choices().firstOpen()->hasFocus()); // Enter or a digit answers
    }
    void backStandsLeftOfSkipFromTheSecondPageOn()
    {
        Stage stage;
        stage.course.begin(0);
        QVERIFY(!stage.button("Back").isVisible());
        stage.course.choose(stage.course.question()->right);
        QVERIFY(!stage.button("Skip").isEnabled() && stage.button("Next").isEnabled());
        stage.course.next();
        QVERIFY(stage.button("Skip").isEnabled() && !stage.button("Next").isEnabled());
        QTRY_VERIFY(stage.button("Back").geometry().right() < stage.button("Skip").x());
        QVERIFY(stage.button("Skip").geometry().right() < stage.button("Next").x());
    }
    void skippingGoesOnWithoutPoints()
    {
        Stage stage;
        stage.course.begin(0);
        QTest::mouseClick(&stage.button("Skip"), Qt::LeftButton);
        QCOMPARE(stage.course.page(), 1U);
        QCOMPARE(stage.course.score(), (app::Score{1, 0}));
        QVERIFY(stage.course.asks() && stage.choices().firstOpen()->hasFocus());
    }
    void theExampleIsOfferedOnlyWhenAnotherLineIsShown()
    {
        Stage stage;
        stage.course.begin(0);
        QVERIFY(!stage.button("Show example").isVisible());
        app::TracedLine moved = stage.microscope.tracedLine();
        moved.line.a.x += 5;
        stage.microscope.setTracedLine(moved);
        QVERIFY(stage.button("Show example").isVisible());
        QTest::mouseClick(&stage.button("Show example"), Qt::LeftButton);
        QCOMPARE(stage.microscope.tracedLine(), app::lessons()[0].pages[0].tracedLine);
        QVERIFY(!stage.button("Show example").isVisible());
    }
    void longAnswersWrapAndDotsNeedRoom()
    {
        Stage stage;
        stage.course.begin(1);
        stage.course.skip(); // which step follows?
        for (const int width : {330, 380, 480}) {
            stage.panel.resize(width, 700);
            QCoreApplication::processEvents();
            for (const QPushButton* choice : stage.choices().buttons()) {
                const QRect text = choice->fontMetrics().boundingRect(
                    QRect(0, 0, 1000, 1000), Qt::TextWordWrap, choice->text());
                QVERIFY2(text.width() <= choice->width() && text.height() <= choice->height(),
                         qPrintable(choice->text()));
            }
            const auto* dots = stage.panel.currentWidget()->findChild<ui::PageDots*>();
            QCOMPARE(dots->isVisible(), width > 330);
            QVERIFY(!dots->isVisible() || dots->width() >= dots->minimumSizeHint().width());
            if (width == 480) // at others only with the narrower buttons of the program's style
                QVERIFY(stage.button("Next").geometry().right() < width);
        }
    }
    void readingWithoutAnsweringEarnsNoTick()
    {
        Stage stage;
        const app::Lesson& lesson = app::lessons()[1];
        for (stage.course.begin(1);; stage.course.next()) {
            stage.course.showAnswer();
            if (stage.course.atLastPage())
                break;
        }
        stage.panel.showList();
        QCOMPARE(app::bestRight(QSettings(), lesson), std::optional(0));
        const QString words = stage.list().buttons()[1]->accessibleDescription();
        QVERIFY2(words.contains("Best: 0 of"), qPrintable(words));
        QVERIFY2(!words.contains("Passed"), qPrintable(words));
    }
    void theEndSaysWhetherTheLessonIsPassed()
    {
        Stage stage;
        const auto answerAll = [&](bool rightly) {
            for (;; stage.course.next()) {
                if (stage.course.isOpen() && rightly)
                    stage.course.choose(stage.course.question()->right);
                else if (stage.course.isOpen())
                    stage.course.showAnswer();
                if (stage.course.atLastPage())
                    break;
                QVERIFY(!stage.says("assed"));
            }
        };
        const auto repeat = [&] {
            const auto buttons = stage.panel.findChildren<QPushButton*>();
            return *std::ranges::find(buttons, "Repeat lesson", &QPushButton::text);
        };
        stage.course.begin(1);
        answerAll(false);
        QVERIFY(stage.says("Not passed yet: 0 of ") && stage.says("Try the lesson again?"));
        QTest::mouseClick(repeat(), Qt::LeftButton);
        QCOMPARE(stage.course.lessonIndex(), 1U);
        QCOMPARE(stage.course.page(), 0U);
        QVERIFY(stage.course.isOpen() && !repeat()->isVisible());
        answerAll(true);
        QVERIFY(stage.says("Passed: ") && !repeat()->isVisible());
    }
    void pointsAreKeptForTheNextStart()
    {
        const app::Lesson& lesson = app::lessons()[1];
        Stage first;
        for (first.course.begin(1);; first.course.next()) {
            if (first.course.isOpen())
                first.course.choose(first.course.question()->right);
            if (first.course.atLastPage())
                break;
        }
        app::Microscope microscope;
        app::Course course(microscope);
        app::Practice practice(microscope, course);
        const ui::LessonPanel next(course, practice); // the settings are as they were left
        const auto* list = next.findChild<ui::LessonList*>();
        QVERIFY(list->buttons()[1]->accessibleDescription().contains("Passed"));
        QVERIFY(list->buttons()[1]->accessibleDescription().contains(
            QStringLiteral("%1 of %1").arg(app::questionsOf(lesson))));
        QVERIFY(!list->buttons()[0]->accessibleDescription().contains("Best"));
    }

private:
    QTemporaryDir folder_;
};

} // namespace lessons_lesson_panel_test

TEST_CLASS(lessons_lesson_panel_test::LessonPanelTest, Widgets)
#include "tests/ui/lessons/lesson_panel_test.moc"
