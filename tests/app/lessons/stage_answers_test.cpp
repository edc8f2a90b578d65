// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/stage_answers.h"

#include <QGuiApplication>
#include <QTest>

#include <functional>

#include "tests/test_class.h"

namespace lessons_stage_answers_test {

using State = app::StageAnswer::State;

namespace {

/// Calls `visit` at every page of the lessons, while its question is open.
void atEveryPage(app::Course& course, const std::function<void()>& visit)
{
    for (std::size_t lesson = 0; lesson < app::lessons().size(); ++lesson)
        for (course.begin(lesson);; course.next()) {
            visit();
            course.showAnswer();
            if (course.atLastPage())
                break;
        }
}

app::FigureFrame frameOf(const app::Microscope& microscope, const QSizeF& size = {700, 600})
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(13);
    return app::figureFrame(microscope.tracedLine(), size, font);
}

bool asks(const app::Course& course, const char* kind)
{
    return course.isOpen()
           && course.lesson()->pages[course.page()].question->kind == QLatin1String(kind);
}
bool asksForAnEdge(const app::Course& course) { return asks(course, "edge"); }

} // namespace

class StageAnswersTest : public QObject {
    Q_OBJECT

private slots:
    void onlyEdgesAndPartsAreAnswersOnTheStage()
    {
        app::Microscope microscope;
        app::Course course(microscope);
        course.setSeed(0); // as the files have it
        int asked = 0;
        atEveryPage(course, [&] {
            const auto answers = app::stageAnswers(course, frameOf(microscope));
            QCOMPARE(answers.size(), std::size_t(asksForAnEdge(course)  ? 4
                                                 : asks(course, "part") ? 3
                                                                        : 0));
            asked += !answers.empty();
        });
        QVERIFY(asked >= 5);
    }
    void theRightPartIsInTheWindow()
    {
        app::Microscope microscope;
        app::Course course(microscope);
        course.setSeed(0); // as the files have it
        course.begin(0);
        QVERIFY(asks(course, "part"));
        const app::FigureFrame frame = frameOf(microscope);
        const auto answers = app::stageAnswers(course, frame);
        const auto& window = microscope.tracedLine().window;
        for (const auto& answer : answers) {
            const app::Point middle = frame.pointAt(answer.part.center());
            const bool inside = middle.x > window.min.x && middle.x < window.max.x
                                && middle.y > window.min.y && middle.y < window.max.y;
            QCOMPARE(inside, answer.choice == course.question()->right);
        }
    }
    void everyAnswerIsFoundAtItsPartAndItsDisc()
    {
        app::Microscope microscope;
        app::Course course(microscope);
        course.setSeed(0); // as the files have it
        atEveryPage(course, [&] {
            for (const QSizeF& size : {QSizeF(700, 600), QSizeF(340, 420), QSizeF(900, 300)}) {
                const app::FigureFrame frame = frameOf(microscope, size);
                const auto answers = app::stageAnswers(course, frame);
                for (const auto& answer : answers) {
                    QCOMPARE(app::answerAt(answers, answer.disc, frame),
                             std::optional(answer.choice));
                    QCOMPARE(app::answerAt(answers, answer.part.pointAt(0.4), frame),
                             std::optional(answer.choice));
                    QVERIFY(frame.picture().contains(answer.disc));
                    QCOMPARE(answer.state, State::Open); // says nothing about the right one
                }
                QVERIFY(!app::answerAt(answers, {-100, -100}, frame));
            }
        });
    }
    void noDiscLiesOnAnotherOrOnTheLine()
    {
        app::Microscope microscope;
        app::Course course(microscope);
        course.setSeed(0); // as the files have it
        atEveryPage(course, [&] {
            const app::FigureFrame frame = frameOf(microscope);
            const auto answers = app::stageAnswers(course, frame);
            const auto& line = microscope.tracedLine().line;
            const QLineF seen(frame.at(line.a), frame.at(line.b));
            for (const auto& answer : answers) {
                for (int i = 0; i <= 100; ++i)
                    QVERIFY(QLineF(answer.disc, seen.pointAt(i / 100.0)).length()
                            > app::discSize / 2);
                for (const auto& other : answers)
                    QVERIFY(other.choice == answer.choice
                            || QLineF(answer.disc, other.disc).length() > app::discSize);
            }
        });
    }
    void triesAndTheRightAnswerAreMarked()
    {
        app::Microscope microscope;
        app::Course course(microscope);
        course.setSeed(0); // as the files have it
        course.begin(1);
        while (!asksForAnEdge(course))
            course.isOpen() ? course.skip() : course.next();
        const int right = course.question()->right, wrong = right == 0 ? 1 : 0;
        const auto stateOf = [&](int choice) {
            return app::stageAnswers(course, frameOf(microscope))[std::size_t(choice)].state;
        };
        course.choose(wrong);
        QCOMPARE(stateOf(wrong), State::Wrong);
        QCOMPARE(stateOf(right), State::Open);
        course.choose(right);
        QCOMPARE(stateOf(wrong), State::Wrong);
        QCOMPARE(stateOf(right), State::Right);
        course.pause();
        QVERIFY(app::stageAnswers(course, frameOf(microscope)).empty());
    }
    void anotherLineHasNone()
    {
        app::Microscope microscope;
        app::Course course(microscope);
        course.setSeed(0); // as the files have it
        course.begin(1);
        while (!asksForAnEdge(course))
            course.isOpen() ? course.skip() : course.next();
        course.showAnswer();
        app::TracedLine other = microscope.tracedLine();
        other.line.a.x += 1;
        microscope.setTracedLine(other);
        QVERIFY(app::stageAnswers(course, frameOf(microscope)).empty());
    }
};

} // namespace lessons_stage_answers_test

TEST_CLASS(lessons_stage_answers_test::StageAnswersTest, Gui)
#include "tests/app/lessons/stage_answers_test.moc"
