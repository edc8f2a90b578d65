// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons cannot be passed by peeking: keys that are pressed blindly, or that were right in an
// earlier attempt, pass at most 1 % of the attempts. Whoever reads the values that are shown passes
// all of them.
#include "app/comparison/difference.h"
#include "app/comparison/variants.h"
#include "app/lessons/attempt.h"
#include "app/lessons/course.h"
#include "app/lessons/families.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <functional>
#include <set>

#include "tests/deep.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace lessons_attempt_test {

using namespace app;

namespace {

/// The question of a page in one attempt; empty if the page asks nothing.
std::optional<Question> questionIn(const LessonPage& page, std::uint64_t seed)
{
    const LessonPage drawn = drawnPage(page, seed);
    const Narration narration = narrationOf(drawn.tracedLine);
    const auto step = stepFor(drawn, narration);
    const auto question = step ? questionOf(drawn, narration, *step) : std::nullopt;
    return question ? std::optional(inNewOrder(*question, seed)) : std::nullopt;
}

/// For each attempt the keys that are right, from 0, question by question.
std::vector<std::vector<int>> rightKeys(const Lesson& lesson, int attempts)
{
    std::vector<std::vector<int>> all;
    std::uint64_t seed = 5;
    for (int i = 0; i < attempts; ++i) {
        std::vector<int> keys;
        for (const LessonPage& page : lesson.pages)
            if (page.question)
                keys.push_back(questionIn(page, seed = mixed(seed))->right);
        all.push_back(keys);
    }
    return all;
}

/// A way to press keys without reading: of an attempt, of a question.
using Blind = std::function<int(std::size_t attempt, std::size_t question)>;

int passedBlindly(const Lesson& lesson, const std::vector<std::vector<int>>& right,
                  const Blind& key)
{
    int passed = 0;
    for (std::size_t i = 0; i < right.size(); ++i) {
        int hits = 0;
        for (std::size_t k = 0; k < right[i].size(); ++k)
            hits += key(i, k) == right[i][k];
        passed += isPassed(hits, lesson);
    }
    return passed;
}

/// The choice that begins with these words.
int choiceOf(const Question& question, const QString& words)
{
    for (int i = 0; i < question.choices.size(); ++i)
        if (question.choices[i].startsWith(words))
            return i;
    return -1;
}

// A student who reads what is shown, and computes by hand.

QString outcodeByHand(const Point& p, const clipping::Window& w)
{
    return QString(p.y > w.max.y ? "1" : "0") + (p.y < w.min.y ? "1" : "0")
           + (p.x > w.max.x ? "1" : "0") + (p.x < w.min.x ? "1" : "0");
}

QString visibleByHand(const TracedLine& asked)
{
    const auto inside = [&](const Point& p) {
        return outcodeByHand(p, asked.window) == QStringLiteral("0000");
    };
    const auto& [a, b] = asked.line;
    if (inside(a) && inside(b))
        return QStringLiteral("All");
    if (inside(a) || inside(b))
        return QStringLiteral("A part: one");
    return clipped(exactVariant(), asked.line, asked.window) ? QStringLiteral("A part: both")
                                                             : QStringLiteral("Nothing");
}

/// What the run does next, by its pseudo-code.
QString eventAfter(const Narration& narration, std::size_t step)
{
    for (std::size_t i = step + 1; i < narration.steps.size(); ++i)
        switch (narration.steps[i].mark) {
        case Mark::Cut:
            return QStringLiteral("It cuts");
        case Mark::Accept:
            return QStringLiteral("It accepts");
        case Mark::Reject:
            return QStringLiteral("It rejects");
        case Mark::Divide:
            return QStringLiteral("It divides");
        default:
            break;
        }
    return {};
}

QString edgeAfter(const TracedLine& asked, const Narration& narration, std::size_t step)
{
    for (std::size_t i = step + 1; i < narration.steps.size(); ++i)
        if (narration.steps[i].mark == Mark::Cut)
            return "At " + edgeWords(narration.steps[i].edge, asked.y);
    return {};
}

QString cheaperByHand(const TracedLine& asked, const QStringList& words)
{
    const auto operations = [&](const Variant& variant) {
        TracedLine other = asked;
        other.variant = variant;
        const auto cost = narrationOf(other).steps.back().cost;
        return words[0] == "divisions"         ? cost.divisions
               : words[0] == "multiplications" ? cost.multiplications
               : words[0] == "additions"       ? cost.additions
                                               : cost.comparisons;
    };
    const Variant one = *findVariant(words[1]), other = *findVariant(words[2]);
    const auto ofOne = operations(one), ofOther = operations(other);
    return ofOne < ofOther   ? nameOf(one)
           : ofOther < ofOne ? nameOf(other)
           : ofOne > 0       ? QStringLiteral("Both")
                             : QStringLiteral("Neither");
}

QString rightByHand(const TracedLine& asked, const Narration& narration)
{
    const auto exact = clipped(exactVariant(), asked.line, asked.window);
    if (narration.outcome == clipping::Outcome::DidNotEnd)
        return QStringLiteral("No, it never ends");
    if (narration.visible.has_value() != exact.has_value())
        return exact ? QStringLiteral("No, it shows nothing") : QStringLiteral("No, it shows too");
    const auto& [a, b] = asked.line;
    const double most = 1e-9 * std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), 1.0});
    const bool isNear = !exact
                        || (glm::distance(narration.visible->a, exact->a) <= most
                            && glm::distance(narration.visible->b, exact->b) <= most);
    return isNear ? QStringLiteral("Yes") : QStringLiteral("No, an end");
}

/// Where a line that is cut twice has its ends afterwards, in the order of the choices.
QString edgesByHand(const TracedLine& asked)
{
    const auto seen = *clipped(exactVariant(), asked.line, asked.window);
    const auto& [min, max] = asked.window;
    QStringList edges;
    for (const auto& [edge, meets] :
         {std::pair{clipping::Edge::Left, seen.a.x == min.x || seen.b.x == min.x},
          std::pair{clipping::Edge::Right, seen.a.x == max.x || seen.b.x == max.x},
          std::pair{clipping::Edge::Bottom, seen.a.y == min.y || seen.b.y == min.y},
          std::pair{clipping::Edge::Top, seen.a.y == max.y || seen.b.y == max.y}})
        if (meets)
            edges << edgeWords(edge, asked.y);
    return edges.join(" and ");
}

/// A corner is left of a line that goes up there if its x is smaller than that of the line's point
/// at its height; and so on.
QString cornersByHand(const TracedLine& asked)
{
    const auto& [a, b] = asked.line;
    const auto& [min, max] = asked.window;
    int left = 0;
    for (const Point& corner : {min, Point(max.x, min.y), max, Point(min.x, max.y)}) {
        if (a.x == b.x)
            left += (corner.x < a.x) == (b.y > a.y);
        else
            left += (corner.y > a.y + (b.y - a.y) * (corner.x - a.x) / (b.x - a.x)) == (b.x > a.x);
    }
    return QStringList{"None", "One", "Two", "Three", "All"}[left];
}

int solved(const Course& course)
{
    const QuestionSpec& spec = *course.here().question;
    const TracedLine& asked = course.asked();
    const Narration narration = narrationOf(asked);
    const std::size_t step = *stepFor(course.here(), narration);
    const auto& [a, b] = asked.line;
    QString words;
    if (spec.kind == "region")
        words = outcodeByHand(spec.words[0] == "1" ? a : b, asked.window);
    else if (spec.kind == "visible")
        words = visibleByHand(asked);
    else if (spec.kind == "part")
        words = QStringLiteral("From the"); // neither from End 1 nor to End 2
    else if (spec.kind == "next")
        words = eventAfter(narration, step);
    else if (spec.kind == "edge")
        words = edgeAfter(asked, narration, step);
    else if (spec.kind == "edges")
        words = edgesByHand(asked);
    else if (spec.kind == "corners")
        words = cornersByHand(asked);
    else if (spec.kind == "cheaper")
        words = cheaperByHand(asked, spec.words);
    else
        words = rightByHand(asked, narration);
    const Question& question = *course.question();
    if (spec.kind == "part")
        for (int i = 0; i < question.choices.size(); ++i)
            if (!question.choices[i].contains("End"))
                return i;
    return choiceOf(question, words);
}

} // namespace

class AttemptTest : public QObject {
    Q_OBJECT

private slots:
    void everyPageDrawsFromItsFamilies()
    {
        int pages = 0;
        for (const Lesson& lesson : lessons())
            for (const LessonPage& page : lesson.pages) {
                if (page.families.isEmpty())
                    continue;
                ++pages;
                std::set<std::array<double, 4>> lines;
                for (std::uint64_t seed = 1; seed <= 40; ++seed) {
                    const LessonPage drawn = drawnPage(page, mixed(seed));
                    const auto& [a, b] = drawn.tracedLine.line;
                    lines.insert({a.x, a.y, b.x, b.y});
                    QVERIFY(questionIn(page, mixed(seed)).has_value() == page.question.has_value());
                    const bool fits = std::ranges::any_of(page.families, [&](const QString& key) {
                        return findLineFamily(key)->fits(drawn.tracedLine);
                    });
                    QVERIFY2(fits, qPrintable(lesson.key + ": " + page.text));
                    QVERIFY(drawnPage(page, mixed(seed)).tracedLine == drawn.tracedLine);
                }
                QVERIFY2(lines.size() > 30, qPrintable(lesson.key + ": " + page.text));
                QVERIFY(drawnPage(page, 0).tracedLine == page.tracedLine);
            }
        QVERIFY(pages > 40);
    }
    /// The lines of the files are examples of their families.
    void theFilesOwnLinesFit()
    {
        for (const Lesson& lesson : lessons())
            for (const LessonPage& page : lesson.pages)
                QVERIFY2(page.families.isEmpty()
                             || std::ranges::any_of(page.families,
                                                    [&](const QString& key) {
                                                        return findLineFamily(key)->fits(
                                                            page.tracedLine);
                                                    }),
                         qPrintable(lesson.key + ": " + page.text));
    }
    void choicesKeepTheirAnswerAndTheirParts()
    {
        const Question question{
            .prompt = "?",
            .choices = {"a", "b", "c"},
            .right = 1,
            .reason = {},
            .hint = {},
            .parts = {clipping::Edge::Left, clipping::Edge::Right, clipping::Edge::Top}};
        std::set<QString> orders;
        for (std::uint64_t seed = 1; seed < 200; ++seed) {
            const Question other = inNewOrder(question, seed);
            QCOMPARE(other.choices[other.right], "b");
            for (std::size_t i = 0; i < 3; ++i)
                QVERIFY(other.parts[i]
                        == question.parts[std::size_t(
                            question.choices.indexOf(other.choices[qsizetype(i)]))]);
            orders.insert(other.choices.join(u' '));
        }
        QCOMPARE(orders.size(), 6U);
        QCOMPARE(inNewOrder(question, 0).choices, question.choices);
    }
    /// One key for all questions, keys at random, and the keys that were right in the attempt
    /// before.
    void blindKeysDoNotPass()
    {
        constexpr int attempts = 1000;
        for (const Lesson& lesson : lessons()) {
            const auto right = rightKeys(lesson, attempts);
            std::vector<Blind> ways;
            for (int key = 0; key < 5; ++key)
                ways.emplace_back([key](std::size_t, std::size_t) { return key; });
            for (std::uint64_t seed = 1; seed < 4; ++seed)
                ways.emplace_back([seed](std::size_t attempt, std::size_t question) {
                    return int(mixed(seed * 1'000'003 + attempt * 101 + question) % 4);
                });
            ways.emplace_back([&](std::size_t attempt, std::size_t question) {
                return attempt == 0 ? 0 : right[attempt - 1][question];
            });
            for (const Blind& way : ways) {
                const int passed = passedBlindly(lesson, right, way);
                QVERIFY2(100 * passed <= attempts,
                         qPrintable(lesson.key + QString(": %1 of %2").arg(passed).arg(attempts)));
            }
        }
    }
    void whoReadsTheValuesPasses()
    {
        Microscope microscope;
        Course course(microscope);
        for (std::uint64_t seed = 1; seed <= std::uint64_t(100 / tests::caseStep()); ++seed)
            for (std::size_t i = 0; i < lessons().size(); ++i) {
                course.setSeed(mixed(seed));
                for (course.begin(i);; course.next()) {
                    if (course.isOpen()) {
                        const int answer = solved(course);
                        const QByteArray where =
                            (lessons()[i].key + ", page " + QString::number(course.page() + 1)
                             + ": " + course.question()->prompt)
                                .toUtf8();
                        QVERIFY2(answer == course.question()->right, where);
                        course.choose(answer);
                    }
                    if (course.atLastPage())
                        break;
                }
                QVERIFY(course.ending().startsWith("Passed"));
            }
    }
    void eachAttemptHasOtherLines()
    {
        Microscope microscope;
        Course course(microscope);
        std::set<QString> seen;
        for (int i = 0; i < 12; ++i) {
            course.begin(0);
            const auto& [a, b] = microscope.tracedLine().line;
            seen.insert(QString("%1 %2 %3 %4").arg(a.x).arg(a.y).arg(b.x).arg(b.y)
                        + course.question()->choices.join(u'|'));
        }
        QVERIFY2(seen.size() > 8, QByteArray::number(qulonglong(seen.size())));
    }
    /// Whoever leaves a question to look at its line elsewhere finds another one.
    void anOpenQuestionThatWasLeftHasAnotherLine()
    {
        Microscope microscope;
        Course course(microscope);
        course.begin(1);
        course.choose(course.question()->right);
        const TracedLine settled = microscope.tracedLine();
        course.next();
        int other = 0;
        for (int i = 0; i < 10; ++i) {
            const TracedLine line = microscope.tracedLine();
            course.end();
            QVERIFY(!microscope.isOpen());
            course.beginOrGoOn(1);
            QCOMPARE(course.page(), 1U);
            QVERIFY(course.isOpen() && microscope.isCovered());
            other += microscope.tracedLine() != line;
        }
        QVERIFY(other > 7);
        course.previous();
        QVERIFY(microscope.tracedLine() == settled && course.answer().right);
        QCOMPARE(course.question()->choices[course.question()->right],
                 course.question()->choices[course.answer().tries.back()]);
    }
};

} // namespace lessons_attempt_test

TEST_CLASS(lessons_attempt_test::AttemptTest, None)
#include "tests/app/lessons/attempt_test.moc"
