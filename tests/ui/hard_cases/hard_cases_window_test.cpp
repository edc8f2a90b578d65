// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_containers.h"
#include "app/hard_cases/case_use.h"
#include "ui/hard_cases/answer_table.h"
#include "ui/hard_cases/case_list.h"
#include "ui/hard_cases/case_view.h"
#include "ui/hard_cases/hard_cases_window.h"

#include <QMenu>
#include <QSignalSpy>

#include "tests/app/document/sheet_edits.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace hard_cases_hard_cases_window_test {

using namespace ui;

namespace {

const app::HardCase& theCase(const char* key) { return *app::findHardCase(QLatin1StringView(key)); }

/// A main window and its window of hard cases, opened by the menu's command.
struct Visit {
    Visit()
    {
        test.show();
        test.action("hard-cases")->trigger();
        casesWindow = test.window->findChild<HardCasesWindow*>();
        casesWindow->resize(1180, 780);
        search = casesWindow->findChild<QLineEdit*>();
        choice = casesWindow->findChild<QComboBox*>();
    }
    QPushButton* button(const char* word) const
    {
        for (auto* one : casesWindow->view().findChildren<QPushButton*>())
            if (one->text().contains(QLatin1StringView(word)))
                return one;
        return nullptr;
    }

    TestWindow test;
    HardCasesWindow* casesWindow = nullptr;
    QLineEdit* search = nullptr;
    QComboBox* choice = nullptr;
};

} // namespace

class HardCasesWindowTest : public QObject {
    Q_OBJECT

private slots:
    void theShortcutOpensTheWindow()
    {
        TestWindow test;
        test.show();
        QTest::keyClick(test.drawingArea(), Qt::Key_F2, Qt::ControlModifier);
        auto* casesWindow = test.window->findChild<HardCasesWindow*>();
        QVERIFY(casesWindow && casesWindow->isVisible());
        QCOMPARE(casesWindow->list().model()->rowCount(), int(app::hardCases().size()));
        QCOMPARE(casesWindow->view().hardCase(), &app::hardCases().front());
        test.action("hard-cases")->trigger();
        QCOMPARE(test.window->findChildren<HardCasesWindow*>().size(), 1);
    }

    void aClickedCaseIsShown()
    {
        Visit visit;
        CaseList& list = visit.casesWindow->list();
        QVERIFY(QTest::qWaitForWindowExposed(visit.casesWindow));
        const QRect third = list.visualRect(list.model()->index(2, 0));
        QVERIFY(third.width() > 100 && third.height() > 80);
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, third.center());
        const app::HardCase& hard = app::hardCases()[2];
        QCOMPARE(visit.casesWindow->view().hardCase(), &hard);
        QVERIFY(visit.casesWindow->view().findChild<QLabel*>("origin")->text().contains(hard.link));
        QVERIFY(visit.casesWindow->view()
                    .findChild<QLabel*>("expected")
                    ->text()
                    .contains(app::pieceText(hard.visible)));
        QTest::keyClick(&list, Qt::Key_Right);
        QCOMPARE(visit.casesWindow->view().hardCase(), &app::hardCases()[3]);
    }

    void typingSearches()
    {
        Visit visit;
        visit.search->setFocus();
        QTest::keyClicks(visit.search, QStringLiteral("sdl tolerance"));
        QCOMPARE(visit.casesWindow->list().model()->rowCount(), 1);
        QCOMPARE(visit.casesWindow->view().hardCase(), &theCase("sdl-10866"));
        QTest::keyClicks(visit.search, QStringLiteral(" nowhere"));
        QCOMPARE(visit.casesWindow->list().model()->rowCount(), 0);
        visit.search->clear();
        QCOMPARE(visit.casesWindow->list().model()->rowCount(), int(app::hardCases().size()));
    }

    void aSearchTellsOnlyAnotherCase()
    {
        Visit visit;
        QSignalSpy chosen(&visit.casesWindow->list(), &CaseList::caseChosen);
        visit.casesWindow->list().setFilter({.words = QStringLiteral("sdl tolerance")});
        QCOMPARE(chosen.size(), 1);
        visit.casesWindow->list().setFilter({.words = QStringLiteral("sdl")});
        QCOMPARE(chosen.size(), 1);
    }

    void casesAreFilteredByTheFailingVariant()
    {
        Visit visit;
        const int skala =
            visit.choice->findText(QStringLiteral("Skala as published"), Qt::MatchStartsWith);
        QVERIFY(skala > 0);
        visit.choice->setCurrentIndex(skala);
        auto& list = visit.casesWindow->list();
        QVERIFY(list.model()->rowCount() > 5
                && list.model()->rowCount() < int(app::hardCases().size()));
        for (int row = 0; row < list.model()->rowCount(); ++row) {
            list.setCurrentIndex(list.model()->index(row, 0));
            const auto answer =
                app::answerOf(*list.chosen(), *app::findVariant(QStringLiteral("skala:published")));
            QVERIFY2(!answer.good(), qPrintable(list.chosen()->key));
        }
        visit.casesWindow->choose(theCase("sdl-6791")); // which is not among them
        QCOMPARE(visit.casesWindow->view().hardCase(), &theCase("sdl-6791"));
    }

    void everyAlgorithmsResultIsShown()
    {
        Visit visit;
        visit.casesWindow->choose(theCase("far-outside"));
        AnswerTable& table = visit.casesWindow->view().table();
        QCOMPARE(table.model()->rowCount(), int(app::variants().size()));
        QVERIFY(table.chosen());
        QCOMPARE(app::keyOf(table.chosen()->variant),
                 QStringLiteral("matthes-drakopoulos:published"));
        int wrong = 0;
        for (int row = 0; row < table.model()->rowCount(); ++row)
            wrong += table.model()->index(row, AnswerModel::Verdict).data().toString()
                             == QStringLiteral("right")
                         ? 0
                         : 1;
        QCOMPARE(std::size_t(wrong), theCase("far-outside").faults.size());
    }

    void theButtonOpensTheMicroscope()
    {
        Visit visit;
        visit.casesWindow->choose(theCase("plotink-40"));
        auto* look = visit.button("microscope");
        QVERIFY(look->isEnabled());
        QTest::mouseClick(look, Qt::LeftButton);
        const app::Microscope& microscope = visit.test.window->session().microscope;
        QVERIFY(microscope.isOpen());
        QCOMPARE(microscope.tracedLine().line, theCase("plotink-40").line);
        QCOMPARE(microscope.tracedLine().y, app::YAxis::Up);
        QCOMPARE(app::keyOf(microscope.tracedLine().variant),
                 QStringLiteral("cohen-sutherland:published"));
        visit.casesWindow->choose(theCase("step-2-nothing")); // a known misprint is selected
        QTest::mouseClick(look, Qt::LeftButton);
        QVERIFY(microscope.tracedLine().variant.misprint);
        QVERIFY(!microscope.narration().steps.empty());
    }

    void aCaseOpensAsANewDrawing()
    {
        Visit visit;
        visit.casesWindow->choose(theCase("one-decimal"));
        auto* draw = visit.button("drawing");
        QTest::mouseClick(draw, Qt::LeftButton);
        const app::Session& session = visit.test.window->session();
        QCOMPARE(session.scene.lines().size(), std::size_t(1));
        QCOMPARE(session.scene.lines()[0], theCase("one-decimal").line);
        QCOMPARE(session.window(), theCase("one-decimal").window);
        QCOMPARE(session.display().variant.form, clipping::Form::Published);
        QVERIFY(visit.test.window->windowTitle().contains(theCase("one-decimal").title));
        for (const char* key : {"nan", "infinite-end", "tiny", "sdl-6116", "inside-out"}) {
            visit.casesWindow->choose(theCase(key));
            QVERIFY2(!draw->isEnabled() && !draw->toolTip().isEmpty(), key);
        }
    }

    void itAsksBeforeADrawingIsLost()
    {
        Visit visit;
        app::Session& session = visit.test.window->session();
        session.history.push(addLayer(session.document, "Something"));
        visit.test.answers->answer = Questions::Answer::Cancel;
        const app::Document before = visit.test.window->session().now();
        visit.casesWindow->choose(theCase("one-decimal"));
        QTest::mouseClick(visit.button("drawing"), Qt::LeftButton);
        QCOMPARE(visit.test.answers->asked, 1);
        QVERIFY(visit.test.window->session().now() == before);
    }

    // Every picture can be painted, however large, small or absent its numbers are.
    void everyCaseIsPainted()
    {
        Visit visit;
        for (const app::HardCase& hard : notEmpty(app::hardCases())) {
            visit.casesWindow->choose(hard);
            QVERIFY(visit.casesWindow->view().table().model()->rowCount() > 0);
            for (int row = 0; row < visit.casesWindow->view().table().model()->rowCount(); ++row) {
                visit.casesWindow->view().table().selectRow(row);
                if (!visit.casesWindow->view().table().chosen()->good())
                    visit.casesWindow->view().grab();
            }
            QCOMPARE(visit.casesWindow->view().hardCase(), &hard);
        }
    }
};

} // namespace hard_cases_hard_cases_window_test

TEST_CLASS(hard_cases_hard_cases_window_test::HardCasesWindowTest, Widgets)
#include "tests/ui/hard_cases/hard_cases_window_test.moc"
