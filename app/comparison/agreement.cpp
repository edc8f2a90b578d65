// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/agreement.h"

#include "app/comparison/difference.h"
#include "app/view/numbers.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace app {

using namespace clipping;

namespace {

// Two rows keep their contract (at most 64 ulps each) if they are no farther apart.
constexpr double contractOfTwo = 128;

/// What more than half of the answers keep, as the first of them has it.
std::vector<Clipped> majorityOf(std::span<const std::vector<Clipped>> answers, std::size_t segments)
{
    std::vector<std::size_t> votes(segments, 0);
    for (const auto& answer : answers)
        for (const Clipped& piece : answer)
            ++votes[piece.source];
    std::vector<Clipped> kept;
    std::vector<bool> has(segments, false);
    for (const auto& answer : answers)
        for (const Clipped& piece : answer)
            if (2 * votes[piece.source] > answers.size() && !has[piece.source]) {
                has[piece.source] = true;
                kept.push_back(piece);
            }
    std::ranges::sort(kept, {}, &Clipped::source); // the first answer has nearly all
    return kept;
}

Dissent dissentOf(const Variant& variant, std::span<const Difference> fromMajority)
{
    const DifferenceCounts counts = counted(fromMajority);
    Dissent dissent{variant, counts.onlyB, counts.onlyA, counts.endsApart};
    for (const Difference& difference : fromMajority)
        dissent.segments.push_back(difference.source);
    return dissent;
}

QString counted(const char* one, const char* many, std::size_t count)
{
    return count == 1 ? QCoreApplication::translate("agreement", one)
                      : QCoreApplication::translate("agreement", many).arg(countText(count));
}

QString sentence(const Dissent& dissent)
{
    QStringList faults;
    if (dissent.lost)
        faults << counted("loses 1 line that is visible", "loses %1 lines that are visible",
                          dissent.lost);
    if (dissent.shown)
        faults << counted("keeps 1 line that is not visible", "keeps %1 lines that are not visible",
                          dissent.shown);
    if (dissent.moved)
        faults << counted("misplaces the ends of 1 line", "misplaces the ends of %1 lines",
                          dissent.moved);
    return nameOf(dissent.variant) + u' '
           + faults.join(QCoreApplication::translate("agreement", ", "));
}

} // namespace

std::vector<Dissent> dissents(std::span<const Segment> segments, const Window& window,
                              const Algorithm& chosen, Form form)
{
    std::vector<std::vector<Clipped>> answers;
    for (const Algorithm& algorithm : algorithms())
        answers.push_back(clipped(Variant{&algorithm}, segments, window));
    const auto majority = majorityOf(answers, segments.size());
    const Variant corrected{&chosen}; // stands for the majority: what it promises is the same
    std::vector<Dissent> found;
    const auto judge = [&](const Variant& variant, std::span<const Clipped> answer) {
        auto dissent = dissentOf(variant, differences(segments, window, answer, majority,
                                                      {contractOfTwo, endsOf(variant, corrected)}));
        if (!dissent.none())
            found.push_back(std::move(dissent));
    };
    if (form == Form::Published && chosen.published) {
        const Variant published{&chosen, form};
        judge(published, clipped(published, segments, window));
    }
    for (std::size_t i = 0; i < answers.size(); ++i)
        judge(Variant{&algorithms()[i]}, answers[i]);
    return found;
}

QString sentence(std::span<const Dissent> dissents)
{
    if (dissents.empty())
        return QCoreApplication::translate("agreement", "All algorithms, corrected, agree here");
    QStringList sentences;
    for (const Dissent& dissent : dissents)
        sentences << sentence(dissent);
    return sentences.join(QStringLiteral("; "));
}

} // namespace app
