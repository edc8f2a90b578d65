// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/judgement.h"

#include "app/base/finite.h"
#include "app/base/text.h"
#include "app/comparison/ulps.h"
#include "clipping/algorithm.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace app::plug_in {
namespace {

using clipping::Segment;
using clipping::Window;

bool makesSense(const Question& q)
{
    return isFinite(q.line.a) && isFinite(q.line.b) && isFinite(q.window.min)
           && isFinite(q.window.max) && q.window.min.x <= q.window.max.x
           && q.window.min.y <= q.window.max.y;
}

std::optional<Segment> clipped(const Segment& line, const Window& window)
{
    static const auto clip = clipping::exactAlgorithm().corrected.clip;
    return clip(line, window);
}

/// Moves every edge outwards; inwards if `by` is negative. Numbers stay finite.
Window moved(const Window& window, double by)
{
    constexpr double most = std::numeric_limits<double>::max();
    const auto held = [=](double v) { return std::clamp(v, -most, most); };
    return {{held(window.min.x - by), held(window.min.y - by)},
            {held(window.max.x + by), held(window.max.y + by)}};
}

double beyond(double v, double low, double high) { return std::max({low - v, v - high, 0.0}); }
double beyond(const glm::dvec2& p, const Window& w)
{
    return std::max(beyond(p.x, w.min.x, w.max.x), beyond(p.y, w.min.y, w.max.y));
}

bool samePointBits(const glm::dvec2& p, const glm::dvec2& q)
{
    return std::bit_cast<std::array<std::uint64_t, 2>>(p)
           == std::bit_cast<std::array<std::uint64_t, 2>>(q);
}

/// Whether an end of the line that is inside differs from the end of the piece in any bit.
bool movedInside(const Question& q, const Segment& piece)
{
    const auto moves = [&](const glm::dvec2& from, const glm::dvec2& to) {
        return beyond(from, q.window) == 0 && !samePointBits(from, to);
    };
    return moves(q.line.a, piece.a) || moves(q.line.b, piece.b);
}

/// The fault of a piece where the exact result has a piece, too.
std::optional<Fault> misplaced(const Question& q, const Segment& piece, const Segment& exact,
                               const Contract& contract, double ulp)
{
    const double allowed = contract.ulps * ulp;
    if (endsApart(piece, exact, Ends::InOrder) <= allowed)
        return contract.strictness == Strictness::Clearcuts && movedInside(q, piece)
                   ? std::optional(Fault::Off)
                   : std::nullopt;
    return endsApart(piece, exact, Ends::EitherWay) <= allowed ? Fault::Turned : Fault::Off;
}

} // namespace

std::span<const FaultInfo> faults()
{
    static const std::vector<FaultInfo> all{
        {Fault::Crashed, "crashed", Text::tr("Crash"), Text::tr("crashes"), true},
        {Fault::DidNotEnd, "did-not-end", Text::tr("Does not end"), Text::tr("does not end"), true},
        {Fault::LeftProgram, "left-program", Text::tr("Ends the program"),
         Text::tr("ends the whole program instead of returning"), true},
        {Fault::WroteBeyond, "wrote-beyond", Text::tr("Writes beyond visible"),
         Text::tr("writes beside visible[0] to visible[3]"), false},
        {Fault::Nonsense, "nonsense", Text::tr("Keeps invalid input"),
         Text::tr("keeps lines where a number is infinite or NaN, or the window is inverted"),
         false},
        {Fault::NotANumber, "not-a-number", Text::tr("Not a number"),
         Text::tr("returns an end that is infinite, not a number, or was never written"), false},
        {Fault::Changed, "changed", Text::tr("Changes its result"),
         Text::tr("returns different results for the same line"), false},
        {Fault::Lost, "lost", Text::tr("Lost"), Text::tr("loses visible lines"), false},
        {Fault::Invented, "invented", Text::tr("Shown wrongly"),
         Text::tr("keeps lines of which nothing is visible"), false},
        {Fault::Outside, "outside", Text::tr("End outside"),
         Text::tr("returns ends outside the window"), false},
        {Fault::Turned, "turned", Text::tr("Wrong direction"),
         Text::tr("returns pieces in the opposite direction"), false},
        {Fault::Off, "off", Text::tr("End at the wrong place"),
         Text::tr("returns ends at the wrong place"), false},
    };
    return all;
}

const FaultInfo& infoOf(Fault fault) { return faults()[std::size_t(fault)]; }

QString wordOf(Strictness strictness)
{
    return strictness == Strictness::Clearcuts ? QStringLiteral("strict")
                                               : QStringLiteral("textbook");
}

Strictness strictnessOf(const QString& word)
{
    return word == wordOf(Strictness::Clearcuts) ? Strictness::Clearcuts : Strictness::Textbook;
}

std::optional<Segment> expected(const Question& question)
{
    return clipped(question.line, question.window);
}

Judgement judged(const Question& q, const Answer& answer, const Contract& contract,
                 double visibilityUlps)
{
    const auto piece = answer.piece();
    if (answer.wroteBeyond != 0)
        return {Fault::WroteBeyond};
    if (!makesSense(q))
        return {piece ? std::optional(Fault::Nonsense) : std::nullopt};
    const auto exact = expected(q);
    const double ulp = ulpFor(q.line, q.window), margin = visibilityUlps * ulp;
    if (!piece)
        return {exact && clipped(q.line, moved(q.window, -margin)) ? std::optional(Fault::Lost)
                                                                   : std::nullopt};
    if (!isFinite(piece->a) || !isFinite(piece->b))
        return {Fault::NotANumber};
    if (!exact && !clipped(q.line, moved(q.window, margin)))
        return {Fault::Invented};
    Judgement result{};
    result.outside = std::max(beyond(piece->a, q.window), beyond(piece->b, q.window)) / ulp;
    if (exact)
        result.off = endsApart(*piece, *exact, Ends::InOrder) / ulp;
    if (result.outside > (contract.strictness == Strictness::Clearcuts ? 0 : contract.ulps))
        result.fault = Fault::Outside;
    else if (exact)
        result.fault = misplaced(q, *piece, *exact, contract, ulp);
    return result;
}

} // namespace app::plug_in
