// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hard_cases/case_answer.h"

#include "app/base/finite.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/comparison/ulps.h"
#include "app/comparison/variants.h"
#include "app/teaching/line_text.h"

#include <algorithm>
#include <cmath>

namespace app {

using clipping::Segment;
using clipping::Window;

namespace {

double beyond(const Segment& piece, const Window& w)
{
    double most = 0;
    for (const auto& p : {piece.a, piece.b})
        for (glm::length_t k = 0; k < 2; ++k)
            most = std::max({most, w.min[k] - p[k], p[k] - w.max[k]});
    return most;
}

bool didNotEnd(const Variant& variant, const HardCase& hard)
{
    return functionsOf(variant).trace(hard.line, hard.window).outcome
           == clipping::Outcome::DidNotEnd;
}

/// Whether the line is visible if all edges of the window are moved outwards by that many ulps.
bool meetsMoved(const HardCase& hard, double ulps)
{
    const double way = ulps * ulpFor(hard.line, hard.window);
    const Window moved{hard.window.min - way, hard.window.max + way};
    return clipping::exactAlgorithm().corrected.clip(hard.line, moved).has_value();
}

/// The ruling on a wrong visibility: Allowed if the contract excuses it.
Ruling excusedOr(Ruling wrong, const HardCase& hard, const Variant& variant)
{
    if (variant.form == clipping::Form::Published || variant == exactVariant())
        return wrong;
    const double k = variant.algorithm->ulps;
    const bool near = wrong == Ruling::Shown ? meetsMoved(hard, k) : !meetsMoved(hard, -k);
    return near ? Ruling::Allowed : wrong;
}

Ruling rulingOf(const CaseAnswer& answer, const HardCase& hard)
{
    if (!answer.visible) {
        if (didNotEnd(answer.variant, hard))
            return Ruling::DidNotEnd;
        return hard.visible ? excusedOr(Ruling::Lost, hard, answer.variant) : Ruling::Right;
    }
    if (!isFinite(*answer.visible))
        return Ruling::NotANumber;
    if (!hard.visible)
        return excusedOr(Ruling::Shown, hard, answer.variant);
    if (answer.beyond > 0)
        return Ruling::Outside;
    return answer.ulps > answer.variant.algorithm->ulps ? Ruling::Moved : Ruling::Right;
}

/// Two significant digits show how bad the error is.
QString roughText(double length) { return shortText(length, length >= 10 && length < 1e6 ? 3 : 2); }

QString point(const glm::dvec2& p) { return pairText(exactText(p.x), exactText(p.y)); }

} // namespace

CaseAnswer answerOf(const HardCase& hard, const Variant& variant)
{
    CaseAnswer answer{.variant = variant, .visible = clipped(variant, hard.line, hard.window)};
    if (answer.visible && isFinite(*answer.visible)) {
        answer.beyond = beyond(*answer.visible, hard.window);
        if (hard.visible)
            answer.ulps = endsApart(*answer.visible, *hard.visible, endsOf(variant, exactVariant()))
                          / ulpFor(hard.line, hard.window);
    }
    answer.ruling = rulingOf(answer, hard);
    return answer;
}

std::vector<CaseAnswer> answersTo(const HardCase& hard)
{
    std::vector<CaseAnswer> answers;
    for (const Variant& variant : variants())
        answers.push_back(answerOf(hard, variant));
    return answers;
}

QString answerText(const CaseAnswer& answer)
{
    switch (answer.ruling) {
    case Ruling::Right:
        return Text::tr("right");
    case Ruling::Allowed:
        return Text::tr("within the guaranteed %1 ulps").arg(answer.variant.algorithm->ulps);
    case Ruling::Lost:
        return Text::tr("lost");
    case Ruling::Shown:
        return Text::tr("shown but not visible");
    case Ruling::Outside:
        return Text::tr("outside the window by %1").arg(roughText(answer.beyond));
    case Ruling::Moved:
        return Text::tr("ends at the wrong place");
    case Ruling::NotANumber:
        return Text::tr("not a number");
    case Ruling::DidNotEnd:
        break;
    }
    return Text::tr("never ends (was stopped)");
}

QString pieceText(const std::optional<Segment>& piece)
{
    if (!piece)
        return Text::tr("nothing");
    if (piece->a == piece->b)
        return Text::tr("the point %1").arg(point(piece->a));
    return Text::tr("%1 to %2").arg(point(piece->a), point(piece->b));
}

} // namespace app
