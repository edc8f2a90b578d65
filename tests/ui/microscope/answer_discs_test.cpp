// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/answer_discs.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"

#include <QTest>

#include "tests/test_class.h"

namespace microscope_answer_discs_test {

using State = app::StageAnswer::State;

namespace {

/// The microscope's page with a question whose answers are edges.
struct Stage {
    Stage()
    {
        page.resize(1100, 760);
        page.show();
        course.setSeed(0); // as the file has it
        course.begin(1);
        while (!course.isOpen() || course.question()->parts.empty())
            course.isOpen() ? course.skip() : course.next();
        QCoreApplication::processEvents();
    }
    QPoint discOf(int choice) const { return discs.answers()[std::size_t(choice)].disc.toPoint(); }
    QPoint partOf(int choice) const
    {
        return discs.answers()[std::size_t(choice)].part.pointAt(0.1).toPoint();
    }
    State stateOf(int choice) const { return discs.answers()[std::size_t(choice)].state; }
    void click(const QPoint& place) { QTest::mouseClick(&page.view(), Qt::LeftButton, {}, place); }

    app::Session session;
    app::DrawnLine drawn{session};
    ui::MicroscopePage page{session, drawn};
    app::Course& course = session.course;
    ui::AnswerDiscs& discs = *page.findChild<ui::AnswerDiscs*>();
};

} // namespace

class AnswerDiscsTest : public QObject {
    Q_OBJECT

private slots:
    void aClickAtAPartOrItsDiscAnswers()
    {
        Stage stage;
        QVERIFY(stage.discs.isVisible());
        const int right = stage.course.question()->right, wrong = right == 0 ? 1 : 0;
        stage.click(stage.discOf(wrong));
        QCOMPARE(stage.course.answer().tries, std::vector{wrong});
        QCOMPARE(stage.stateOf(wrong), State::Wrong);
        stage.click(stage.discOf(wrong)); // it was tried
        QCOMPARE(stage.course.answer().wrong, 1);
        stage.click(stage.partOf(right));
        QVERIFY(stage.course.answer().right);
        QCOMPARE(stage.stateOf(right), State::Right);
    }
    void hoveringLightsAnyPart()
    {
        Stage stage;
        for (int choice = 0; choice < 4; ++choice) {
            QTest::mouseMove(&stage.page.view(), stage.discOf(choice));
            QCOMPARE(stage.discs.hovered(), std::optional(choice));
            QCOMPARE(stage.page.view().cursor().shape(), Qt::PointingHandCursor);
        }
        QTest::mouseMove(&stage.page.view(), QPoint(4, 4));
        QVERIFY(!stage.discs.hovered());
    }
    void aPressThatLeavesThePartAnswersNothing()
    {
        Stage stage;
        QTest::mousePress(&stage.page.view(), Qt::LeftButton, {}, stage.discOf(0));
        QTest::mouseRelease(&stage.page.view(), Qt::LeftButton, {}, QPoint(4, 4));
        QVERIFY(stage.course.answer().tries.empty());
    }
    void besideThePartsTheViewIsDragged()
    {
        Stage stage;
        const auto before = stage.page.view().frame().seen;
        QTest::mousePress(&stage.page.view(), Qt::LeftButton, {}, QPoint(4, 4));
        QTest::mouseMove(&stage.page.view(), QPoint(40, 30));
        QTest::mouseRelease(&stage.page.view(), Qt::LeftButton, {}, QPoint(40, 30));
        QVERIFY(stage.page.view().frame().seen.min != before.min);
        stage.click(stage.discOf(stage.course.question()->right)); // the discs have followed
        QVERIFY(stage.course.answer().right);
    }
    void otherQuestionsHaveNoDiscs()
    {
        Stage stage;
        stage.course.begin(0);
        QVERIFY(stage.discs.isVisible()); // the parts of the line
        stage.course.skip();
        stage.course.next(); // how much is visible?
        QVERIFY(stage.course.asks() && !stage.discs.isVisible());
    }
};

} // namespace microscope_answer_discs_test

TEST_CLASS(microscope_answer_discs_test::AnswerDiscsTest, Widgets)
#include "tests/ui/microscope/answer_discs_test.moc"
