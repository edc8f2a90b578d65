// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/grid.h"

#include "app/document/direction.h"
#include "clipping/algorithm.h"

#include <QStringList>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

constexpr double leastApart = 10; // pixels
constexpr double mostMultiple = 1e15;
constexpr int coarser = 5; // also: every fifth line is major
constexpr std::size_t mostDots = 100'000;
const QString shownWord = QStringLiteral("shown"), downWord = QStringLiteral("down="),
              angleWord = QStringLiteral("angle=");
constexpr double mostDegrees = 360;
const std::array patterns{QStringLiteral("square"), QStringLiteral("diagonal"),
                          QStringLiteral("isometric"), QStringLiteral("own")};
const std::array marks{QStringLiteral("lines"), QStringLiteral("dots")};

/// The smallest and the largest multiple of `across` by which lines along `along` meet the window;
/// none, if they are too large to count.
std::array<double, 2> multiples(const GridPoints& grid, const Point& along, const Point& across,
                                const clipping::Window& window)
{
    std::array<double, 2> range{HUGE_VAL, -HUGE_VAL};
    for (const Point& corner : {window.min, window.max, Point(window.min.x, window.max.y),
                                Point(window.max.x, window.min.y)}) {
        const double k = cross(along, corner - grid.origin) / cross(along, across);
        range = {std::min(range[0], k), std::max(range[1], k)};
    }
    const bool countable = range[0] > -mostMultiple && range[1] < mostMultiple;
    return countable ? std::array{std::ceil(range[0]), std::floor(range[1])}
                     : std::array{0.0, -1.0};
}

void addLines(const GridPoints& grid, const Point& along, const Point& across,
              const clipping::Window& window, std::vector<GridLine>& lines)
{
    const auto [first, last] = multiples(grid, along, across, window);
    const double step = glm::length(along);
    const double reach = glm::distance(window.min, window.max) / step;
    for (double k = first; k <= last; ++k) {
        const Point start = grid.origin + across * k;
        const double middle =
            glm::dot((window.min + window.max) * 0.5 - start, along) / (step * step);
        const auto line = clipping::exactAlgorithm().corrected.clip(
            {start + along * (middle - reach), start + along * (middle + reach)}, window);
        if (line)
            lines.push_back({*line, std::fmod(k, coarser) == 0});
    }
}

/// A spacing in user units, coarser where its points would lie too close on the screen.
double shownStep(double millimetres, const Page& page, double zoom)
{
    double step = millimetres / page.millimetresPerUnit();
    if (!(step * zoom > 0 && std::isfinite(step)))
        step = leastApart / zoom; // units of an absurd size
    while (step * zoom < leastApart)
        step *= coarser;
    return step;
}

} // namespace

QString Grid::text() const
{
    QStringList words{shown ? shownWord : QStringLiteral("hidden"),
                      QString::number(spacing, 'g', 17),
                      patterns[std::size_t(pattern)],
                      app::marks[std::size_t(marks)],
                      downWord + QString::number(down, 'g', 17),
                      angleWord + QString::number(angle, 'g', 17)};
    return words.join(u' ');
}

Grid Grid::fromText(const QString& text)
{
    Grid grid;
    for (const QString& word : text.left(200).split(u' ')) {
        const auto pattern = std::ranges::find(patterns, word);
        const auto mark = std::ranges::find(app::marks, word);
        bool isNumber = false;
        const double number = word.section(u'=', -1).toDouble(&isNumber);
        const bool isSpacing = isNumber && number >= least && number <= most;
        if (word == shownWord)
            grid.shown = true;
        else if (pattern != patterns.end())
            grid.pattern = Pattern(pattern - patterns.begin());
        else if (mark != app::marks.end())
            grid.marks = Marks(mark - app::marks.begin());
        else if (word.startsWith(downWord) && isSpacing)
            grid.down = number;
        else if (word.startsWith(angleWord) && isNumber && std::abs(number) <= mostDegrees)
            grid.angle = number;
        else if (isSpacing && !word.contains(u'='))
            grid.spacing = number;
    }
    return grid;
}

Point GridPoints::nearest(const Point& point) const
{
    const Point to = point - origin;
    const double whole = cross(u, v);
    const double i = std::floor(cross(to, v) / whole), j = std::floor(cross(u, to) / whole);
    Point best = origin + u * i + v * j;
    for (const Point& step : {Point(1, 0), Point(0, 1), Point(1, 1)}) {
        const Point other = origin + u * (i + step.x) + v * (j + step.y);
        if (glm::distance(other, point) < glm::distance(best, point))
            best = other;
    }
    return best;
}

GridPoints gridPoints(const Grid& grid, const Page& page, double zoom)
{
    const double step = shownStep(grid.spacing, page, zoom);
    const double half = step / 2, long_ = step * std::sqrt(0.75), diagonal = step * std::sqrt(0.5);
    switch (grid.pattern) {
    case Grid::Pattern::Diagonal:
        return {page.min, {diagonal, diagonal}, {diagonal, -diagonal}};
    case Grid::Pattern::Isometric:
        return {page.min, {long_, half}, {long_, -half}};
    case Grid::Pattern::Own:
        return {page.min, directionOf(grid.angle) * step,
                directionOf(grid.angle - 90) * shownStep(grid.down, page, zoom)};
    case Grid::Pattern::Square:
        break;
    }
    return {page.min, {step, 0}, {0, step}};
}

std::vector<GridLine> gridLines(const Grid& grid, const Page& page, double zoom,
                                const clipping::Window& within)
{
    const GridPoints points = gridPoints(grid, page, zoom);
    std::vector<GridLine> lines;
    addLines(points, points.u, points.v, within, lines);
    addLines(points, points.v, points.u, within, lines);
    if (grid.pattern == Grid::Pattern::Isometric)
        addLines(points, points.u - points.v, points.u, within, lines);
    return lines;
}

std::vector<Point> gridDots(const Grid& grid, const Page& page, double zoom,
                            const clipping::Window& within)
{
    const GridPoints points = gridPoints(grid, page, zoom);
    const auto [i0, i1] = multiples(points, points.v, points.u, within);
    const auto [j0, j1] = multiples(points, points.u, points.v, within);
    std::vector<Point> dots;
    for (double i = i0; i <= i1; ++i)
        for (double j = j0; j <= j1 && dots.size() < mostDots; ++j) {
            const Point dot = points.origin + points.u * i + points.v * j;
            if (dot.x >= within.min.x && dot.y >= within.min.y && dot.x <= within.max.x
                && dot.y <= within.max.y)
                dots.push_back(dot);
        }
    return dots;
}

} // namespace app
