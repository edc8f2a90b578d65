// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences of the steps: every step has its own, next to the right line of pseudo-code.
#include "app/teaching/manual.h"
#include "app/teaching/teaching.h"
#include "clipping/pseudo_code.h"

#include <QLocale>
#include <QMap>
#include <QRegularExpression>
#include <QTest>

#include <random>

#include "tests/clipping/inputs.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace teaching_sentences_test {

namespace {

using clipping::Edge;

constexpr clipping::Window window{{-100, -75}, {100, 75}};
constexpr clipping::Segment across{{-160, -30}, {70, 130}};

/// Lines of all kinds: random, with ends on the edges' lines, points, parallel to an axis.
std::vector<clipping::Segment> lines(int count)
{
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> anywhere(-250, 250);
    std::uniform_int_distribution<int> onGrid(-3, 3);
    std::vector<clipping::Segment> all;
    for (int i = 0; i < count; ++i) {
        const auto point = [&] {
            return i % 2 ? app::Point(anywhere(random), anywhere(random))
                         : app::Point(50 * onGrid(random), 37.5 * onGrid(random));
        };
        const auto a = point();
        all.push_back({a, point()});
    }
    return all;
}

/// Every form of every row of the library's catalogue, whether it has a row for teaching or not.
std::vector<app::Variant> toldVariants() { return notEmpty(app::variants()); }

QString sentenceOf(const app::Variant& variant, const app::SentenceContext& context)
{
    return app::sentenceOf(app::teachingOf(*variant.algorithm), context);
}

bool hasItsOwnWords(const app::Variant& variant)
{
    return app::teachingOf(*variant.algorithm).sentence != app::generalSentence;
}

/// Calls of(context) for each step of the line.
void forEachStep(const app::Variant& variant, const clipping::Segment& line,
                 const clipping::Window& w, app::YAxis y, const auto& of)
{
    const app::TracedLine tracedLine{variant, line, w, y, {}};
    const auto trace = clipping::functionsOf(*variant.algorithm, variant.form)->trace(line, w);
    const auto narration = app::narrationOf(tracedLine); // no steps for what is refused
    const clipping::Step* before = nullptr;
    for (std::size_t i = 0; i < notEmpty(trace.steps).size(); ++i) {
        const auto& step = trace.steps[i];
        of(app::SentenceContext{tracedLine, step, before,
                                i < narration.steps.size() ? narration.steps[i].variables
                                                           : std::vector<app::Variable>{}});
        before = &step;
    }
}

QByteArray told(const app::SentenceContext& context, const QString& sentence)
{
    const auto& [a, b] = context.tracedLine.line;
    return QStringLiteral("%1, %2 %3 to %4 %5, at %6 (%7): %8")
        .arg(app::keyOf(context.tracedLine.variant))
        .arg(a.x, 0, 'g', 17)
        .arg(a.y, 0, 'g', 17)
        .arg(b.x, 0, 'g', 17)
        .arg(b.y, 0, 'g', 17)
        .arg(QLatin1StringView(context.step.label.data(), qsizetype(context.step.label.size())),
             QLatin1StringView(context.step.name.data(), qsizetype(context.step.name.size())),
             sentence)
        .toUtf8();
}

/// The formal fault of a sentence; empty if it has none.
QString fault(const QString& sentence)
{
    static const QRegularExpression placeholder(QStringLiteral("%\\d"));
    static const QRegularExpression number(QStringLiteral("\\b(nan|inf)\\b"));
    if (sentence.isEmpty() || sentence.contains(QStringLiteral("  ")))
        return QStringLiteral("something is missing");
    if (sentence.contains(placeholder) || sentence.contains(number)
        || sentence.contains(QStringLiteral("::")))
        return QStringLiteral("no words");
    static const QRegularExpression begins(QStringLiteral("^([A-Z]|\\w+(\\[\\w+\\])? = )"));
    if (!begins.match(sentence).hasMatch() || !(sentence.endsWith(u'.') || sentence.endsWith(u'!')))
        return QStringLiteral("no sentence");
    return {};
}

/// The sentences of a line that is clipped, y up.
QStringList sentences(const char* key, const clipping::Segment& line,
                      const clipping::Window& w = window)
{
    QStringList all;
    const auto narration =
        app::narrationOf({*app::findVariant(QLatin1StringView(key)), line, w, app::YAxis::Up, {}});
    for (const auto& narrated : narration.steps)
        all << QStringLiteral("%1: %2").arg(narrated.line).arg(narrated.sentence);
    return all;
}

void compareLists(const QStringList& actual, const QStringList& expected)
{
    for (qsizetype i = 0; i < std::min(actual.size(), expected.size()); ++i)
        QCOMPARE(actual[i], expected[i]);
    QCOMPARE(actual.size(), expected.size());
}

} // namespace

class SentencesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void everyRowHasItsAlgorithm()
    {
        for (const auto& teaching : notEmpty(app::teachings())) {
            QVERIFY2(clipping::findAlgorithm(teaching.key), teaching.key.data());
            QCOMPARE(std::ranges::count(app::teachings(), teaching.key, &app::Teaching::key), 1);
        }
    }

    /// An algorithm with its own sentences has one for every step.
    void everyStepHasASentence()
    {
        for (const app::Variant& variant : toldVariants())
            for (const auto& line : lines(300))
                for (const auto y : {app::YAxis::Up, app::YAxis::Down}) {
                    QByteArray wrong;
                    forEachStep(variant, line, window, y, [&](const app::SentenceContext& context) {
                        const QString sentence = sentenceOf(variant, context);
                        if (!fault(sentence).isEmpty())
                            wrong = told(context, sentence);
                        const auto own = app::teachingOf(*variant.algorithm).sentence;
                        if (own(context).isEmpty())
                            wrong = told(context, "has no words of its row");
                    });
                    QVERIFY2(wrong.isEmpty(), wrong);
                }
    }

    /// The general sentences, for an algorithm without its own, are well-formed for every step.
    /// Steps at different lines of the pseudo-code have different sentences, unless the lines are
    /// alike. An algorithm's own sentences differ from the general ones, except for the one that
    /// accepts.
    void generalSentencesAreSentences()
    {
        for (const app::Variant& variant : toldVariants()) {
            const QStringList code = app::codeOf(variant);
            const auto labelled =
                clipping::linesOf(clipping::codeOf(app::rowOf(variant), variant.form));
            for (const auto& line : lines(40)) {
                QByteArray wrong;
                QMap<QString, QString> saidAt; // the line of the code, by the sentence
                forEachStep(
                    variant, line, window, app::YAxis::Up, [&](const app::SentenceContext& t) {
                        const QString sentence = app::generalSentence(t);
                        const QString at =
                            code.value(clipping::lineOf(labelled, t.step.label) - 1).trimmed();
                        const bool isEnd = t.step.what == clipping::What::Cut
                                           || t.step.what == clipping::What::Reject
                                           || t.step.name == "left";
                        if (!fault(sentence).isEmpty())
                            wrong = told(t, sentence);
                        if (!isEnd && saidAt.value(sentence, at) != at
                            && !clipping::codeOf(app::rowOf(variant), variant.form).empty())
                            wrong = told(t, sentence + " is said of " + saidAt[sentence]);
                        saidAt[sentence] = at;
                        if (hasItsOwnWords(variant) && !variant.misprint
                            && t.step.what != clipping::What::Accept
                            && sentenceOf(variant, t) == sentence)
                            wrong = told(t, sentence);
                    });
                QVERIFY2(wrong.isEmpty(), wrong);
            }
        }
    }

    /// Numbers of any size, windows without area, lines that only touch.
    void hardCasesHaveSentences()
    {
        for (const Family& family : families()) {
            const auto& inputs = family.inputs();
            for (const app::Variant& variant : toldVariants())
                for (std::size_t i = 0; i < inputs.size() && i < 100; ++i) {
                    QByteArray wrong;
                    const auto& [segment, w] = inputs[i];
                    forEachStep(variant, segment, w, app::YAxis::Up,
                                [&](const app::SentenceContext& context) {
                                    const QString sentence = sentenceOf(variant, context);
                                    if (!fault(sentence).isEmpty())
                                        wrong = told(context, sentence);
                                    if (i < 3 && context.step.cost.comparisons < 100)
                                        if (const QString general = app::generalSentence(context);
                                            !fault(general).isEmpty())
                                            wrong = told(context, general);
                                });
                    QVERIFY2(wrong.isEmpty(), wrong);
                }
        }
    }

    /// With y down, the screen's top edge is ymin.
    void edgesAreNamedAsSeenOnTheScreen()
    {
        static const QRegularExpression vertical(
            QStringLiteral("\\b(top|bottom|above|below|up|down)\\b"));
        int different = 0;
        for (const app::Variant& variant : toldVariants())
            for (const auto& line : lines(200)) {
                QStringList up, down;
                const auto say = [&](QStringList& into) {
                    return [&](const app::SentenceContext& t) { into << sentenceOf(variant, t); };
                };
                forEachStep(variant, line, window, app::YAxis::Up, say(up));
                forEachStep(variant, line, window, app::YAxis::Down, say(down));
                const auto trace = app::functionsOf(variant).trace(line, window);
                for (qsizetype i = 0; i < up.size(); ++i) {
                    const Edge edge = trace.steps[std::size_t(i)].edge;
                    if ((edge == Edge::Top || edge == Edge::Bottom) && up[i].contains(vertical)) {
                        QVERIFY2(up[i] != down[i], up[i].toUtf8());
                        ++different;
                    }
                }
            }
        QVERIFY(different > 100);
    }

    /// The highlighted line of the pseudo-code does what the step's mark shows.
    void linesFitTheMarks()
    {
        static const QRegularExpression assigns(QStringLiteral("=|move|exchange"));
        static const QRegularExpression asks(QStringLiteral("\\b(if|while|until|repeat)\\b"));
        for (const app::Variant& variant : toldVariants())
            for (const auto& line : lines(200)) {
                const auto narration =
                    app::narrationOf({variant, line, window, app::YAxis::Up, {}});
                for (const auto& narrated : notEmpty(narration.steps)) {
                    QVERIFY(narrated.line >= 1 && narrated.line <= narration.code.size());
                    const QString& code = narration.code[narrated.line - 1];
                    const QByteArray where =
                        QStringList{app::keyOf(variant), code, narrated.sentence}
                            .join(u'/')
                            .toUtf8();
                    if (narrated.mark == app::Mark::Accept)
                        QVERIFY2(code.contains(QStringLiteral("accept")), where);
                    else if (narrated.mark == app::Mark::Reject)
                        QVERIFY2(code.contains(QStringLiteral("reject")), where);
                    else if (narrated.mark == app::Mark::Cut)
                        QVERIFY2(code.contains(assigns), where);
                    else if (narrated.answer)
                        QVERIFY2(code.contains(asks), where);
                }
            }
    }

    void pseudoCodeIsPlain()
    {
        for (const app::Variant& variant : toldVariants())
            for (const QString& code : notEmpty(app::codeOf(variant)))
                for (const QChar c : code)
                    QVERIFY2(c.unicode() >= 32 && c.unicode() < 127, code.toUtf8());
    }

    /// Computed by hand: the slope is 160/230, and the left edge is 60 to the right of x = -160.
    void matthesDrakopoulos()
    {
        compareLists(
            sentences("md:published", across),
            {"1: From x = −160 to x = 70 the line lies neither wholly left nor wholly right of the "
             "window (−100 to 100): x does not rule it out.",
             "3: From y = −30 to y = 130 the line lies neither wholly above nor wholly below the "
             "window (−75 to 75): y does not rule it out.",
             "7: End 1 lies left of the window (−160 < −100), so it has to move along the line to "
             "the left edge.",
             "8: From End 1 to the left edge, x changes by 60. For each unit of x, y changes by "
             "0.695652; in all, y changes by 41.7391.",
             "9: End 1 moves along the line to the left edge, to (−100, 11.7391). The part beyond "
             "that edge is removed.",
             "13: End 1 does not lie below the window (11.7391 > −75), so the bottom edge does not "
             "cut it.",
             "16: End 1 does not lie above the window (11.7391 < 75), so the top edge does not cut "
             "it.",
             "7: End 2 does not lie left of the window (70 > −100), so the left edge does not cut "
             "it.",
             "10: End 2 does not lie right of the window (70 < 100), so the right edge does not "
             "cut it.",
             "13: End 2 does not lie below the window (130 > −75), so the bottom edge does not cut "
             "it.",
             "16: End 2 lies above the window (130 > 75), so it has to move along the line to the "
             "top edge.",
             "17: From End 1 to the top edge, y changes by 105. For each unit of y, x changes by "
             "1.4375; in all, x changes by 150.938.",
             "18: End 2 moves along the line to the top edge, to (−9.0625, 75). The part beyond "
             "that edge is removed.",
             "19: The ends are now at x = −100 and x = −9.0625, neither both left nor both right "
             "of the window: the algorithm concludes that the line meets it.",
             "21: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
             "window: it is visible."});
    }
    void cohenSutherland()
    {
        compareLists(
            sentences("cs:published", across),
            {"1: The outcodes say where the ends lie: End 1 has 0001 (left), End 2 has 1000 "
             "(above).",
             "3: At least one end is outside, because 0001 | 1000 = 1001 is not 0000: the line "
             "cannot be accepted yet.",
             "5: No edge has both ends beyond it, because 0001 & 1000 = 0000: the line cannot be "
             "rejected yet.",
             "8: End 1 is outside, with the outcode 0001 (left), so End 1 is cut.",
             "9: The bit of the top edge is not set in 0001: End 1 is not cut at that edge.",
             "11: The bit of the bottom edge is not set in 0001: End 1 is not cut at that edge.",
             "13: The bit of the right edge is not set in 0001: End 1 is not cut at that edge.",
             "16: From End 1 to the left edge, x changes by 60. There the line is at (−100, "
             "11.7391).",
             "17: The outcode is that of End 1, so End 1 is cut.",
             "18: End 1 moves along the line to the left edge, to (−100, 11.7391). The part beyond "
             "that edge is removed. Its outcode is now 0000 (inside).",
             "3: At least one end is outside, because 0000 | 1000 = 1000 is not 0000: the line "
             "cannot be accepted yet.",
             "5: No edge has both ends beyond it, because 0000 & 1000 = 0000: the line cannot be "
             "rejected yet.",
             "8: End 1 is inside and End 2 is outside, with the outcode 1000 (above), so End 2 is "
             "cut.",
             "9: The bit of the top edge is set in 1000: End 2 lies above the window and is cut at "
             "that edge.",
             "10: From End 1 to the top edge, y changes by 63.2609. There the line is at (−9.0625, "
             "75).",
             "17: The outcode is not that of End 1, so End 2 is cut.",
             "20: End 2 moves along the line to the top edge, to (−9.0625, 75). The part beyond "
             "that edge is removed. Its outcode is now 0000 (inside).",
             "3: Both ends are inside, because 0000 | 0000 = 0000: the line can be accepted.",
             "4: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
             "window: it is visible."});
    }
    void cohenSutherlandCorrected()
    {
        compareLists(
            sentences("cs", across),
            {"1: The outcodes say where the ends lie: End 1 has 0001 (left), End 2 has 1000 "
             "(above).",
             "4: At least one end is outside, because 0001 | 1000 = 1001 is not 0000: the line "
             "cannot be accepted yet.",
             "5: No edge has both ends beyond it, because 0001 & 1000 = 0000: the line cannot be "
             "rejected yet.",
             "7: End 1 is outside, with the outcode 0001 (left), so End 1 is cut.",
             "8: The cut starts from the original position of End 1, (−160, −30).",
             "11: The bit of the top edge is not set in 0001: End 1 is not cut at that edge.",
             "15: The bit of the bottom edge is not set in 0001: End 1 is not cut at that edge.",
             "19: The bit of the right edge is not set in 0001: End 1 is not cut at that edge.",
             "24: From End 1 to the left edge, x changes by 60. Meanwhile y changes by 41.7391.",
             "25: End 1 moves along the line to the left edge, to (−100, 11.7391). The part beyond "
             "that edge is removed.",
             "26: The distance that End 1 has moved, compared with its distances to the other "
             "edges, gives the outcode 0000 (inside).",
             "27: An edge that has cut End 1 does not cut it again. The bits of these edges, 0001, "
             "are cleared, so the outcode is 0000 (inside).",
             "4: At least one end is outside, because 0000 | 1000 = 1000 is not 0000: the line "
             "cannot be accepted yet.",
             "5: No edge has both ends beyond it, because 0000 & 1000 = 0000: the line cannot be "
             "rejected yet.",
             "7: End 1 is inside and End 2 is outside, with the outcode 1000 (above), so End 2 is "
             "cut.",
             "10: The cut starts from the original position of End 2, (70, 130).",
             "11: The bit of the top edge is set in 1000: End 2 lies above the window and is cut "
             "at that edge.",
             "12: From End 2 to the top edge, y changes by −55. Meanwhile x changes by −79.0625.",
             "13: End 2 moves along the line to the top edge, to (−9.0625, 75). The part beyond "
             "that edge is removed.",
             "14: The distance that End 2 has moved, compared with its distances to the other "
             "edges, gives the outcode 0000 (inside).",
             "27: An edge that has cut End 2 does not cut it again. The bits of these edges, 1000, "
             "are cleared, so the outcode is 0000 (inside).",
             "4: Both ends are inside, because 0000 | 0000 = 0000: the line can be accepted.",
             "28: Rounding has put no end outside the window, so both stay where they are.",
             "29: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
             "window: it is visible."});
    }
    void cohenSutherlandSaysThatItNeverEnds()
    {
        const auto said = sentences("cs:published", {{1, 1}, {-1, -1}}, {{0.1, 0.1}, {3, 3}});
        QVERIFY2(said.last().startsWith("7: After 64 cuts"), said.last().toUtf8());
    }
    void liangBarsky()
    {
        const QString entry("%1: At the %2 edge, p = %3 < 0: the line enters. %4");
        const QString exit("%1: At the %2 edge, p = %3 > 0: the line leaves. %4");
        compareLists(
            sentences("lb:published", across),
            {"13: The whole line remains, from u0 = 0 (End 1) to u1 = 1 (End 2). From End 1 to End "
             "2, x changes by 230.",
             entry.arg("14", "left", "−230", "q = −60 < 0: End 1 is beyond that edge."),
             "2: p = −230 is less than 0: at the left edge the line enters.",
             "3: The line enters across the left edge at r = q/p = 0.26087 (0 is End 1, 1 is End "
             "2).",
             "4: The entry is not after the end of the remaining part (0.26087 < 1), so something "
             "may be visible.",
             "5: Of all entries so far, the one at the left edge is the last (0.26087 > 0).",
             "6: The remaining part begins at the left edge, at u0 = 0.26087.",
             exit.arg("15", "right", "230", "q = 260: End 1 is not beyond that edge."),
             "2: p = 230 is not less than 0: at the right edge the line does not enter.",
             "7: p = 230 is greater than 0: at the right edge the line leaves.",
             "8: The line leaves across the right edge at r = q/p = 1.13043 (0 is End 1, 1 is End "
             "2).",
             "9: The exit is not before the start of the remaining part (1.13043 > 0.26087), so "
             "something may be visible.",
             "10: The exit at the right edge is not before the end of the remaining part (1.13043 "
             "> 1): this edge cuts nothing off.",
             "16: From End 1 to End 2, y changes by 160.",
             entry.arg("17", "bottom", "−160", "q = 45: End 1 is not beyond that edge."),
             "2: p = −160 is less than 0: at the bottom edge the line enters.",
             "3: The line enters across the bottom edge at r = q/p = −0.28125 (0 is End 1, 1 is "
             "End 2).",
             "4: The entry is not after the end of the remaining part (−0.28125 < 1), so something "
             "may be visible.",
             "5: The entry at the bottom edge is not after the start of the remaining part "
             "(−0.28125 < 0.26087): this edge cuts nothing off.",
             exit.arg("18", "top", "160", "q = 105: End 1 is not beyond that edge."),
             "2: p = 160 is not less than 0: at the top edge the line does not enter.",
             "7: p = 160 is greater than 0: at the top edge the line leaves.",
             "8: The line leaves across the top edge at r = q/p = 0.65625 (0 is End 1, 1 is End "
             "2).",
             "9: The exit is not before the start of the remaining part (0.65625 > 0.26087), so "
             "something may be visible.",
             "10: Of all exits so far, the one at the top edge is the first (0.65625 < 1).",
             "11: The remaining part ends at the top edge, at u1 = 0.65625.",
             "19: u1 = 0.65625 is less than 1: End 2 lies outside and has to move.",
             "20: End 2 moves along the line to the top edge, to (−9.0625, 75). The part beyond "
             "that edge is removed.",
             "21: u0 = 0.26087 is greater than 0: End 1 lies outside and has to move.",
             "22: End 1 moves along the line to the left edge, to (−100, 11.7391). The part beyond "
             "that edge is removed.",
             "23: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
             "window: it is visible."});
    }
    /// The corrected form, of a line that touches a corner and of one that is inside.
    void liangBarskyCorrected()
    {
        const auto touching = sentences("lb", {{-200, 25}, {0, 125}});
        compareLists(touching.last(7),
                     {"20: u1 = 0.5 is less than 1: End 2 lies outside and has to move.",
                      "22: End 2 moves along the line to the top edge, to (−100, 75). The part "
                      "beyond that edge is removed.",
                      "25: u0 = 0.5 is greater than 0: End 1 lies outside and has to move.",
                      "26: End 1 moves along the line to the left edge, to (−100, 75). The part "
                      "beyond that edge is removed.",
                      "28: The remaining part begins where it ends (0.5 = 0.5): the line only "
                      "touches the window.",
                      "29: End 1 becomes the same point as End 2, (−100, 75).",
                      "32: The line meets the window in a single point, (−100, 75): that point is "
                      "visible."});
        const auto inside = sentences("lb", {{0, 0}, {50, 50}});
        compareLists(inside.last(5),
                     {"20: u1 = 1: End 2 is inside and stays.",
                      "24: End 2 lies in the window, at (50, 50): it stays where it is.",
                      "25: u0 = 0: End 1 is inside and stays.",
                      "31: End 1 lies in the window, at (0, 0): it stays where it is.",
                      "32: Both ends lie inside the window, so all of the line is visible."});
        const auto missing = sentences("lb:published", {{-200, 50}, {0, 150}});
        compareLists(missing.last(2), {"9: The exit at the top edge comes before the start of the "
                                       "remaining part (0.25 < 0.5).",
                                       "9: Nothing of the line is visible."});
    }
    /// The published normals are as long as the edges, 200 and 150.
    void cyrusBeck()
    {
        const auto edge = [](const char* name, const char* normal, const char* d, const char* n,
                             const char* t) {
            return QStringList{
                QString("3: The inner normal of the %1 edge is (%2). It is as long as that edge.")
                    .arg(name, normal),
                QString("4: The inner normal of the %1 edge is (%2). Along it, the line advances "
                        "by D = "
                        "%3 from End 1 to End 2.")
                    .arg(name, normal, d),
                QString("5: Along the same normal, End 1 lies N = %2 inside the %1 edge (N < 0: "
                        "beyond it).")
                    .arg(name, n),
                QString("6: D = %2 is not 0: the infinite line through both ends crosses the line "
                        "of the %1 edge.")
                    .arg(name, d),
                QString("9: The line crosses the %1 edge at t = −N/D = %2 (0 is End 1, 1 is End "
                        "2).")
                    .arg(name, t)};
        };
        compareLists(
            sentences("cb:published", across),
            QStringList{"1: The whole line remains, from tE = 0 (End 1) to tL = 1 (End 2). From "
                        "End 1 to End 2, x changes by 230 and y by 160."}
                + edge("bottom", "0, 200", "32000", "9000", "−0.28125")
                + QStringList{"10: D = 32000 is greater than 0: at the bottom edge the line "
                              "enters.",
                              "11: The entry at the bottom edge is not after the start of the "
                              "remaining part (−0.28125 < 0): this edge cuts nothing off."}
                + edge("right", "−150, 0", "−34500", "39000", "1.13043")
                + QStringList{"10: D = −34500 is less than 0: at the right edge the line leaves.",
                              "13: The exit at the right edge is not before the end of the "
                              "remaining part (1.13043 > 1): this edge cuts nothing off."}
                + edge("top", "0, −200", "−32000", "21000", "0.65625")
                + QStringList{"10: D = −32000 is less than 0: at the top edge the line leaves.",
                              "13: Of all exits so far, the one at the top edge is the first "
                              "(0.65625 < 1).",
                              "14: The remaining part ends at the top edge, at tL = 0.65625."}
                + edge("left", "150, 0", "34500", "−9000", "0.26087")
                + QStringList{
                    "10: D = 34500 is greater than 0: at the left edge the line enters.",
                    "11: Of all entries so far, the one at the left edge is the last (0.26087 > "
                    "0).",
                    "12: The remaining part begins at the left edge, at tE = 0.26087.",
                    "15: The last entry comes no later than the first exit (tE = 0.26087, tL = "
                    "0.65625): the part between them is visible.",
                    "16: tL = 0.65625 is less than 1: End 2 lies outside and has to move.",
                    "17: End 2 moves along the line to the top edge, to (−9.0625, 75). The part "
                    "beyond that edge is removed.",
                    "18: tE = 0.26087 is greater than 0: End 1 lies outside and has to move.",
                    "19: End 1 moves along the line to the left edge, to (−100, 11.7391). The part "
                    "beyond that edge is removed.",
                    "20: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside "
                    "the window: it is visible."});
    }
    void cyrusBeckSaysThatTheWindowHasNoArea()
    {
        const auto said = sentences("cb:published", {{0, 3}, {6, 3}}, {{1, 3}, {5, 3}});
        QVERIFY2(said.last().contains("that is wrong"), said.last().toUtf8());
    }
    void exact()
    {
        compareLists(
            sentences("exact", across),
            {"1: The ends lie neither both left of the window nor both right of the window: the "
             "line may meet the window.",
             "3: The ends lie neither both below the window nor both above the window: the line "
             "may meet the window.",
             "6: From End 1 to End 2, x grows (−160 < 70) and y grows (−30 < 130).",
             "7: So the left edge is the near edge, where the line can enter, and the right edge "
             "is the far edge, where it can leave.",
             "8: So the bottom edge is the near edge, where the line can enter, and the top edge "
             "is the far edge, where it can leave.",
             "9: End 1 is beyond the left edge (−160 < −100).",
             "10: End 1 is not beyond the bottom edge (−30 > −75).",
             "11: End 2 is not beyond the right edge (70 < 100).",
             "12: End 2 is beyond the top edge (130 > 75).",
             "13: The line reaches the left edge no later than the top edge, so it does not pass "
             "the corner between them on the outside. Rounding cannot change this decision.",
             "15: The line does not have to enter at the bottom edge and leave at the right edge, "
             "so it cannot pass the corner between them on the outside.",
             "17: End 1 is beyond the left edge and no other edge: it is cut there.",
             "18: End 1 moves along the line to the left edge, to (−100, 11.7391): the true point, "
             "rounded once.",
             "21: End 2 is not beyond the right edge.",
             "23: End 2 is beyond the top edge: it is cut there.",
             "24: End 2 moves along the line to the top edge, to (−9.0625, 75): the true point, "
             "rounded once.",
             "25: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
             "window: it is visible."});
    }
    void midpointSubdivision()
    {
        const auto said = sentences("ms:published", across);
        compareLists(
            said.first(14),
            {"1: The outcodes say where the ends lie: End 1 has 0001 (left), End 2 has 1000 "
             "(above).",
             "2: No edge has both ends beyond it, because 0001 & 1000 = 0000: the line may meet "
             "the window.",
             "5: End 2 is outside (1000): halving searches for the visible point nearest to it.",
             "6: The near point has the outcode 0001 (left), the far point 1000 (above).",
             "14: The near point (0001) and the far point (1000) have no bit in common: the end "
             "that is sought lies between them.",
             "17: The midpoint between the near and the far point is (−45, 50).",
             "18: The midpoint lies between the two points and halves the line between them.",
             "22: The outcode of the midpoint is 0000 (inside).",
             "23: The midpoint, with the outcode 0000 (inside), has no bit in common with the far "
             "point: the end that is sought lies between them, in the far half.",
             "26: The midpoint, with the outcode 0000 (inside), becomes the near point.",
             "14: The near point (0000) and the far point (1000) have no bit in common: the end "
             "that is sought lies between them.",
             "17: The midpoint between the near and the far point is (12.5, 90).",
             "18: The midpoint lies between the two points and halves the line between them.",
             "22: The outcode of the midpoint is 1000 (above)."});
        QVERIFY(said.contains(
            "23: The midpoint, with the outcode 1000 (above), and the far point lie beyond the "
            "same edge: the half between them is invisible and is dropped."));
        QVERIFY(said.contains("7: There is nothing left to halve: End 2 is found at (−9.0625, 75), "
                              "on the top edge."));
        QVERIFY(said.contains(
            "8: End 1 is outside (0001): halving searches for the visible point nearest to it."));
        const auto lost = sentences("ms:published", {{-1, -4}, {6, 45}}, {{0, 0}, {3, 3}});
        QVERIFY2(lost.last().contains("That is wrong: the line touches the window at (0, 3)."),
                 lost.last().toUtf8());
    }
    void matthesDrakopoulosSaysWhatIsWrong()
    {
        const double u = 0x1p-52;
        const auto said =
            sentences("md:published", {{-1, 1 + 2 * u}, {3, 1 - u}}, {{0, 0}, {1, 1}});
        QVERIFY2(said.last().endsWith("this is wrong."), said.last().toUtf8());
        const auto lost =
            sentences("md:published", {{-1e-300, -1e300}, {2e-300, 1e300}}, {{0, 0}, {1, 1}});
        QVERIFY(!lost.filter("The slope overflows (infinity)").empty());
    }
};

} // namespace teaching_sentences_test

TEST_CLASS(teaching_sentences_test::SentencesTest, None)
#include "tests/app/teaching/sentences_test.moc"
