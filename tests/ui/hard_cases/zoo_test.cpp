// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_containers.h"
#include "app/hard_cases/case_use.h"
#include "ui/hard_cases/answer_table.h"
#include "ui/hard_cases/case_list.h"
#include "ui/hard_cases/case_view.h"
#include "ui/hard_cases/zoo_window.h"

#include <QMenu>

#include "tests/app/document/sheet_edits.h"
#include "tests/not_empty.h"
#include "tests/ui/test_window.h"

using namespace ui;

namespace {

const app::HardCase& theCase(const char* key) { return *app::findHardCase(QLatin1StringView(key)); }

/// A main window and its zoo, opened by the menu's command.
struct Visit {
    Visit()
    {
        test.show();
        test.action("zoo")->trigger();
        zoo = test.window->findChild<ZooWindow*>();
        zoo->resize(1180, 780);
        search = zoo->findChild<QLineEdit*>();
        choice = zoo->findChild<QComboBox*>();
    }
    QPushButton* button(const char* word) const
    {
        for (auto* one : zoo->view().findChildren<QPushButton*>())
            if (one->text().contains(QLatin1StringView(word)))
                return one;
        return nullptr;
    }

    TestWindow test;
    ZooWindow* zoo = nullptr;
    QLineEdit* search = nullptr;
    QComboBox* choice = nullptr;
};

} // namespace

class ZooWindowTest : public QObject {
    Q_OBJECT

private slots:
    void opensByItsKeys()
    {
        TestWindow test;
        test.show();
        QTest::keyClick(test.drawingArea(), Qt::Key_F2, Qt::ControlModifier);
        auto* zoo = test.window->findChild<ZooWindow*>();
        QVERIFY(zoo && zoo->isVisible());
        QCOMPARE(zoo->list().model()->rowCount(), int(app::hardCases().size()));
        QCOMPARE(zoo->view().hardCase(), &app::hardCases().front());
        test.action("zoo")->trigger();
        QCOMPARE(test.window->findChildren<ZooWindow*>().size(), 1);
    }

    void showsWhatIsClicked()
    {
        Visit visit;
        CaseList& list = visit.zoo->list();
        QVERIFY(QTest::qWaitForWindowExposed(visit.zoo));
        const QRect third = list.visualRect(list.model()->index(2, 0));
        QVERIFY(third.width() > 100 && third.height() > 80);
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, third.center());
        const app::HardCase& hard = app::hardCases()[2];
        QCOMPARE(visit.zoo->view().hardCase(), &hard);
        QVERIFY(visit.zoo->view().findChild<QLabel*>("origin")->text().contains(hard.link));
        QVERIFY(visit.zoo->view()
                    .findChild<QLabel*>("expected")
                    ->text()
                    .contains(app::pieceText(hard.visible)));
        QTest::keyClick(&list, Qt::Key_Right);
        QCOMPARE(visit.zoo->view().hardCase(), &app::hardCases()[3]);
    }

    void searchesByTyping()
    {
        Visit visit;
        visit.search->setFocus();
        QTest::keyClicks(visit.search, QStringLiteral("sdl tolerance"));
        QCOMPARE(visit.zoo->list().model()->rowCount(), 1);
        QCOMPARE(visit.zoo->view().hardCase(), &theCase("sdl-10866"));
        QTest::keyClicks(visit.search, QStringLiteral(" nowhere"));
        QCOMPARE(visit.zoo->list().model()->rowCount(), 0);
        visit.search->clear();
        QCOMPARE(visit.zoo->list().model()->rowCount(), int(app::hardCases().size()));
    }

    void filtersByWhoFails()
    {
        Visit visit;
        const int skala =
            visit.choice->findText(QStringLiteral("Skala as published"), Qt::MatchStartsWith);
        QVERIFY(skala > 0);
        visit.choice->setCurrentIndex(skala);
        auto& list = visit.zoo->list();
        QVERIFY(list.model()->rowCount() > 5
                && list.model()->rowCount() < int(app::hardCases().size()));
        for (int row = 0; row < list.model()->rowCount(); ++row) {
            list.setCurrentIndex(list.model()->index(row, 0));
            const auto answer =
                app::answerOf(*list.chosen(), *app::findVariant(QStringLiteral("skala:published")));
            QVERIFY2(!answer.good(), qPrintable(list.chosen()->key));
        }
        visit.zoo->choose(theCase("sdl-6791")); // which is not among them
        QCOMPARE(visit.zoo->view().hardCase(), &theCase("sdl-6791"));
    }

    void saysWhatEverybodyDoes()
    {
        Visit visit;
        visit.zoo->choose(theCase("far-outside"));
        AnswerTable& table = visit.zoo->view().table();
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

    void opensTheMicroscope()
    {
        Visit visit;
        visit.zoo->choose(theCase("plotink-40"));
        auto* look = visit.button("microscope");
        QVERIFY(look->isEnabled());
        QTest::mouseClick(look, Qt::LeftButton);
        const app::Microscope& microscope = visit.test.window->session().microscope;
        QVERIFY(microscope.isOpen());
        QCOMPARE(microscope.specimen().line, theCase("plotink-40").line);
        QCOMPARE(microscope.specimen().y, app::YAxis::Up);
        QCOMPARE(app::keyOf(microscope.specimen().variant),
                 QStringLiteral("cohen-sutherland:published"));
        visit.zoo->choose(theCase("step-2-nothing")); // an exhibit is chosen, without steps
        QVERIFY(!look->isEnabled());
    }

    void drawsItAsANewDrawing()
    {
        Visit visit;
        visit.zoo->choose(theCase("one-decimal"));
        auto* draw = visit.button("canvas");
        QTest::mouseClick(draw, Qt::LeftButton);
        const app::Session& session = visit.test.window->session();
        QCOMPARE(session.scene.lines().size(), std::size_t(1));
        QCOMPARE(session.scene.lines()[0], theCase("one-decimal").line);
        QCOMPARE(session.window(), theCase("one-decimal").window);
        QCOMPARE(session.display().variant.form, clipping::Form::Published);
        QVERIFY(visit.test.window->windowTitle().contains(theCase("one-decimal").title));
        for (const char* key : {"nan", "infinite-end", "tiny", "sdl-6116", "inside-out"}) {
            visit.zoo->choose(theCase(key));
            QVERIFY2(!draw->isEnabled() && !draw->toolTip().isEmpty(), key);
        }
    }

    void asksBeforeADrawingIsLost()
    {
        Visit visit;
        app::Session& session = visit.test.window->session();
        session.history.push(addLayer(session.document, "Something"));
        visit.test.answers->answer = Questions::Answer::Cancel;
        const app::Document before = visit.test.window->session().now();
        visit.zoo->choose(theCase("one-decimal"));
        QTest::mouseClick(visit.button("canvas"), Qt::LeftButton);
        QCOMPARE(visit.test.answers->asked, 1);
        QVERIFY(visit.test.window->session().now() == before);
    }

    // Every picture can be painted, however large, small or absent its numbers are.
    void paintsEveryCase()
    {
        Visit visit;
        for (const app::HardCase& hard : notEmpty(app::hardCases())) {
            visit.zoo->choose(hard);
            QVERIFY(visit.zoo->view().table().model()->rowCount() > 0);
            for (int row = 0; row < visit.zoo->view().table().model()->rowCount(); ++row) {
                visit.zoo->view().table().selectRow(row);
                if (!visit.zoo->view().table().chosen()->good())
                    visit.zoo->view().grab();
            }
            QCOMPARE(visit.zoo->view().hardCase(), &hard);
        }
    }
};

QTEST_MAIN(ZooWindowTest)
#include "zoo_test.moc"
