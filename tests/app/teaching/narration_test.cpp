// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/manual.h"
#include "app/teaching/microscope.h"

#include <QTest>

#include <bit>
#include <random>

#include "tests/test_class.h"

namespace teaching_narration_test {

namespace {

using clipping::Outcome;

bool sameBits(const clipping::Segment& p, const clipping::Segment& q)
{
    return std::bit_cast<std::array<std::uint64_t, 4>>(p)
           == std::bit_cast<std::array<std::uint64_t, 4>>(q);
}

QByteArray told(const app::TracedLine& tracedLine)
{
    const auto& [a, b] = tracedLine.line;
    return QStringLiteral("%1: %2 %3 %4 %5")
        .arg(app::keyOf(tracedLine.variant))
        .arg(a.x, 0, 'g', 17)
        .arg(a.y, 0, 'g', 17)
        .arg(b.x, 0, 'g', 17)
        .arg(b.y, 0, 'g', 17)
        .toUtf8();
}

constexpr clipping::Window window{{-100, -75}, {100, 75}};

/// Random lines; a third of them has ends on the edges' lines, or is axis-parallel, or a point.
class Lines {
public:
    explicit Lines(std::uint64_t seed) : random_(seed) {}
    clipping::Segment next()
    {
        const bool onEdges = count_++ % 3 == 0;
        const auto point = [&] {
            return onEdges ? app::Point(50 * onGrid_(random_), 37.5 * onGrid_(random_))
                           : app::Point(anywhere_(random_), anywhere_(random_));
        };
        const app::Point a = point();
        return {a, point()};
    }

private:
    std::mt19937_64 random_;
    std::uniform_real_distribution<double> anywhere_{-250, 250};
    std::uniform_int_distribution<int> onGrid_{-3, 3};
    int count_ = 0;
};

} // namespace

class NarrationTest : public QObject {
    Q_OBJECT

private slots:
    void endsWithWhatClipGives() // 10,000 random lines, every form of every row
    {
        Lines lines(5);
        for (int i = 0; i < 10'000; ++i) {
            const clipping::Segment line = lines.next();
            for (const app::Variant& variant : app::variants()) {
                const app::TracedLine tracedLine{variant, line, window, app::YAxis::Up, {}};
                const auto trace = app::functionsOf(variant).trace(line, window);
                const auto piece = app::clipped(variant, line, window);
                QVERIFY2(!trace.steps.empty(), told(tracedLine));
                QVERIFY2((trace.outcome == Outcome::Visible) == piece.has_value(),
                         told(tracedLine));
                QVERIFY2(!piece || sameBits(*piece, trace.visible), told(tracedLine));
                QVERIFY2(!piece || sameBits(*piece, trace.steps.back().segment), told(tracedLine));
            }
        }
    }
    void isTheTraceInWords()
    {
        Lines lines(7);
        for (int i = 0; i < 300; ++i) {
            const clipping::Segment line = lines.next();
            for (const app::Variant& variant : app::variants()) {
                const app::TracedLine tracedLine{variant, line, window, app::YAxis::Up, {}};
                const auto trace = app::functionsOf(variant).trace(line, window);
                const app::Narration narration = app::narrationOf(tracedLine);
                QCOMPARE(narration.steps.size(), trace.steps.size());
                for (std::size_t step = 0; step < trace.steps.size(); ++step)
                    QVERIFY2(sameBits(narration.steps[step].left, trace.steps[step].segment),
                             told(tracedLine));
                const app::Mark mark = trace.outcome == Outcome::Visible     ? app::Mark::Accept
                                       : trace.outcome == Outcome::DidNotEnd ? app::Mark::GiveUp
                                                                             : app::Mark::Reject;
                QVERIFY2(narration.steps.back().mark == mark, told(tracedLine));
            }
        }
    }
    void everyStepHasItsLineAndSentence()
    {
        std::mt19937_64 random(6);
        std::uniform_real_distribution<double> anywhere(-250, 250);
        for (int i = 0; i < 300; ++i)
            for (const app::Variant& variant : app::variants()) {
                const app::TracedLine tracedLine{
                    variant,
                    {{anywhere(random), anywhere(random)}, {anywhere(random), anywhere(random)}},
                    window,
                    i % 2 ? app::YAxis::Up : app::YAxis::Down,
                    {}};
                const app::Narration narration = app::narrationOf(tracedLine);
                clipping::OperationCounts before;
                for (const app::NarratedStep& narrated : narration.steps) {
                    QVERIFY2(narrated.line >= 1 && narrated.line <= narration.code.size(),
                             told(tracedLine));
                    QVERIFY2(!narrated.sentence.isEmpty(), told(tracedLine));
                    QVERIFY(narrated.variables.size() >= 4);
                    QVERIFY(narrated.cost.comparisons >= before.comparisons);
                    before = narrated.cost;
                }
            }
    }
    void refusesWithASentence()
    {
        const app::Variant exact = app::exactVariant();
        const auto refusal = [&](const clipping::Segment& line, const clipping::Window& w) {
            return app::narrationOf({exact, line, w, app::YAxis::Up, {}}).refusal;
        };
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(refusal({{0, 0}, {nan, 1}}, window).startsWith(QStringLiteral("x2")));
        QVERIFY(!refusal({{0, 0}, {1, 1}}, {{1, 1}, {0, 0}}).isEmpty());
        QVERIFY(refusal({{0, 0}, {1, 1}}, {{1, 1}, {1, 1}}).isEmpty()); // a point is a window
    }
    void edgesAreNamedAsTheyAreSeen()
    {
        QCOMPARE(app::edgeWords(clipping::Edge::Top, app::YAxis::Up), "the top edge");
        QCOMPARE(app::edgeWords(clipping::Edge::Top, app::YAxis::Down), "the bottom edge");
        QCOMPARE(app::edgeWords(clipping::Edge::Left, app::YAxis::Down), "the left edge");
    }
    void theMicroscopeStepsBackToTheSameState()
    {
        app::Microscope microscope;
        microscope.open(
            {app::exactVariant(), {{-160, -30}, {70, 130}}, window, app::YAxis::Up, {}});
        const std::size_t count = microscope.narration().steps.size();
        QVERIFY(count > 1);
        microscope.goTo(count + 5);
        QVERIFY(microscope.atEnd());
        const QString last = microscope.narrated()->sentence;
        microscope.goTo(0);
        microscope.previous();
        QCOMPARE(microscope.step(), 0U);
        microscope.goTo(count - 1);
        QCOMPARE(microscope.narrated()->sentence, last);
    }
    void pagesHavePseudoCode()
    {
        for (const auto& row : clipping::algorithms()) {
            const QStringList code = app::shownCode(row.correctedCode);
            QVERIFY2(code.size() > 5 && !code.last().isEmpty(), row.key.data());
            const QString page = app::pageOf(row);
            for (const QString& line : code)
                QVERIFY2(page.contains(line + u'\n'), qPrintable(line));
        }
        QCOMPARE(app::shownCode("if a  #x\n  b  #y z\nc"), (QStringList{"if a", "  b", "c"}));
    }
};

} // namespace teaching_narration_test

TEST_CLASS(teaching_narration_test::NarrationTest, None)
#include "tests/app/teaching/narration_test.moc"
