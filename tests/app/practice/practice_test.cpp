// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/variants.h"
#include "app/practice/draw.h"
#include "app/practice/plan.h"
#include "app/practice/practice.h"
#include "app/practice/record.h"
#include "clipping/pseudo_code.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <map>
#include <set>

#include "tests/app/practice/player.h"
#include "tests/test_class.h"

namespace practice_practice_test {

using namespace app;

namespace {

constexpr std::uint64_t attempts = 200;

struct Attempt {
    TracedLine traced;
    std::uint64_t seed;
    std::vector<Move> moves;
};

/// Every variant once for each seed.
const std::vector<Attempt>& everyAttempt()
{
    static const auto all = [] {
        std::vector<Attempt> made;
        for (const Variant& variant : practiceVariants())
            for (std::uint64_t seed = 1; seed <= attempts; ++seed) {
                const TracedLine traced = practiceLine(variant, seed);
                made.push_back({traced, seed, movesOf(traced)});
            }
        return made;
    }();
    return all;
}

QByteArray about(const TracedLine& traced, std::uint64_t seed, const Move& move)
{
    return QStringLiteral("%1, seed %2, step %3: %4 (%5)")
        .arg(keyOf(traced.variant))
        .arg(seed)
        .arg(move.step + 1)
        .arg(move.prompt)
        .arg(move.right)
        .toUtf8();
}

/// An answer of at most two letters is in many words.
bool saysNothing(const QString& text, const Move& move, const QString& right)
{
    return right.size() < 3 || move.kind == MoveKind::Place || move.kind == MoveKind::Decide
           || !text.contains(right);
}

} // namespace

class PracticeTest : public QObject {
    Q_OBJECT

private slots:
    void bothFormsOfTheSevenAlgorithmsHavePlans()
    {
        const auto variants = practiceVariants();
        QCOMPARE(variants.size(), 14U);
        for (const Variant& variant : variants) {
            QVERIFY(variant.algorithm && !planOf(variant).empty());
            const auto code = clipping::linesOf(clipping::codeOf(*variant.algorithm, variant.form));
            for (const PlannedMove& planned : planOf(variant))
                QVERIFY2(clipping::lineOf(code, planned.label) > 0,
                         std::string(planned.label).c_str());
        }
        QVERIFY(planOf(exactVariant()).empty());
    }
    void aPlayerWhoReadsTheTracePasses()
    {
        for (const auto& [traced, seed, moves] : everyAttempt()) {
            QVERIFY2(moves.size() >= 4, qPrintable(keyOf(traced.variant)));
            QVERIFY(neededFirstTries(moves) <= int(moves.size()));
            const Narration narration = narrationOf(traced);
            for (const Move& move : moves)
                if (!isRight(move, playing::answerOfTrace(traced, narration, move)))
                    QFAIL(about(traced, seed, move));
        }
    }
    void randomAnswersPassAtMostOneInAHundred()
    {
        Random random(7);
        std::map<QString, int> passed;
        constexpr int plays = 20;
        for (const auto& [traced, seed, moves] : everyAttempt()) {
            const Variant& variant = traced.variant;
            const std::size_t lines =
                clipping::linesOf(clipping::codeOf(*variant.algorithm, variant.form)).size();
            const auto isByChance = [&](const Move& move) {
                return isRight(move, playing::randomAnswer(move, lines, random));
            };
            for (int k = 0; k < plays; ++k)
                passed[keyOf(variant)] +=
                    std::ranges::count_if(moves, isByChance) >= neededFirstTries(moves);
        }
        for (const auto& [variant, count] : passed)
            QVERIFY2(count * 100 <= int(attempts) * plays, qPrintable(variant));
    }
    /// A hint fits what was confused, and is not given for what is right.
    void everyMistakeHasItsHint()
    {
        std::set<std::string_view> kinds;
        for (const auto& [traced, seed, moves] : everyAttempt())
            for (const Move& move : moves)
                for (const Mistake& mistake : move.mistakes) {
                    kinds.insert(mistake.kind);
                    if (isRight(move, mistake.answer))
                        QFAIL(about(traced, seed, move));
                    const Mistake* found = mistakeOf(move, mistake.answer);
                    if (!found || found->hint != mistake.hint)
                        QFAIL(about(traced, seed, move));
                    QVERIFY(mistake.hint.size() > 20 && mistake.hint != move.hint);
                }
        for (const char* kind :
             {"left-right",  "above-below", "other-end",  "inside",    "missing",  "extra",
              "opposite",    "sides",       "not-beyond", "order",     "corner",   "swapped",
              "not-cut",     "on-window",   "wrong-edge", "not-moved", "same",     "as-if-true",
              "as-if-false", "backwards",   "skipped",    "sign",      "quotient", "axes",
              "ends",        "accepted",    "rejected",   "went-on"})
            QVERIFY2(kinds.contains(kind), kind);
    }
    void everyKindOfMoveOccurs()
    {
        std::map<QString, std::set<MoveKind>> kinds;
        for (const auto& [traced, seed, moves] : everyAttempt())
            for (const Move& move : moves)
                kinds[keyOf(traced.variant)].insert(move.kind);
        QCOMPARE(kinds.size(), practiceVariants().size());
        for (const auto& [variant, all] : kinds)
            QVERIFY2(all.size() >= 4 && all.contains(MoveKind::Place), qPrintable(variant));
    }
    /// While a move is open, the microscope has no step from that of the move on, and no text of
    /// the move says its answer.
    void theCoverHidesTheAnswer()
    {
        for (const Variant& variant : practiceVariants())
            for (std::uint64_t seed = 1; seed <= 20; ++seed) {
                Microscope microscope;
                Course course(microscope);
                Practice practice(microscope, course);
                practice.setSeed(seed);
                practice.begin(variant);
                const Narration plain = narrationOf(practice.tracedLine(), Sentences::Plain);
                for (; !practice.atEnd(); practice.next()) {
                    const Move& move = *practice.move();
                    QVERIFY(microscope.isCovered() && practice.asks());
                    QCOMPARE(microscope.narration().steps.size(), move.step);
                    QVERIFY(!microscope.narration().visible);
                    for (std::size_t k = 0; k < move.step; ++k)
                        QCOMPARE(microscope.narration().steps[k].sentence, plain.steps[k].sentence);
                    const QString right = answerText(move, move.right, YAxis::Up);
                    if (!saysNothing(move.prompt, move, right))
                        QFAIL(about(practice.tracedLine(), seed, move));
                    // The hint on a value has its operands, of which one may be as large.
                    if (move.kind != MoveKind::Value && !saysNothing(move.hint, move, right))
                        QFAIL(about(practice.tracedLine(), seed, move));
                    QVERIFY(practice.verdict().isEmpty());
                    practice.showAnswer();
                    QVERIFY(practice.verdict().contains(right));
                    QVERIFY(!practice.isOpen() && practice.rightAtOnce() == 0);
                    QCOMPARE(microscope.step(), // of two moves at one step the first is settled
                             std::min(move.step, microscope.narration().steps.size() - 1));
                }
                QVERIFY(!microscope.isCovered() && !practice.isPassed());
                QCOMPARE(practice.wrongMoves().size(), practice.moves().size());
            }
    }
    void aDamagedRecordIsHarmless()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        const Variant variant = practiceVariants().front();
        const QString key = keyOf(variant);
        QVERIFY(!recordOf(settings, variant));
        settings.setValue("practice/best/" + key, QStringLiteral("none"));
        QVERIFY(!recordOf(settings, variant));
        settings.setValue("practice/best/" + key, 1e9);
        QVERIFY(recordOf(settings, variant)->best <= 100);
        settings.setValue("practice/best/" + key, -5);
        settings.setValue("practice/passed/" + key, QStringList{"a", "b"});
        QCOMPARE(recordOf(settings, variant), (PracticeRecord{0, false}));
        keepRecord(settings, variant, {80, true});
        keepRecord(settings, variant, {50, false});
        QCOMPARE(recordOf(settings, variant), (PracticeRecord{80, true}));
    }
    void everySeedHasALineOfItsOwn()
    {
        std::map<QString, std::set<std::array<double, 4>>> lines;
        for (const auto& [traced, seed, moves] : everyAttempt()) {
            const auto& [a, b] = traced.line;
            lines[keyOf(traced.variant)].insert({a.x, a.y, b.x, b.y});
        }
        for (const auto& [variant, all] : lines)
            QVERIFY2(all.size() > attempts * 9 / 10, qPrintable(variant));
        const TracedLine& third = everyAttempt()[2].traced;
        QCOMPARE(practiceLine(third.variant, 3), third);
    }
};

} // namespace practice_practice_test

TEST_CLASS(practice_practice_test::PracticeTest, Core)
#include "tests/app/practice/practice_test.moc"
