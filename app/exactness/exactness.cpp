// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/exactness.h"

#include "app/base/finite.h"
#include "app/comparison/ulps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

using clipping::Clipped;
using clipping::Segment;
using clipping::Window;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool isOutside(const glm::dvec2& p, const Window& w)
{
    return !(p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y);
}

Segment reversed(const Segment& s) { return {s.b, s.a}; }

/// One unit in the last place of a number.
double ulpOf(double x)
{
    const double next = std::nextafter(std::abs(x), infinity) - std::abs(x);
    return std::isfinite(next) ? next : std::ldexp(1.0, 971);
}

EndError endError(const glm::dvec2& given, const ExactEnd& exactness, const Window& window,
                  double ulp)
{
    EndError end{.outside = isOutside(given, window)};
    const glm::dvec2 off = exactness.offOf(given);
    for (const int k : {0, 1}) {
        const double apart = std::abs(off[k]);
        end.ulps = std::max(end.ulps, apart / ulp);
        if (apart > 0)
            end.ownUlps = std::max(end.ownUlps, apart / ulpOf(exactness.nearest[k]));
    }
    return end;
}

/// The errors of the piece's ends.
std::array<EndError, 2> endErrors(const Segment& piece, const ExactPart& part, const Window& window,
                                  double ulp, Ends ends)
{
    const std::array straight{endError(piece.a, part.a, window, ulp),
                              endError(piece.b, part.b, window, ulp)};
    if (ends == Ends::InOrder)
        return straight;
    const std::array turned{endError(piece.a, part.b, window, ulp),
                            endError(piece.b, part.a, window, ulp)};
    const auto worse = [](const auto& both) { return std::max(both[0].ulps, both[1].ulps); };
    return worse(turned) < worse(straight) ? turned : straight;
}

/// Like an optional, for which g++ 12 warns of an uninitialized read.
struct Piece {
    Segment segment{};
    bool visible = false;

    explicit operator bool() const { return visible; }
    const Segment& operator*() const { return segment; }
};

/// Whether the results for both orders of ends agree.
bool agree(const Piece& piece, const Piece& other, Ends ends)
{
    if (!piece || !other)
        return !piece && !other;
    if (!isFinite(*piece) || !isFinite(*other))
        return true; // reported in another way
    return *piece == reversed(*other) || (ends == Ends::EitherWay && *piece == *other);
}

/// The algorithm's results for a line and for the line with its ends swapped.
struct Answer {
    Piece piece, fromOther;
};

std::optional<LineExactness> judged(const Segment& line, const Window& window, const Answer& answer,
                                    Ends ends)
{
    const auto part = exactPart(line, window);
    const Piece& piece = answer.piece;
    if (!part && !piece && !answer.fromOther)
        return std::nullopt;
    LineExactness exactness{
        .source = 0, .orderMatters = !agree(piece, answer.fromOther, ends), .piece = line};
    const double ulp = ulpFor(line, window);
    if (piece && !isFinite(*piece)) {
        exactness.fault = Fault::NotFinite;
        if (part)
            exactness.piece = {part->a.nearest, part->b.nearest};
    } else if (part && piece) {
        exactness.piece = *piece;
        exactness.ends = endErrors(*piece, *part, window, ulp, ends);
    } else if (part || piece) {
        exactness.fault = part ? Fault::Lost : Fault::Invented;
        exactness.piece = part ? Segment{part->a.nearest, part->b.nearest} : *piece;
        exactness.lost = extentOf(exactness.piece) / ulp;
    }
    return exactness;
}

Ends endsOf(const Variant& variant)
{
    return variant.form == clipping::Form::Corrected ? Ends::InOrder : Ends::EitherWay;
}

/// Iterates over the pieces of lines; both ascend by line.
class Pieces {
public:
    explicit Pieces(std::span<const Clipped> all) : next_(all.begin()), end_(all.end()) {}
    Piece of(std::uint32_t line)
    {
        if (next_ == end_ || next_->source != line)
            return {};
        return {(next_++)->segment, true};
    }

private:
    std::span<const Clipped>::iterator next_, end_;
};

} // namespace

double errorOf(const LineExactness& line, ErrorUnit errorUnit)
{
    if (line.fault != Fault::None)
        return infinity;
    return errorUnit == ErrorUnit::Largest ? std::max(line.ends[0].ulps, line.ends[1].ulps)
                                           : std::max(line.ends[0].ownUlps, line.ends[1].ownUlps);
}

ExactnessResults extended(ExactnessResults so, const Variant& variant,
                          std::span<const Segment> more)
{
    const auto first = std::uint32_t(so.lines);
    std::vector<Segment> turned(more.size());
    std::ranges::transform(more, turned.begin(), reversed);
    const auto straight = clipped(variant, more, so.window),
               fromOther = clipped(variant, turned, so.window);
    Pieces pieces(straight), others(fromOther);
    for (std::uint32_t line = 0; line < more.size(); ++line) {
        const Answer answer{pieces.of(line), others.of(line)};
        if (auto exactness = judged(more[line], so.window, answer, endsOf(variant))) {
            exactness->source = first + line;
            so.list.push_back(*exactness);
        }
    }
    so.lines += more.size();
    return so;
}

ExactnessResults extended(ExactnessResults so, const Variant& variant, const SceneLines& lines,
                          std::size_t count)
{
    const std::size_t first = so.lines, end = first + std::min(count, lines.size() - first);
    lines.forEachPart(first, end, [&](std::size_t run, std::size_t from, std::size_t to) {
        const auto part = lines.runs()[run].segments.subspan(from, to - from);
        so = extended(std::move(so), variant, part);
    });
    return so;
}

std::optional<LineExactness> exactnessOf(const Variant& variant, const Segment& line,
                                         const Window& window)
{
    const ExactnessResults one = extended({window}, variant, {&line, 1});
    return one.list.empty() ? std::nullopt : std::optional(one.list.front());
}

} // namespace app
