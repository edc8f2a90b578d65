// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/line_to_see.h"

#include "clipping/outcode.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace app {

namespace {

enum class Met : std::uint8_t { Nowhere, Inside, Cut };

/// How interesting a line is; compared from the first member on.
struct Seen {
    Met met = Met::Nowhere;
    double length = 0; ///< squared; of a line that is visible

    bool operator>(const Seen& other) const
    {
        return std::tie(met, length) > std::tie(other.met, other.length);
    }
};

/// The square: no root for each of a million lines. Beyond 1e154 all count as equally long.
double squaredLength(const clipping::Segment& line)
{
    const Point way = line.b - line.a;
    return std::min(way.x * way.x + way.y * way.y, std::numeric_limits<double>::max());
}

std::optional<clipping::Segment> visibleIn(const TracedWindow& window,
                                           const clipping::Segment& line)
{
    const clipping::Algorithm& exact = clipping::exactAlgorithm();
    return window.corners.empty() ? exact.corrected.clip(line, window.frame.box)
                                  : exact.polygon->clip(line, {window.corners});
}

/// Most lines are judged by their outcodes.
Met metBy(const TracedWindow& window, const clipping::Segment& given)
{
    const clipping::Segment line = window.into(given);
    const unsigned a = clipping::outcodeOf(line.a, window.frame.box),
                   b = clipping::outcodeOf(line.b, window.frame.box);
    if (a & b)
        return Met::Nowhere;
    if (!(a | b) && window.corners.empty())
        return Met::Inside;
    const auto visible = visibleIn(window, line);
    return !visible ? Met::Nowhere : *visible == line ? Met::Inside : Met::Cut;
}

/// The search for the best line among some that are shown to it.
class Search {
public:
    Search(const TracedWindow& window, const std::function<bool()>& enough)
        : window_(window), enough_(enough)
    {
    }

    /// Looks at the lines [first, end). The first of them is the best until there is a better one.
    void look(const SceneLines& lines, std::size_t first, std::size_t end)
    {
        if (first < end && !line_)
            line_ = first;
        lines.forEachPart(first, end, [&](std::size_t number, std::size_t from, std::size_t to) {
            const SceneLines::Run& run = lines.runs()[number];
            for (std::size_t i = from; i < to && !isOver(); ++i)
                judge(run.firstLine + i, run.segments[i]);
        });
    }
    std::optional<std::size_t> line() const { return line_; }

private:
    bool isOver()
    {
        constexpr std::size_t betweenQuestions = 4096;
        if (++looked_ % betweenQuestions == 0)
            over_ = over_ || enough_();
        return over_;
    }
    void judge(std::size_t number, const clipping::Segment& line)
    {
        Seen seen{Met::Cut, squaredLength(line)};
        if (!(seen > best_)) // it would not be better if it were cut
            return;
        seen.met = metBy(window_, line);
        if (seen.met != Met::Nowhere && seen > best_)
            best_ = seen, line_ = number;
    }

    const TracedWindow& window_;
    const std::function<bool()>& enough_;
    Seen best_;
    std::optional<std::size_t> line_;
    std::size_t looked_ = 0;
    bool over_ = false;
};

} // namespace

std::size_t lineToSee(const SceneLines& lines, const TracedWindow& window,
                      const ObjectRanges& locked, const std::function<bool()>& enough)
{
    Search search(window, enough);
    std::size_t next = 0;
    for (const ObjectRange& range : locked.ranges()) {
        search.look(lines, next, lines.firstLineOf(range.first));
        next = lines.firstLineOf(range.end);
    }
    search.look(lines, next, lines.size());
    if (!search.line())
        search.look(lines, 0, lines.size());
    return *search.line();
}

} // namespace app
