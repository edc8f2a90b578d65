// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/practice/draw.h"

#include "app/base/text.h"
#include "app/lessons/families.h"
#include "app/practice/plan.h"

#include <array>
#include <numeric>

namespace app {

namespace {

constexpr clipping::Window paperWindow{{-100, -75}, {100, 75}};
constexpr std::size_t fewestMoves = 4, mostMoves = 24;

/// Several times: those in which an algorithm has most to do.
constexpr std::array drawnFamilies{"both-ends", "both-ends", "both-ends", "one-end",
                                   "one-end",   "corner",    "beside"};

/// The probability that at least `least` answers are right by chance.
double chanceOfRight(int least, const std::vector<Move>& moves)
{
    std::vector<double> right{1}; // the probability of each number of right answers
    for (const Move& move : moves) {
        right.push_back(0);
        for (std::size_t k = right.size() - 1; k > 0; --k)
            right[k] += (right[k - 1] - right[k]) * move.chance;
        right[0] -= right[0] * move.chance;
    }
    return std::accumulate(right.begin() + least, right.end(), 0.0);
}

bool isFit(const TracedLine& traced)
{
    const auto* functions = clipping::functionsOf(*traced.variant.algorithm, traced.variant.form);
    if (functions->trace(traced.line, traced.window).outcome == clipping::Outcome::DidNotEnd)
        return false;
    const auto moves = movesOf(traced);
    return moves.size() >= fewestMoves && moves.size() <= mostMoves
           && neededFirstTries(moves) <= int(moves.size());
}

} // namespace

TracedLine practiceLine(const Variant& variant, std::uint64_t seed)
{
    TracedLine traced{.variant = variant,
                      .line = {{-160, -30}, {70, 130}}, // if none of many fits
                      .window = paperWindow,
                      .y = YAxis::Up,
                      .origin = Text::tr("Do it yourself")};
    const clipping::Segment usual = traced.line;
    constexpr int tries = 4000;
    Random random(mixed(seed));
    const LineFamily* family = nullptr;
    for (int k = 0; k < tries; ++k) {
        if (k % 200 == 0) { // one that fits may be rare in a family
            const auto which = std::size_t(random.between(0, double(drawnFamilies.size())));
            family = findLineFamily(latin(drawnFamilies.at(which)));
        }
        traced.line = family->draw(random, traced.window);
        if (!family->fits(traced))
            continue;
        if (isFit(traced))
            return traced;
        k += 199 - k % 200; // the others of the family will hardly fit
    }
    traced.line = usual;
    return traced;
}

int neededFirstTries(const std::vector<Move>& moves)
{
    constexpr double mostChance = 0.0065;
    const int all = int(moves.size());
    int needed = (2 * all + 2) / 3;
    while (needed <= all && chanceOfRight(needed, moves) > mostChance)
        ++needed;
    return needed;
}

} // namespace app
