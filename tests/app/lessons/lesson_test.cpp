// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"

#include <QDir>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <random>

#include "tests/test_class.h"
#include "tests/verify.h"

namespace lessons_lesson_test {

using app::Course;
using app::Lesson;

namespace {

/// A course with the lines and choices of the lessons' files.
struct WrittenCourse : Course {
    explicit WrittenCourse(app::Microscope& microscope) : Course(microscope) { setSeed(0); }
};

app::LessonPage pageAbout(const char* look, const QStringList& words)
{
    const auto lesson = app::readLesson(QStringLiteral("x"),
                                        QStringLiteral("# T\n> S\n:: look %1\ntext").arg(look));
    app::LessonPage page = lesson.value->pages.front();
    page.question = app::QuestionSpec{words[0], words.mid(1)};
    return page;
}

std::optional<app::Question> asked(const char* look, const QStringList& words, std::size_t step = 0)
{
    const app::LessonPage page = pageAbout(look, words);
    return app::questionOf(page, app::narrationOf(page.tracedLine), step);
}

QString rightOf(const std::optional<app::Question>& question)
{
    return question ? question->choices.value(question->right) : QStringLiteral("no question");
}

QString whereIn(const Course& course)
{
    return QStringLiteral("%1, page %2").arg(course.lesson()->key).arg(course.page() + 1);
}

bool decides(const app::NarratedStep& narrated)
{
    return narrated.mark == app::Mark::Accept || narrated.mark == app::Mark::Reject
           || narrated.mark == app::Mark::GiveUp;
}

constexpr auto crossing = "cs line -160,-30 70,130 window -100,-75 100,75";
constexpr auto passing = "cs line -170,40 -20,150 window -100,-75 100,75";

// Answers the first `first` questions of a lesson right at once, and the others right at the second
// try, or not at all. Before the end nothing is said of the ending.
void answerAll(Course& course, int first, bool second)
{
    for (int asked = 0;; course.next()) {
        if (course.question()) {
            QVERIFY2(course.ending().isEmpty(), qPrintable(course.ending()));
            const int right = course.question()->right;
            if (++asked > first && !second)
                course.showAnswer();
            else if (asked > first)
                course.choose(right == 0 ? 1 : 0);
            if (course.isOpen())
                course.choose(right);
        }
        if (course.atLastPage())
            return;
        QVERIFY2(course.ending().isEmpty(), qPrintable(course.ending()));
    }
}

} // namespace

class LessonTest : public QObject {
    Q_OBJECT

private slots:
    // A file that the catalogue does not name, or that cannot be read, would be missing.
    void everyFileIsALesson()
    {
        QStringList files = QDir(QStringLiteral(":/lessons")).entryList(), read;
        QVERIFY(files.size() >= 6);
        for (const Lesson& lesson : app::lessons()) {
            read << lesson.key + QStringLiteral(".md");
            QVERIFY2(lesson.pages.size() >= 5, qPrintable(lesson.key));
            QVERIFY2(!lesson.title.isEmpty() && !lesson.summary.isEmpty(), qPrintable(lesson.key));
        }
        files.sort();
        read.sort();
        QCOMPARE(read, files);
    }
    void playsToTheEnd()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        for (std::size_t i = 0; i < app::lessons().size(); ++i) {
            course.begin(i);
            QVERIFY(microscope.isOpen());
            int questions = 0;
            for (;;) {
                const auto& page = app::lessons()[i].pages[course.page()];
                const QString where = whereIn(course);
                QVERIFY2(microscope.tracedLine() == page.tracedLine, qPrintable(where));
                QVERIFY2(course.question().has_value() == page.question.has_value(),
                         qPrintable(where)); // each question that is written can be asked
                QCOMPARE(course.isOpen(), page.question.has_value());
                if (const auto question = course.question()) {
                    ++questions;
                    QVERIFY2(question->choices.size() >= 3, qPrintable(where));
                    QCOMPARE(question->choices.size(), app::choicesOf(*page.question));
                    QCOMPARE(
                        QSet<QString>(question->choices.begin(), question->choices.end()).size(),
                        question->choices.size());
                    QVERIFY(question->right >= 0 && question->right < question->choices.size());
                    for (const QString& text : {question->prompt, question->reason, question->hint})
                        QVERIFY2(!text.isEmpty() && !text.contains(u'%'), qPrintable(where));
                    course.choose(question->right);
                    QVERIFY(!course.isOpen());
                }
                QVERIFY2(!microscope.narration().steps.empty(), qPrintable(where));
                if (course.atLastPage())
                    break;
                course.next();
            }
            QCOMPARE(course.score(), (app::Score{questions, questions}));
            QCOMPARE(app::questionsOf(*course.lesson()), questions);
        }
    }
    /// While a question is open: neither the text, nor the hint, nor a step says the answer.
    void nothingAnswersAnOpenQuestion()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        int asked = 0;
        for (std::size_t i = 0; i < app::lessons().size(); ++i)
            for (course.begin(i);; course.next()) {
                if (const auto question = course.question()) {
                    ++asked;
                    const QString where = whereIn(course);
                    const auto& page = app::lessons()[i].pages[course.page()];
                    const app::Narration whole = app::narrationOf(page.tracedLine);
                    const QString right = question->choices[question->right].section(
                        QStringLiteral("At "), -1); // "the left edge"
                    QVERIFY2(microscope.isCovered(), qPrintable(where));
                    const bool namesBoth = page.question->kind == QStringLiteral("cheaper");
                    for (const QString& text : {course.text(), course.told(), question->hint})
                        QVERIFY2(namesBoth || !text.contains(right),
                                 qPrintable(where + ": " + right));
                    for (const app::NarratedStep& narrated : microscope.narration().steps) {
                        QVERIFY2(!narrated.sentence.contains(right), qPrintable(where));
                        QVERIFY2(!question->reason.contains(narrated.sentence), qPrintable(where));
                    }
                    QVERIFY2(microscope.narration().steps.size() < whole.steps.size(),
                             qPrintable(where));
                    QVERIFY2(!microscope.narration().visible, qPrintable(where));
                    microscope.goTo(1000); // as End does, and the timeline
                    QVERIFY2(!microscope.narrated() || !decides(*microscope.narrated()),
                             qPrintable(where));
                    course.showAnswer();
                    QVERIFY2(!microscope.isCovered(), qPrintable(where));
                    QCOMPARE(microscope.narration().steps.size(), whole.steps.size());
                    QCOMPARE(course.told(), page.told);
                }
                if (course.atLastPage())
                    break;
            }
        QVERIFY(asked > 15);
    }
    void theLessonDoesNotGoOnWhileAQuestionIsOpen()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        course.begin(1);
        course.next();
        QCOMPARE(course.page(), 0U);
        course.showAnswer();
        course.next();
        QCOMPARE(course.page(), 1U);
    }
    void aWrongAnswerHasASecondTry()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        const auto wrongOf = [&](int which) {
            const int right = course.question()->right;
            return which < right ? which : which + 1;
        };
        course.begin(1);
        course.choose(wrongOf(0));
        QVERIFY(course.isOpen() && microscope.isCovered());
        course.choose(wrongOf(0)); // the same again is no try
        QVERIFY(course.isOpen());
        course.choose(course.question()->right);
        QCOMPARE(course.score(), (app::Score{1, 0}));
        course.choose(wrongOf(1)); // too late
        course.next();
        course.choose(wrongOf(0));
        course.choose(wrongOf(1));
        QVERIFY(!course.isOpen());
        QCOMPARE(course.score(), (app::Score{2, 0}));
        course.previous();
        QVERIFY(course.answer().wrong == 1 && course.answer().right);
        QVERIFY(!microscope.isCovered());
    }
    /// The line that is shown is the one that is asked about, also after an end was dragged.
    void theAnswerIsAboutTheLineThatIsShown()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        course.begin(1); // which outcode does End 2 have?
        const auto rightNow = [&] { return rightOf(course.question()); };
        QCOMPARE(rightNow(), "0100");
        const app::TracedLine own = microscope.tracedLine();
        app::TracedLine dragged = own;
        dragged.line.b = {-40, 0};
        microscope.setTracedLine(dragged);
        QVERIFY(microscope.isCovered() && course.isOpen());
        QCOMPARE(rightNow(), "0000");
        course.choose(course.question()->right);
        QCOMPARE(course.score(), (app::Score{1, 1}));
        QCOMPARE(microscope.tracedLine().line, dragged.line); // it is explained, too
        QVERIFY(!microscope.isCovered());
        QVERIFY(course.question()->reason.contains("inside the window"));
        QVERIFY(course.told().endsWith(course.lesson()->pages[0].told)
                && course.told() != course.lesson()->pages[0].told);
        microscope.setTracedLine(own); // now the reader only looks
        QCOMPARE(rightNow(), "0000");
        course.next();
        course.previous();
        QCOMPARE(microscope.tracedLine().line, dragged.line);
        QCOMPARE(rightNow(), "0000");
    }
    void anotherLineGivesNoFurtherTry()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        course.begin(1);
        course.choose(course.question()->right == 0 ? 1 : 0);
        app::TracedLine dragged = microscope.tracedLine();
        dragged.line.b = {-40, 0};
        microscope.setTracedLine(dragged);
        QVERIFY(course.isOpen());
        QVERIFY(course.answer().tries.empty()); // none about this line
        course.choose(course.question()->right == 0 ? 1 : 0);
        QVERIFY(!course.isOpen());
        QCOMPARE(course.score(), (app::Score{1, 0}));
    }
    /// Lines, algorithms and forms that readers may show beside any page.
    void noLineRevealsItsAnswer()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> number(-200, 200);
        int asked = 0, unasked = 0;
        for (std::size_t i = 0; i < app::lessons().size(); ++i)
            for (course.begin(i);; course.next()) {
                const app::LessonPage& page = app::lessons()[i].pages[course.page()];
                for (int k = 0; page.question && k < 30; ++k) {
                    app::TracedLine other = page.tracedLine;
                    other.line = {{number(random), number(random)},
                                  {number(random), number(random)}};
                    const auto& row =
                        clipping::algorithms()[random() % clipping::algorithms().size()];
                    if (k % 3 == 0)
                        other.variant = {&row};
                    k % 2 == 0 ? microscope.setTracedLine(other) : microscope.open(other);
                    const QByteArray where =
                        QStringLiteral("%1, line %2").arg(whereIn(course)).arg(k).toUtf8();
                    const app::Narration whole = app::narrationOf(other);
                    VERIFY_OR_SAY(microscope.isCovered() && course.isOpen(), where);
                    VERIFY_OR_SAY(!microscope.narration().visible, where);
                    microscope.goTo(1000);
                    VERIFY_OR_SAY(!microscope.narrated() || !decides(*microscope.narrated()),
                                  where);
                    ++(course.question() ? asked : unasked);
                    if (!course.question())
                        continue;
                    app::LessonPage about = page;
                    about.tracedLine = other;
                    VERIFY_OR_SAY(rightOf(course.question())
                                      == rightOf(app::questionOf(about, whole,
                                                                 app::wantedStep(about, whole))),
                                  where);
                    for (const app::NarratedStep& narrated : microscope.narration().steps)
                        VERIFY_OR_SAY(!course.question()->reason.contains(narrated.sentence),
                                      where);
                }
                course.showAnswer();
                QVERIFY2(!course.isOpen(), qPrintable(whereIn(course)));
                if (course.atLastPage())
                    break;
            }
        QVERIFY(asked > 300 && unasked > 5);
    }
    /// The list of lessons, the end of a lesson, and whatever else opens or closes the microscope.
    void nothingButAnAnswerUncoversTheAnswer()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        const auto reveals = [&](const app::TracedLine& own) {
            return microscope.isOpen() && !microscope.isCovered() && microscope.tracedLine() == own;
        };
        const std::vector<std::function<void(const app::TracedLine&)>> ways{
            [&](const auto&) { course.pause(); },
            [&](const auto&) { course.end(); },
            [&](const auto&) { course.next(); },
            [&](const auto&) { course.showAgain(); },
            [&](const app::TracedLine& own) { microscope.open(own, 3); },
            [&](const app::TracedLine& own) { microscope.setTracedLine(own); },
            [&](const app::TracedLine& own) { microscope.close(), microscope.open(own); },
            [&](const auto&) { course.pause(), course.beginOrGoOn(course.lessonIndex()); },
        };
        for (std::size_t i = 0; i < app::lessons().size(); ++i)
            for (std::size_t way = 0; way < ways.size(); ++way) {
                course.begin(i);
                while (!course.isOpen())
                    course.next();
                const app::TracedLine own = microscope.tracedLine();
                ways[way](own);
                QVERIFY2(!reveals(own), qPrintable(QString::number(way)));
            }
    }
    void thePausedLessonGoesOnAtItsPage()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        course.begin(1);
        course.choose(course.question()->right);
        course.next();
        course.pause();
        QVERIFY(!course.asks());
        course.choose(course.question()->right); // it is not seen
        QVERIFY(course.isOpen());
        course.beginOrGoOn(1);
        QVERIFY(course.asks());
        QCOMPARE(course.page(), std::size_t(1));
        QCOMPARE(course.score(), (app::Score{1, 1}));
        course.pause();
        course.beginOrGoOn(2); // another one begins
        QCOMPARE(course.page(), std::size_t(0));
        QCOMPARE(course.lessonIndex(), std::size_t(2));
    }
    void aSkippedQuestionEarnsNothing()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        course.begin(1);
        const std::size_t last = course.pages() - 1;
        while (course.page() < last) {
            const std::size_t page = course.page();
            course.skip();
            QCOMPARE(course.page(), page + 1);
            course.previous();
            QVERIFY(course.answer().shown && !microscope.isCovered());
            course.skip(); // it is not open
            QCOMPARE(course.page(), page);
            course.next();
        }
        course.skip(); // the answer is shown
        QVERIFY(course.atEnd());
        QCOMPARE(course.score(), (app::Score{int(course.pages()), 0}));
    }
    void anotherLineIsAway()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        QVERIFY(!course.isAway());
        for (course.begin(1);; course.next()) {
            const app::TracedLine own = microscope.tracedLine();
            QVERIFY(!course.isAway());
            app::TracedLine other = own;
            other.line.b.y += 1;
            microscope.setTracedLine(other);
            QVERIFY(course.isAway());
            microscope.setTracedLine(own);
            QVERIFY(!course.isAway());
            microscope.setTracedLine(other);
            course.showAgain();
            QVERIFY(!course.isAway());
            course.showAnswer();
            QVERIFY(!course.isAway());
            if (course.atLastPage())
                break;
        }
    }
    void aLessonThatWasLeftGoesOnAtItsPage()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        QVERIFY(!course.lessonToGoOn());
        course.begin(1);
        course.choose(course.question()->right);
        course.next();
        const app::TracedLine line = microscope.tracedLine();
        course.end();
        QVERIFY(!course.lesson() && !microscope.isOpen());
        QCOMPARE(course.lessonToGoOn(), std::optional(std::size_t(1)));
        QCOMPARE(course.pageToGoOn(), std::size_t(1));
        course.beginOrGoOn(1);
        QVERIFY(course.asks() && microscope.isCovered());
        QCOMPARE(microscope.tracedLine(), line);
        QCOMPARE(course.page(), std::size_t(1));
        QCOMPARE(course.score(), (app::Score{1, 1}));
        course.end();
        course.beginOrGoOn(2); // another one begins
        QCOMPARE(course.page(), std::size_t(0));
        QCOMPARE(course.score(), (app::Score{0, 0}));
        while (!course.atEnd()) {
            course.showAnswer();
            course.next();
        }
        course.end(); // a lesson that is read begins again
        QVERIFY(!course.lessonToGoOn());
    }
    void aLessonIsPassedByAShareOfFirstTries()
    {
        for (const Lesson& lesson : app::lessons()) {
            const int all = app::questionsOf(lesson), needed = app::neededRight(lesson);
            QVERIFY2(3 * needed >= 2 * all && needed < all, qPrintable(lesson.key));
            QVERIFY(!app::isPassed(needed - 1, lesson) && app::isPassed(needed, lesson));
        }
    }
    // Every number of questions right at the first try, then as many as are left at the second.
    void theEndSaysWhetherTheLessonIsPassed()
    {
        app::Microscope microscope;
        WrittenCourse course(microscope);
        for (std::size_t i = 0; i < app::lessons().size(); ++i) {
            const int questions = app::questionsOf(app::lessons()[i]);
            for (int first = 0; first <= questions; ++first)
                for (const bool second : {false, true}) {
                    course.begin(i);
                    answerAll(course, first, second);
                    const bool passed = first >= app::neededRight(app::lessons()[i]);
                    const QString said = QStringLiteral("%1: %2 of %3 right at the first try")
                                             .arg(passed ? "Passed" : "Not passed yet")
                                             .arg(first)
                                             .arg(questions);
                    const QString ending = course.ending();
                    QVERIFY2(ending.startsWith(said), qPrintable(ending + " != " + said));
                    QCOMPARE(ending.contains("are needed. Try the lesson again?"), !passed);
                    course.previous();
                    QCOMPARE(course.ending(), QString());
                }
        }
        course.end();
        QCOMPARE(course.ending(), QString());
    }
    void resultsAreKept()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.ini"));
        const Lesson& lesson = app::lessons()[1];
        const auto kept = [&] {
            return app::bestRight(QSettings(file, QSettings::IniFormat), lesson);
        };
        const auto keep = [&](int right) {
            QSettings settings(file, QSettings::IniFormat);
            app::keepRight(settings, lesson, right);
        };
        QVERIFY(!kept());
        keep(0);
        QCOMPARE(kept(), std::optional(0));
        keep(5);
        keep(3); // the best ones stay
        QCOMPARE(kept(), std::optional(5));
        for (const QVariant& hostile : {QVariant(1 << 30), QVariant(-7)}) {
            QSettings(file, QSettings::IniFormat)
                .setValue(QStringLiteral("lessons/right/outcodes"), hostile);
            QVERIFY(*kept() >= 0 && *kept() <= app::questionsOf(lesson));
        }
        QSettings(file, QSettings::IniFormat)
            .setValue(QStringLiteral("lessons/right/outcodes"), QStringLiteral("many"));
        QVERIFY(!kept());
    }
    void noPageSpeaksOfPartsThatItDoesNotShow()
    {
        static const QRegularExpression numbered(QStringLiteral("[Ss]tep \\d"));
        int questions = 0;
        for (const app::Lesson& lesson : app::lessons())
            for (const app::LessonPage& page : lesson.pages) {
                const app::Narration narration = app::narrationOf(page.tracedLine);
                const auto question =
                    app::questionOf(page, narration, app::wantedStep(page, narration));
                QStringList said{page.text, page.told};
                if (question)
                    said << question->prompt << question->reason << question->hint;
                questions += question.has_value();
                const QString all = said.join(u' ');
                QVERIFY2(page.shows.steps || !all.contains(numbered), qPrintable(all));
                QVERIFY2(page.shows.code || !all.contains("pseudo-code"), qPrintable(all));
                QVERIFY2(page.shows.variables || !all.contains("in the table"), qPrintable(all));
            }
        QVERIFY(questions > 20);
    }
    void theFirstLessonBeginsEasily()
    {
        for (const app::LessonPage& page : app::lessons().front().pages)
            QCOMPARE(app::keyOf(page.tracedLine.variant), QStringLiteral("cohen-sutherland"));
    }
    /// Where p is 0 it asks, and there the algorithm really does not divide.
    void theQuestionAboutParallelLinesIsAskedWherePIsZero()
    {
        const auto& pages = app::lessons()[2].pages;
        const app::LessonPage& page = *std::ranges::find_if(pages, [](const app::LessonPage& p) {
            return p.question && p.question->kind == QStringLiteral("next");
        });
        const app::Narration narration = app::narrationOf(page.tracedLine);
        const std::size_t step = app::wantedStep(page, narration);
        const auto& variables = narration.steps[step].variables;
        const auto p = std::ranges::find(variables, QStringLiteral("p"), &app::Variable::name);
        QVERIFY(p != variables.end() && p->value == 0);
        QCOMPARE(rightOf(app::questionOf(page, narration, step)), "It rejects the line");
        QCOMPARE(narration.steps.back().cost.divisions, narration.steps[step].cost.divisions);
    }
    void answersAreWhatBooksSay() // by hand
    {
        QCOMPARE(rightOf(asked(crossing, {"region", "1"})), "0001");
        QCOMPARE(rightOf(asked(crossing, {"region", "2"})), "1000");
        QCOMPARE(rightOf(asked(crossing, {"visible"})), "A part: both ends are cut");
        QCOMPARE(rightOf(asked(crossing, {"part"})), "From the left edge to the top edge");
        QCOMPARE(rightOf(asked("cs line 0,0 0,90 window -100,-75 100,75", {"visible"})),
                 "A part: one end is cut");
        QCOMPARE(rightOf(asked("cs line 0,0 0,9 window -100,-75 100,75", {"visible"})),
                 "All of it");
        QCOMPARE(rightOf(asked(passing, {"visible"})), "Nothing");
        QCOMPARE(rightOf(asked(crossing, {"edge"})), "At the left edge");
        QVERIFY(rightOf(asked(crossing, {"next"})).startsWith("It divides"));
        QCOMPARE(rightOf(asked(passing, {"cheaper", "divisions", "cs", "nln"})), "NLN");
        QCOMPARE(
            rightOf(asked("kwc:published line 10,-160 10.5,160 window -100,-75 100,75", {"right"})),
            "No, it shows nothing, but a part is visible");
        QCOMPARE(rightOf(asked("kwc line 10,-160 10.5,160 window -100,-75 100,75", {"right"})),
                 "Yes, apart from rounding");
        QCOMPARE(rightOf(asked("cs:published line 1,1 -1,-1 window 0.1,0.1 3,3", {"right"})),
                 "No, it never ends");
        QCOMPARE(rightOf(asked("md:published line -1,1.0000000000000004 3,0.9999999999999998 "
                               "window 0,0 1,1",
                               {"right"})),
                 "No, it shows too much");
        QCOMPARE(rightOf(asked(crossing, {"edges"})), "the left edge and the top edge");
        QVERIFY(!asked(passing, {"edges"}));
        QCOMPARE(rightOf(asked(crossing, {"corners"})), "One"); // the top left one
        QCOMPARE(rightOf(asked("cs line 70,130 -160,-30 window -100,-75 100,75", {"corners"})),
                 "Three");
        QVERIFY(!asked("cs line -150,-75 0,-75 window -100,-75 100,75", {"corners"}));
        QCOMPARE(rightOf(asked("skala:published line -1,0 1,0 window 0,0 2,2", {"right"})),
                 "No, it shows nothing, but a part is visible");
        QCOMPARE(rightOf(asked("skala:published line 1,0 -1,0 window 0,0 2,2", {"right"})),
                 "Yes, apart from rounding");
        QCOMPARE(rightOf(asked("nln:published line -1e200,5e199 1e200,-5e199 window -1,-1 1,1",
                               {"right"})),
                 "No, an end is in the wrong place");
        QVERIFY(!asked(crossing, {"region", "3"}));
        QVERIFY(!asked(crossing, {"nonsense"}));
        QVERIFY(!asked(passing, {"part"}));
    }
    /// What a page's texts name or use stands beside its figure.
    void pagesShowWhatTheyName()
    {
        const auto isExplained = [](const app::LessonPage& page, const app::LessonParts& shown) {
            const QString kind = page.question ? page.question->kind : QString();
            const QString text = page.text + page.told;
            const bool follows = kind == "next" || kind == "edge"; // read on in the code
            return (!follows || (shown.code && shown.variables && shown.steps))
                   && (!text.contains("table of variables") || shown.variables)
                   && (!text.contains("*Operations so far*") || shown.operations)
                   && (!text.contains("**Space**") || shown.steps);
        };
        int quiet = 0;
        for (const Lesson& lesson : app::lessons())
            for (const app::LessonPage& page : lesson.pages) {
                QVERIFY2(isExplained(page, page.shows), qPrintable(lesson.key + ": " + page.text));
                quiet += page.shows == app::LessonParts{};
            }
        QVERIFY(quiet >= 8);
    }
    void theFirstLessonShowsTheFigureAlone()
    {
        const auto& pages = app::lessons().front().pages;
        for (std::size_t i = 0; i + 1 < pages.size(); ++i)
            QCOMPARE(pages[i].shows, app::LessonParts{});
    }
    void partsAreKeptByTheFollowingPages()
    {
        const auto lesson = app::readLesson(
            QStringLiteral("x"),
            QStringLiteral("# T\n:: look cs line 0,0 1,1 window 0,0 1,1\na\n---\n"
                           ":: shows code steps\nb\n---\nc\n---\n:: shows nothing\nd"));
        QVERIFY(lesson);
        const auto& pages = lesson.value->pages;
        const app::LessonParts both{.code = true, .steps = true};
        QCOMPARE(pages[0].shows, app::LessonParts{});
        QCOMPARE(pages[1].shows, both);
        QCOMPARE(pages[2].shows, both);
        QCOMPARE(pages[3].shows, app::LessonParts{});
    }
    void errorsNameTheirLine()
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
        for (const char* parts : {"", " figure", " code nothing"})
            QVERIFY2(error(QByteArray("# T\n> S\n:: shows") + parts + "\nt").contains("line 3"),
                     parts);
        QVERIFY(error("# T\n> S\n:: hint of nothing\nt").contains("line 3"));
        for (const char* families : {"", " circle", " inside circle"})
            QVERIFY2(error(QByteArray("# T\n> S\n:: draw") + families + "\nt").contains("line 3"),
                     families);
        QVERIFY(error("# T\n> S\n:: ask next\n:: ask edge\nt").contains("line 4"));
        QVERIFY(!error("# T\ntext, but nothing to look at").isEmpty());
        QVERIFY(!error("").isEmpty());
    }
    void askingWhatFollowsLeavesComparisonsOut()
    {
        const auto question = asked(crossing, {"next"});
        QVERIFY(question);
        QCOMPARE(question->prompt, "Which step follows, not counting comparisons?");
    }

    // Readers take a person in place of an algorithm for a riddle.
    void noTeachingTextNamesAPersonForAThing()
    {
        const QRegularExpression person(QStringLiteral("\\b(some|no)body\\b"),
                                        QRegularExpression::CaseInsensitiveOption);
        int files = 0;
        for (const char* folder : {"lessons", "algorithms", "hard_cases"}) {
            const QDir texts(SOURCE_DIR "/resources/" + QString(folder));
            for (const QFileInfo& info : texts.entryInfoList({"*.md", "*.json"}, QDir::Files)) {
                QFile file(info.filePath());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const auto found = person.match(QString::fromUtf8(file.readAll()));
                QVERIFY2(!found.hasMatch(), qPrintable(info.fileName() + ": " + found.captured()));
                ++files;
            }
        }
        QVERIFY(files > 10);
    }

    void stepsAreFoundByTheirMark()
    {
        app::LessonPage page = pageAbout(crossing, {"visible"});
        const app::Narration narration = app::narrationOf(page.tracedLine);
        const auto markAt = [&](const char* step) {
            page.step = QString::fromLatin1(step);
            return narration.steps[app::wantedStep(page, narration)].mark;
        };
        QCOMPARE(markAt("cut"), app::Mark::Cut);
        QCOMPARE(markAt("cut-2"), app::Mark::Cut);
        QCOMPARE(markAt("last"), app::Mark::Accept);
        QCOMPARE(markAt("999"), app::Mark::Accept);
        QCOMPARE(markAt("reject"), app::Mark::Accept); // there is none: the last
        page.step = QStringLiteral("2");
        QCOMPARE(app::wantedStep(page, narration), 1U);
    }
};

} // namespace lessons_lesson_test

TEST_CLASS(lessons_lesson_test::LessonTest, None)
#include "tests/app/lessons/lesson_test.moc"
