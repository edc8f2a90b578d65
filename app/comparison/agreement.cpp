// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/agreement.h"

#include "app/view/numbers.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

using namespace clipping;

namespace {

/// What one form leaves of every segment: an index into `pieces`, or `invisible`.
struct Answer {
    static constexpr std::uint32_t invisible = std::numeric_limits<std::uint32_t>::max();
    std::vector<Clipped> pieces;
    std::vector<std::uint32_t> pieceOf;

    const clipping::Segment* visible(std::size_t segment) const
    {
        return pieceOf[segment] == invisible ? nullptr : &pieces[pieceOf[segment]].segment;
    }
};

Answer answerOf(const Uses<Segment, Window>& uses, std::span<const Segment> segments,
                const Window& window)
{
    Answer answer{std::vector<Clipped>(segments.size()),
                  std::vector<std::uint32_t>(segments.size(), Answer::invisible)};
    answer.pieces.resize(uses.clipAll(segments, window, answer.pieces));
    for (std::uint32_t i = 0; i < answer.pieces.size(); ++i)
        answer.pieceOf[answer.pieces[i].source] = i;
    return answer;
}

double magnitude(const Segment& s, const Window& w)
{
    return std::max({std::abs(s.a.x), std::abs(s.a.y), std::abs(s.b.x), std::abs(s.b.y),
                     std::abs(w.min.x), std::abs(w.min.y), std::abs(w.max.x), std::abs(w.max.y)});
}

bool apart(const Segment& one, const Segment& other, double allowed)
{
    const auto far = [&](double x, double y) { return !(std::abs(x - y) <= allowed); };
    return far(one.a.x, other.a.x) || far(one.a.y, other.a.y) || far(one.b.x, other.b.x)
           || far(one.b.y, other.b.y);
}

/// What the majority of the corrected forms says, segment by segment.
class Majority {
public:
    explicit Majority(const std::vector<Answer>& answers) : answers_(answers) {}

    const Segment* visible(std::size_t segment) const
    {
        std::size_t votes = 0;
        const Segment* first = nullptr;
        for (const Answer& answer : answers_)
            if (const Segment* piece = answer.visible(segment)) {
                first = first ? first : piece;
                ++votes;
            }
        return 2 * votes > answers_.size() ? first : nullptr;
    }

private:
    const std::vector<Answer>& answers_;
};

Difference differenceOf(const Algorithm& algorithm, Form form, const Answer& answer,
                        const Majority& majority, std::span<const Segment> segments,
                        const Window& window)
{
    Difference result{&algorithm, form};
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        const Segment* truth = majority.visible(i);
        const Segment* piece = answer.visible(i);
        // Both rows keep their contract (at most 64 ulps each) if they are no farther apart.
        const double allowed =
            128 * std::numeric_limits<double>::epsilon() * magnitude(segments[i], window);
        const bool moved = truth && piece && apart(*truth, *piece, allowed);
        result.lost += truth && !piece;
        result.shown += !truth && piece;
        result.moved += moved;
        if (!truth != !piece || moved)
            result.segments.push_back(i);
    }
    return result;
}

QString counted(const char* one, const char* many, std::size_t count)
{
    return count == 1 ? QCoreApplication::translate("agreement", one)
                      : QCoreApplication::translate("agreement", many).arg(countText(count));
}

QString sentence(const Difference& difference)
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("agreement", text); };
    const QLatin1StringView name(difference.algorithm->abbreviation.data(),
                                 qsizetype(difference.algorithm->abbreviation.size()));
    const QString who =
        difference.form == Form::Published ? tr("%1 as published").arg(name) : QString(name);
    QStringList faults;
    if (difference.lost)
        faults << counted("loses 1 line that is visible", "loses %1 lines that are visible",
                          difference.lost);
    if (difference.shown)
        faults << counted("keeps 1 line that is not visible", "keeps %1 lines that are not visible",
                          difference.shown);
    if (difference.moved)
        faults << counted("misplaces the ends of 1 line", "misplaces the ends of %1 lines",
                          difference.moved);
    return who + u' ' + faults.join(tr(", "));
}

} // namespace

std::vector<Difference> differences(std::span<const Segment> segments, const Window& window,
                                    const Algorithm& chosen, Form form)
{
    std::vector<Answer> answers;
    for (const Algorithm& algorithm : algorithms())
        answers.push_back(answerOf(algorithm.corrected, segments, window));
    const Majority majority(answers);
    std::vector<Difference> found;
    const auto judge = [&](const Algorithm& algorithm, Form which, const Answer& answer) {
        auto result = differenceOf(algorithm, which, answer, majority, segments, window);
        if (!result.none())
            found.push_back(std::move(result));
    };
    if (const auto* uses = usesOf(chosen, form); uses && form == Form::Published)
        judge(chosen, form, answerOf(*uses, segments, window));
    for (std::size_t i = 0; i < answers.size(); ++i)
        judge(algorithms()[i], Form::Corrected, answers[i]);
    return found;
}

QString sentence(std::span<const Difference> differences)
{
    if (differences.empty())
        return QCoreApplication::translate("agreement", "All algorithms agree here");
    QStringList sentences;
    for (const Difference& difference : differences)
        sentences << sentence(difference);
    return sentences.join(QStringLiteral("; "));
}

} // namespace app
