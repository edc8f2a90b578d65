// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/choice_list.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/microscope/answer_discs.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"

#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QTimer>
#include <QToolButton>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace lessons_open_answers_test {

using namespace ui;

namespace {

/// A window with the first page of the second lesson, whose question is open.
struct Classroom : TestWindow {
    Classroom()
    {
        answers->answer = Questions::Answer::DontSave;
        show();
        ask();
    }
    void ask()
    {
        window->showLessons();
        course().begin(1);
        QCoreApplication::processEvents();
    }
    app::Session& session() const { return window->session(); }
    app::Course& course() const { return window->session().course; }
    app::Microscope& microscope() const { return window->session().microscope; }
    LessonPanel& lessons() const { return *window->findChild<LessonPanel*>(); }
    QWidget& view() const { return *window->microscopePage()->findChild<MicroscopeView*>(); }
    bool reveals() const
    {
        return microscope().isOpen() && !microscope().isCovered()
               && microscope().tracedLine().line == app::lessons()[1].pages[0].tracedLine.line;
    }
    int digitOfRight() const { return Qt::Key_1 + course().question()->right; }
    int digitOfWrong() const { return Qt::Key_1 + (course().question()->right == 0 ? 1 : 0); }
};

bool leavesTheWindow(const QAction& action)
{
    static const QStringList leave{"quit",       "close",     "about-qt",  "print",
                                   "experiment", "judge-own", "hard-cases"};
    return leave.contains(action.objectName());
}

} // namespace

/// Nothing but an answer uncovers the answer; digits give it.
class OpenAnswersTest : public QObject {
    Q_OBJECT

private slots:
    void theListOfLessonsKeepsTheAnswerCovered()
    {
        const Classroom room;
        for (auto* button : room.lessons().findChildren<QToolButton*>())
            if (button->toolTip() == "Show all lessons")
                QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(room.course().isPaused());
        QVERIFY(!room.reveals() && room.microscope().isOpen());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return); // the lesson in progress
        QVERIFY(!room.course().isPaused() && room.course().asks());
        QCOMPARE(room.course().lessonIndex(), std::size_t(1));
    }
    void noCommandUncoversTheAnswer()
    {
        Classroom room;
        QTimer closer;
        connect(&closer, &QTimer::timeout, this, [] {
            if (QWidget* waiting = QApplication::activePopupWidget()
                                       ? QApplication::activePopupWidget()
                                       : QApplication::activeModalWidget())
                waiting->close();
        });
        closer.start(5);
        int tried = 0;
        for (QAction* action : room.window->findChildren<QAction*>()) {
            if (action->menu() || action->isSeparator() || !action->isEnabled()
                || action->objectName().isEmpty() || leavesTheWindow(*action))
                continue;
            if (!room.course().asks())
                room.ask();
            QVERIFY(room.course().asks() && !room.reveals());
            action->trigger();
            room.window->files().wait();
            QCoreApplication::processEvents();
            QVERIFY2(!room.reveals(), qPrintable(action->objectName()));
            ++tried;
        }
        QVERIFY(tried > 60);
    }
    void digitsAnswer()
    {
        const Classroom room;
        room.view().setFocus();
        const app::Variant before = room.microscope().tracedLine().variant;
        QTest::keyClick(&room.view(), Qt::Key(room.digitOfWrong()));
        QCOMPARE(room.course().answer().wrong, 1);
        QTest::keyClick(&room.view(), Qt::Key_9); // there is no such answer
        QVERIFY(room.course().isOpen());
        QTest::keyClick(&room.view(), Qt::Key(room.digitOfRight()));
        QVERIFY(!room.course().isOpen());
        QCOMPARE(room.course().score(), (app::Score{1, 0}));
        QCOMPARE(room.microscope().tracedLine().variant, before);
        QVERIFY(room.lessons().isAncestorOf(QApplication::focusWidget())); // Enter goes on
    }
    void enterGoesOnAfterAClickInTheFigure()
    {
        const Classroom room;
        while (!room.course().isOpen() || room.course().question()->parts.empty())
            room.course().isOpen() ? room.course().skip() : room.course().next();
        QCoreApplication::processEvents();
        const std::size_t page = room.course().page();
        const auto& answers = room.window->microscopePage()->findChild<AnswerDiscs*>()->answers();
        const std::size_t right = std::size_t(room.course().question()->right);
        QTest::mouseClick(&room.view(), Qt::LeftButton, {}, answers[right].disc.toPoint());
        QVERIFY(!room.course().isOpen());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCOMPARE(room.course().page(), page + 1);
    }
    void digitsAnswerFromTheLesson()
    {
        const Classroom room;
        auto* choices = room.lessons().findChild<ChoiceList*>();
        choices->buttons().first()->setFocus();
        QVERIFY(choices->buttons().first()->text().startsWith(u'1'));
        QTest::keyClick(choices->buttons().first(), Qt::Key(room.digitOfRight()));
        QCOMPARE(room.course().score(), (app::Score{1, 1}));
        QVERIFY(room.lessons().isAncestorOf(QApplication::focusWidget())); // Enter goes on
    }
    void withoutAQuestionDigitsChooseTheAlgorithm()
    {
        const Classroom room;
        room.course().showAnswer();
        room.view().setFocus();
        QTest::keyClick(&room.view(), Qt::Key_3);
        QCOMPARE(room.microscope().tracedLine().variant.algorithm, &clipping::algorithms()[2]);
    }
    void fieldsAndDragsKeepTheirDigits()
    {
        const Classroom room;
        auto* field = room.window->microscopePage()->findChild<QLineEdit*>();
        field->setFocus();
        QTest::keyClick(field, Qt::Key(room.digitOfRight()));
        QVERIFY(room.course().isOpen());
        room.view().setFocus();
        QTest::mousePress(&room.view(), Qt::LeftButton, {}, QPoint(5, 5)); // the view is dragged
        QTest::keyClick(&room.view(), Qt::Key(room.digitOfRight()));
        QVERIFY(room.course().isOpen());
        QTest::mouseRelease(&room.view(), Qt::LeftButton, {}, QPoint(5, 5));
        QTest::keyClick(&room.view(), Qt::Key(room.digitOfRight()));
        QVERIFY(!room.course().isOpen());
    }
};

} // namespace lessons_open_answers_test

TEST_CLASS(lessons_open_answers_test::OpenAnswersTest, Widgets)
#include "tests/ui/lessons/open_answers_test.moc"
