// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"

#include <QDir>
#include <QTest>

using app::Course;
using app::Lesson;

namespace {

app::LessonPage pageAbout(const char* look, const QStringList& words)
{
    const auto lesson = app::readLesson(QStringLiteral("x"),
                                        QStringLiteral("# T\n> S\n:: look %1\ntext").arg(look));
    app::LessonPage page = lesson.value->pages.front();
    page.question = app::Asking{words[0], words.mid(1)};
    return page;
}

std::optional<app::Question> asked(const char* look, const QStringList& words, std::size_t step = 0)
{
    const app::LessonPage page = pageAbout(look, words);
    return app::questionOf(page, app::walkOf(page.specimen), step);
}

QString rightOf(const std::optional<app::Question>& question)
{
    return question ? question->choices.value(question->right) : QStringLiteral("no question");
}

constexpr auto crossing = "cs line -160,-30 70,130 window -100,-75 100,75";
constexpr auto passing = "cs line -170,40 -20,150 window -100,-75 100,75";

} // namespace

class LessonTest : public QObject {
    Q_OBJECT

private slots:
    void thereAreSixAndAllOfThemAreRead()
    {
        QCOMPARE(app::lessons().size(), 6U);
        QCOMPARE(QDir(QStringLiteral(":/lessons")).entryList().size(), 6);
        for (const Lesson& lesson : app::lessons()) {
            QVERIFY2(lesson.pages.size() >= 5, qPrintable(lesson.key));
            QVERIFY2(!lesson.title.isEmpty() && !lesson.summary.isEmpty(), qPrintable(lesson.key));
        }
    }
    void playsToTheEnd()
    {
        app::Microscope microscope;
        Course course(microscope);
        for (std::size_t i = 0; i < app::lessons().size(); ++i) {
            course.begin(i);
            QVERIFY(microscope.isOpen());
            int questions = 0;
            for (;;) {
                const auto& page = app::lessons()[i].pages[course.page()];
                const QString where =
                    QStringLiteral("%1, page %2").arg(course.lesson()->key).arg(course.page() + 1);
                QVERIFY2(microscope.specimen() == page.specimen, qPrintable(where));
                QVERIFY2(!microscope.walk().moments.empty(), qPrintable(where));
                QVERIFY2(course.question().has_value() == page.question.has_value(),
                         qPrintable(where)); // each question that is written can be asked
                if (const auto question = course.question()) {
                    ++questions;
                    QVERIFY2(question->choices.size() >= 2, qPrintable(where));
                    QCOMPARE(
                        QSet<QString>(question->choices.begin(), question->choices.end()).size(),
                        question->choices.size());
                    QVERIFY(question->right >= 0 && question->right < question->choices.size());
                    QVERIFY(!question->prompt.contains(u'%') && !question->reason.contains(u'%'));
                    course.choose(question->right);
                }
                if (course.atLastPage())
                    break;
                course.next();
            }
            QCOMPARE(course.questions(), questions);
            QCOMPARE(course.score(), (app::Score{questions, questions}));
        }
    }
    void onlyTheFirstAnswerCounts()
    {
        app::Microscope microscope;
        Course course(microscope);
        course.begin(1);
        const int right = course.question()->right;
        const int wrong = right == 0 ? 1 : 0;
        course.choose(wrong);
        course.choose(right);
        QCOMPARE(course.score(), (app::Score{1, 0}));
        course.next();
        course.previous();
        QCOMPARE(course.answer(), std::optional(wrong));
    }
    void answersAreWhatBooksSay() // by hand
    {
        QCOMPARE(rightOf(asked(crossing, {"region", "1"})), "0001");
        QCOMPARE(rightOf(asked(crossing, {"region", "2"})), "1000");
        QVERIFY(rightOf(asked(crossing, {"visible"})).startsWith("Yes"));
        QVERIFY(rightOf(asked(passing, {"visible"})).startsWith("No"));
        QCOMPARE(rightOf(asked(crossing, {"edge"})), "At the left edge");
        QVERIFY(rightOf(asked(crossing, {"next"})).startsWith("It divides"));
        QCOMPARE(rightOf(asked(passing, {"cheaper", "divisions", "cs", "nln"})), "NLN");
        QCOMPARE(
            rightOf(asked("kwc:published line 10,-160 10.5,160 window -100,-75 100,75", {"right"})),
            "No");
        QCOMPARE(rightOf(asked("kwc line 10,-160 10.5,160 window -100,-75 100,75", {"right"})),
                 "Yes, but for rounding");
        QCOMPARE(rightOf(asked("cs:published line 1,1 -1,-1 window 0.1,0.1 3,3", {"right"})), "No");
        QVERIFY(!asked(crossing, {"region", "3"}));
        QVERIFY(!asked(crossing, {"nonsense"}));
    }
    void whatIsWrongIsSaidWithItsLine()
    {
        const auto error = [](const char* text) {
            return app::readLesson(QStringLiteral("x"), QString::fromUtf8(text)).error;
        };
        QVERIFY(
            error("# T\n> S\n:: look nobody line 0,0 1,1 window 0,0 1,1\nt").contains("line 3"));
        QVERIFY(error("# T\n:: look cs line 0,0 1 window 0,0 1,1\nt").contains("line 2"));
        QVERIFY(error("# T\n:: dance\nt").contains("line 2"));
        for (const char* step : {"cutt", "0", "-1", "first-2", "cut-0", "cut-2-3"})
            QVERIFY2(error(QByteArray("# T\n> S\n:: step ") + step + "\nt").contains("line 3"),
                     step);
        QVERIFY(!error("# T\ntext, but nothing to look at").isEmpty());
        QVERIFY(!error("").isEmpty());
    }
    void stepsAreFoundByTheirMark()
    {
        app::LessonPage page = pageAbout(crossing, {"visible"});
        const app::Walk walk = app::walkOf(page.specimen);
        const auto markAt = [&](const char* step) {
            page.step = QString::fromLatin1(step);
            return walk.moments[app::wantedStep(page, walk)].mark;
        };
        QCOMPARE(markAt("cut"), app::Mark::Cut);
        QCOMPARE(markAt("cut-2"), app::Mark::Cut);
        QCOMPARE(markAt("last"), app::Mark::Accept);
        QCOMPARE(markAt("999"), app::Mark::Accept);
        QCOMPARE(markAt("reject"), app::Mark::Accept); // there is none: the last
        page.step = QStringLiteral("2");
        QCOMPARE(app::wantedStep(page, walk), 1U);
    }
};

QTEST_APPLESS_MAIN(LessonTest)
#include "lesson_test.moc"
