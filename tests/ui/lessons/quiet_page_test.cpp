// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/status_bar.h"
#include "ui/bars/tool_bar.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/microscope/code_view.h"
#include "ui/microscope/microscope_bar.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"
#include "ui/microscope/operations_view.h"
#include "ui/microscope/variable_table.h"

#include <QSplitter>
#include <QToolButton>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace lessons_quiet_page_test {

using namespace ui;

namespace {

struct Classroom : TestWindow {
    Classroom()
    {
        answers->answer = Questions::Answer::DontSave;
        show();
        window->drawnLine().look();
        QCoreApplication::processEvents();
    }
    app::Course& course() const { return window->session().course; }
    MicroscopePage& page() const { return *window->microscopePage(); }
    void begin(std::size_t lesson, std::size_t number)
    {
        window->showLessons();
        course().begin(lesson);
        while (course().page() < number) {
            course().showAnswer();
            course().next();
        }
        QCoreApplication::processEvents();
    }
    app::LessonParts shown() const
    {
        return {.code = page().code().isVisible(),
                .variables = page().variables().isVisible(),
                .operations = page().findChild<OperationsView*>()->isVisible(),
                .steps = page().steps().isVisible()};
    }
    /// The parts of the window that are shown around the figure, outside the page's own parts.
    int bars() const
    {
        return page().bar().isVisible() + window->findChild<ToolBar*>()->isVisible()
               + window->status().isVisible();
    }
    QList<QByteArray> shares() const
    {
        QList<QByteArray> all;
        for (const auto* splitter : page().findChildren<QSplitter*>())
            all << splitter->saveState();
        return all;
    }
};

} // namespace

/// Beside a lesson's page stands only what the page explains.
class QuietPageTest : public QObject {
    Q_OBJECT

private slots:
    void everyPageShowsItsPartsAndNoBar()
    {
        Classroom room;
        QCOMPARE(room.bars(), 3);
        room.window->showLessons();
        for (std::size_t i = 0; i < app::lessons().size(); ++i)
            for (room.begin(i, 0);; room.course().next()) {
                room.course().showAnswer();
                const auto& wanted = app::lessons()[i].pages[room.course().page()].shows;
                QVERIFY2(room.shown() == wanted, qPrintable(room.course().text()));
                QCOMPARE(room.bars(), 0);
                QVERIFY(room.page().view().isVisible());
                if (room.course().atLastPage())
                    break;
            }
    }
    void thePartsOfAPageAreOnTheStageToo_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("lesson");
        QTest::newRow("wide") << 1440 << 480;
        QTest::newRow("narrow") << 1100 << 380;
    }
    void thePartsOfAPageAreOnTheStageToo()
    {
        QFETCH(int, width);
        QFETCH(int, lesson);
        Classroom room;
        room.window->resize(width, 760);
        for (const std::size_t number : {std::size_t(0), std::size_t(1)}) { // without, with code
            room.begin(1, number);
            QVERIFY(std::abs(room.page().side()->width() - lesson) <= 1); // rounded by the splitter
            QVERIFY(room.page().view().width() >= 320);
        }
        room.begin(0, 1);
        QVERIFY(room.page().view().width() >= width - lesson - 4);
        QVERIFY(room.page().view().height() > 700);
    }
    void closingBringsEverythingBackAsItWas_data()
    {
        QTest::addColumn<bool>("moved");
        QTest::newRow("as designed") << false;
        QTest::newRow("as the person moved it") << true;
    }
    void closingBringsEverythingBackAsItWas()
    {
        QFETCH(bool, moved);
        Classroom room;
        if (moved) {
            auto* splitter = room.page().findChildren<QSplitter*>().first();
            splitter->setSizes({500, 700});
            emit splitter->splitterMoved(500, 1);
            QCoreApplication::processEvents();
        }
        const auto before = room.shares();
        room.begin(1, 1);
        QVERIFY(room.shares() != before);
        emit room.page().findChild<LessonPanel*>()->closeWanted();
        QCoreApplication::processEvents();
        room.window->drawnLine().look(); // the open question has closed the microscope
        QCoreApplication::processEvents();
        QCOMPARE(room.shown(), (app::LessonParts{true, true, true, true}));
        QCOMPARE(room.bars(), 3);
        QCOMPARE(room.shares(), before);
    }
    void operationsThatStandAloneAreNotStretched()
    {
        Classroom room;
        room.begin(3, 0);
        const auto* operations = room.page().findChild<OperationsView*>();
        QCOMPARE(room.shown(), (app::LessonParts{.operations = true}));
        QVERIFY(operations->height() < 150);
    }
    void escapeAsksNothingAndTheLessonRemembersItsPage()
    {
        Classroom room;
        room.begin(1, 2);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!room.window->showsLessons() && !room.window->session().microscope.isOpen());
        QCOMPARE(room.window->findChild<ToolBar*>()->isVisible(), true);
        room.window->showLessons();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCOMPARE(room.course().lessonIndex(), std::size_t(1));
        QCOMPARE(room.course().page(), std::size_t(2));
    }
    void theStageHasAWayOut()
    {
        Classroom room;
        room.begin(0, 0);
        auto* leave = room.page().findChild<QToolButton*>(QStringLiteral("leave-lesson"));
        QVERIFY(leave->isVisible());
        QTest::mouseClick(leave, Qt::LeftButton);
        QVERIFY(!room.window->session().microscope.isOpen());
    }
};

} // namespace lessons_quiet_page_test

TEST_CLASS(lessons_quiet_page_test::QuietPageTest, Widgets)
#include "tests/ui/lessons/quiet_page_test.moc"
