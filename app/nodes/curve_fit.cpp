// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/curve_fit.h"

#include "app/nodes/node_types.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// After Philip J. Schneider, "An Algorithm for Automatically Fitting Digitized Curves", Graphics
// Gems, 1990: least squares for the lengths of both handles, then better parameters, in turn.

namespace app {
namespace {

constexpr std::size_t mostSamples = 2048;
constexpr std::size_t mostRatios = 64; // of more pieces the product of ratios is mostly rounding
constexpr int rounds = 12;

struct Sample {
    Point at;
    double t;
};

double length(const Point& p) { return std::hypot(p.x, p.y); }

/// About the arc length.
double lengthOf(const Bezier& c)
{
    const double polygon =
        length(c.control1 - c.from) + length(c.control2 - c.control1) + length(c.to - c.control2);
    return (polygon + length(c.to - c.from)) / 2;
}

/// Which share of the parameter each piece has, if they are parts of one curve: the speeds at a
/// joint are equal.
std::vector<double> sharesBySpeed(std::span<const Bezier> pieces)
{
    std::vector<double> shares{1};
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const double before = length(pieces[i - 1].to - pieces[i - 1].control2);
        const double after = length(pieces[i].control1 - pieces[i].from);
        const double byLength = lengthOf(pieces[i]) / std::max(lengthOf(pieces[i - 1]), 1e-300);
        const double ratio = before > 0 && after > 0 ? after / before : byLength;
        shares.push_back(shares.back() * std::clamp(ratio, 1e-3, 1e3));
    }
    return shares;
}

std::vector<double> sharesByLength(std::span<const Bezier> pieces)
{
    std::vector<double> shares;
    for (const Bezier& piece : pieces)
        shares.push_back(lengthOf(piece));
    return shares;
}

std::vector<Sample> sampled(std::span<const Bezier> pieces, const std::vector<double>& shares,
                            std::size_t places)
{
    double sum = 0;
    for (const double share : shares)
        sum += share;
    const std::size_t count = std::min(mostSamples, places * pieces.size());
    std::vector<Sample> samples;
    double before = 0;
    std::size_t piece = 0;
    for (std::size_t k = 1; k < count && sum > 0; ++k) {
        const double t = double(k) / double(count), u = t * sum;
        while (piece + 1 < pieces.size() && u > before + shares[piece])
            before += shares[piece++];
        const double within = shares[piece] > 0 ? (u - before) / shares[piece] : 0;
        samples.push_back({pieces[piece].at(std::clamp(within, 0.0, 1.0)), t});
    }
    return samples;
}

/// The direction in which a curve leaves its start.
Point startDirection(const Bezier& c)
{
    for (const Point& p : {c.control1, c.control2, c.to})
        if (p != c.from)
            return withLength(p - c.from, 1);
    return Point(0);
}

Bezier reversed(const Bezier& c) { return {c.to, c.control2, c.control1, c.from}; }

struct Fit {
    Point from, to, start, end; ///< the ends, and the unit vectors of the handles

    Bezier curve(double a, double b) const { return {from, from + start * a, to + end * b, to}; }

    Bezier leastSquares(std::span<const Sample> samples) const
    {
        double saa = 0, sab = 0, sbb = 0, ra = 0, rb = 0;
        for (const auto& [at, t] : samples) {
            const double s = 1 - t, b1 = 3 * t * s * s, b2 = 3 * t * t * s;
            const Point a = start * b1, b = end * b2;
            const Point rest = at - from * (s * s * s + b1) - to * (t * t * t + b2);
            saa += glm::dot(a, a);
            sab += glm::dot(a, b);
            sbb += glm::dot(b, b);
            ra += glm::dot(a, rest);
            rb += glm::dot(b, rest);
        }
        const double determinant = saa * sbb - sab * sab;
        double a = 0, b = 0;
        if (determinant > 1e-12 * saa * sbb) {
            a = (ra * sbb - rb * sab) / determinant;
            b = (rb * saa - ra * sab) / determinant;
        }
        if (!(a > 0)) { // a handle must not point backwards
            a = 0;
            b = sbb > 0 ? std::max(0.0, rb / sbb) : 0;
        } else if (!(b > 0)) {
            b = 0;
            a = saa > 0 ? std::max(0.0, ra / saa) : 0;
        }
        return curve(a, b);
    }
};

/// One step of Newton's method towards the nearest point of the curve.
double nearer(const Bezier& c, const Sample& sample)
{
    const double t = sample.t, s = 1 - t;
    const Point d0 = 3.0 * (c.control1 - c.from), d1 = 3.0 * (c.control2 - c.control1),
                d2 = 3.0 * (c.to - c.control2);
    const Point first = d0 * (s * s) + d1 * (2 * s * t) + d2 * (t * t);
    const Point second = 2.0 * ((d1 - d0) * s + (d2 - d1) * t);
    const Point off = c.at(t) - sample.at;
    const double slope = glm::dot(first, first) + glm::dot(off, second);
    return slope > 0 ? std::clamp(t - glm::dot(off, first) / slope, 0.0, 1.0) : t;
}

double errorOf(const Bezier& c, std::span<const Sample> samples)
{
    double sum = 0;
    for (const auto& [at, t] : samples) {
        const Point off = c.at(t) - at;
        sum += glm::dot(off, off);
    }
    return sum;
}

struct Candidate {
    Bezier curve{};
    double error = INFINITY;
};

Candidate better(const Fit& fit, std::vector<Sample> samples)
{
    Candidate best;
    for (int round = 0; round < rounds; ++round) {
        const Bezier curve = fit.leastSquares(samples);
        const double error = errorOf(curve, samples);
        if (error < best.error)
            best = {curve, error};
        for (Sample& sample : samples)
            sample.t = nearer(curve, sample);
    }
    return best;
}

Bezier fittedNearOrigin(std::span<const Bezier> pieces, std::size_t places)
{
    const Fit fit{pieces.front().from, pieces.back().to, startDirection(pieces.front()),
                  startDirection(reversed(pieces.back()))};
    Candidate best = better(fit, sampled(pieces, sharesByLength(pieces), places));
    if (pieces.size() <= mostRatios)
        if (const Candidate other = better(fit, sampled(pieces, sharesBySpeed(pieces), places));
            other.error < best.error)
            best = other;
    return best.curve;
}

} // namespace

Bezier fitted(std::span<const Bezier> pieces, std::size_t places)
{
    const Point origin = pieces.front().from, end = pieces.back().to;
    double size = 0; // of a point relative to the start, which makes products safe
    for (const Bezier& piece : pieces)
        for (const Point& p : {piece.control1, piece.control2, piece.to})
            size = std::max({size, std::abs(p.x - origin.x), std::abs(p.y - origin.y)});
    if (!(size > 0) || !std::isfinite(size))
        return {origin, origin, end, end};
    std::vector<Bezier> scaled;
    scaled.reserve(pieces.size());
    const auto near = [&](const Point& p) { return (p - origin) / size; };
    for (const Bezier& piece : pieces)
        scaled.push_back(
            {near(piece.from), near(piece.control1), near(piece.control2), near(piece.to)});
    const Bezier curve = fittedNearOrigin(scaled, places);
    return {origin, origin + curve.control1 * size, origin + curve.control2 * size, end};
}

} // namespace app
