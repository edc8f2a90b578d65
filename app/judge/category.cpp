// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/category.h"

#include "app/base/text.h"
#include "app/experiment/paper_scene.h"

#include <cmath>
#include <limits>

namespace app::plug_in {
namespace {

using clipping::Segment;
using clipping::Window;
using Questions = std::vector<Question>;

constexpr std::size_t linesOfAPair = 8, someLines = 500;

/// Away from the origin, and neither square nor symmetrical.
constexpr Window awayWindow{{3, 7}, {11, 10}};

// ---- Integers ----
// Ends on a grid, with differences that are powers of two: every quotient is exact, so every
// correct formula decides correctly.

constexpr int gridLast = 9;
constexpr Window gridWindow{{2, 3}, {6, 5}}, gridTall{{1, 2}, {5, 7}};

bool isSimple(double difference)
{
    const double size = std::abs(difference);
    return size == 0 || size == 1 || size == 2 || size == 4 || size == 8;
}

/// Adds all lines of the grid that satisfy `wanted`.
template <class Wanted>
void addGrid(Questions& to, const Window& window, Wanted wanted)
{
    constexpr int side = gridLast + 1, points = side * side;
    for (int i = 0; i < points; ++i)
        for (int j = 0; j < points; ++j) {
            const Segment line{{i % side, i / side}, {j % side, j / side}};
            if (isSimple(line.b.x - line.a.x) && isSimple(line.b.y - line.a.y) && wanted(line))
                to.push_back({line, window});
        }
}

template <class Wanted>
Questions grid(std::span<const Window> windows, Wanted wanted)
{
    Questions all;
    for (const Window& window : windows)
        addGrid(all, window, [&](const Segment& line) { return wanted(line, window); });
    return all;
}

bool isPoint(const Segment& line) { return line.a == line.b; }

bool contains(const Segment& line, const glm::dvec2& p)
{
    const glm::dvec2 d = line.b - line.a, e = p - line.a;
    return d.x * e.y == d.y * e.x && glm::dvec2(line.b - p).x * e.x >= 0
           && glm::dvec2(line.b - p).y * e.y >= 0;
}

bool meetsCorner(const Segment& line, const Window& w)
{
    return contains(line, w.min) || contains(line, w.max) || contains(line, {w.min.x, w.max.y})
           || contains(line, {w.max.x, w.min.y});
}

bool isOnAnEdge(const glm::dvec2& p, const Window& w)
{
    return p.x == w.min.x || p.x == w.max.x || p.y == w.min.y || p.y == w.max.y;
}

constexpr std::array gridWindows{gridWindow, gridTall};

Questions corners(const Scope&)
{
    return grid(gridWindows, [](const Segment& line, const Window& w) {
        return !isPoint(line) && meetsCorner(line, w);
    });
}

Questions edges(const Scope&)
{
    return grid(gridWindows, [](const Segment& line, const Window& w) {
        return !isPoint(line) && (isOnAnEdge(line.a, w) || isOnAnEdge(line.b, w));
    });
}

Questions points(const Scope&)
{
    return grid(gridWindows, [](const Segment& line, const Window&) { return isPoint(line); });
}

Questions smallWindows(const Scope&)
{
    constexpr std::array windows{Window{{4, 2}, {4, 6}}, Window{{2, 4}, {6, 4}},
                                 Window{{4, 4}, {4, 4}}};
    return grid(windows, [](const Segment&, const Window&) { return true; });
}

// ---- Any numbers ----

/// The part of the axis in region 0, 1 or 2: before, in and after the window.
double inRegion(Random& random, int region, double low, double high)
{
    const double size = high - low;
    return region == 1 ? random.between(low, high)
                       : random.between(region == 0 ? low - 1.5 * size : high,
                                        region == 0 ? low : high + 1.5 * size);
}

glm::dvec2 inRegion(Random& random, int region, const Window& w)
{
    const double x = inRegion(random, region % 3, w.min.x, w.max.x);
    return {x, inRegion(random, region / 3, w.min.y, w.max.y)};
}

Questions regionPairs(const Scope& scope)
{
    Questions all;
    Random random(scope.seed);
    for (const Window& w : {paperWindow, awayWindow})
        for (int pair = 0; pair < 81; ++pair)
            for (std::size_t i = 0; i < linesOfAPair; ++i) {
                const auto a = inRegion(random, pair % 9, w);
                all.push_back({{a, inRegion(random, pair / 9, w)}, w});
            }
    return all;
}

/// Through the middle of the window and around it, each line in both directions; some
/// axis-parallel.
Questions directions(const Scope& scope)
{
    Questions all;
    Random random(scope.seed + 1);
    for (const Window& w : {paperWindow, awayWindow})
        for (std::size_t i = 0; i < someLines; ++i) {
            const auto middle = (w.min + w.max) / 2.0, reach = w.max - w.min;
            Segment line{random.in({middle - reach, middle + reach}),
                         random.in({middle - reach, middle + reach})};
            if (i % 4 < 2)
                line.b[int(i % 4)] = line.a[int(i % 4)];
            all.push_back({line, w});
            all.push_back({{line.b, line.a}, w});
        }
    return all;
}

/// Through the lower left corner or an ulp beside it, in tenths, which are not exact in double: a
/// textbook's Cohen-Sutherland may cut at one edge forever, because its sum never equals the edge.
void addTenths(Questions& to)
{
    for (int corner = 1; corner <= 9; ++corner)
        for (int across = 1; across <= 9; ++across)
            for (int up = 1; up <= 9; ++up) {
                const glm::dvec2 at{0.1 * corner, 0.1 * up}, way{0.1 * across, 0.1 * up};
                to.push_back({{at + 0.3 * way, at - way}, {at, {30, 30}}});
                to.push_back({{{0.1 * across, 0.1 * across}, {-up, -up}},
                              {{0.1 * corner, 0.1 * corner}, {30, 30}}});
            }
}

/// Past a corner, inside or outside by 2^-36 to 2^-4: below and above the precision of float.
Questions nearCorners(const Scope& scope)
{
    Questions all;
    Random random(scope.seed + 2);
    const Window& w = paperWindow;
    for (std::size_t i = 0; i < 4 * someLines; ++i) {
        const double right = random.heads() ? 1 : -1, top = random.heads() ? 1 : -1;
        const glm::dvec2 corner{right * w.max.x, top * w.max.y};
        const double off = std::exp2(random.between(-36, -4)) * (random.heads() ? 1 : -1);
        const glm::dvec2 past = corner + off * glm::dvec2(right, top);
        const glm::dvec2 way{random.between(1, 90) * right, -random.between(1, 90) * top};
        all.push_back({{past - way, past + random.between(0.5, 2) * way}, w});
    }
    addTenths(all);
    return all;
}

void addScaled(Questions& to, Random& random, double scale)
{
    for (std::size_t i = 0; i < someLines; ++i)
        to.push_back({{scale * random.in(paperSpace), scale * random.in(paperSpace)},
                      {scale * paperWindow.min, scale * paperWindow.max}});
}

Questions sizes(const Scope& scope)
{
    Questions all;
    Random random(scope.seed + 3);
    for (const int power : {100, 30, -30, -100})
        addScaled(all, random, std::exp2(power));
    if (scope.strictness == Strictness::Clearcuts)
        for (const int power : {1010, 520, -520, -1060})
            addScaled(all, random, std::exp2(power));
    for (std::size_t i = 0; i < someLines; ++i) { // lines to ends far from the window
        const Window far{1e9 * paperSpace.min, 1e9 * paperSpace.max};
        all.push_back({{random.in(paperWindow), random.in(far)}, paperWindow});
    }
    return all;
}

Questions nonsense(const Scope&)
{
    Questions all;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr Window w = paperWindow;
    for (const Segment& line :
         {Segment{{-50, -20}, {60, 30}}, Segment{{-300, 0}, {300, 10}}, Segment{{0, 0}, {0, 0}}}) {
        for (int number = 0; number < 8; ++number)
            for (const double bad :
                 {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
                Question q{line, w};
                glm::dvec2* const of[]{&q.line.a, &q.line.b, &q.window.min, &q.window.max};
                (*of[number / 2])[number % 2] = bad;
                all.push_back(q);
            }
        all.push_back({line, {{w.max.x, w.min.y}, {w.min.x, w.max.y}}});
        all.push_back({line, {{w.min.x, w.max.y}, {w.max.x, w.min.y}}});
        all.push_back({line, {w.max, w.min}});
    }
    return all;
}

Questions randomLines(const Scope& scope)
{
    std::vector<Segment> lines(scope.randomLines);
    PaperScene(scope.seed).fill(lines);
    Questions all;
    all.reserve(lines.size());
    for (const Segment& line : lines)
        all.push_back({line, paperWindow});
    return all;
}

/// Every twentieth line of the other categories, in random order.
Questions again(const Scope& scope)
{
    constexpr std::size_t step = 20;
    Questions all;
    for (const Category& category : categories()) {
        if (category.asked != Asked::Once)
            continue;
        const Questions first = category.questions(scope);
        for (std::size_t i = 0; i < first.size(); i += step)
            all.push_back(first[i]);
    }
    Random random(scope.seed + 4);
    for (std::size_t left = all.size(); left > 1; --left)
        std::swap(all[left - 1], all[std::size_t(random.between(0, double(left)))]);
    return all;
}

} // namespace

std::span<const Category> categories()
{
    constexpr double usual = Contract{}.ulps;
    static const std::vector<Category> all{
        {"regions", Text::tr("Region pairs"),
         Text::tr("Lines from each of the nine regions to each, at two windows."), usual,
         regionPairs},
        {"corners", Text::tr("Corners"),
         Text::tr("Lines that touch a corner, end in it or pass through it, in whole numbers."), 0,
         corners},
        {"edges", Text::tr("Edges"),
         Text::tr("Lines that lie along an edge or end on it, in whole numbers."), 0, edges},
        {"points", Text::tr("Points"),
         Text::tr("Lines whose ends are the same point, in whole numbers."), 0, points},
        {"small-windows", Text::tr("Windows without area"),
         Text::tr("Windows that are a line or a point, in whole numbers."), 0, smallWindows},
        {"directions", Text::tr("Both directions"),
         Text::tr("Each line in both directions, horizontal and vertical lines too."), usual,
         directions},
        {"near-corners", Text::tr("Near corners"),
         Text::tr("Lines that pass very near a corner, inside or outside. The corners have one "
                  "decimal."),
         usual, nearCorners},
        {"sizes", Text::tr("Huge and tiny"),
         Text::tr("The same lines 2¹⁰⁰ times as large and as small, and lines with ends far away."),
         usual, sizes},
        {"nonsense", Text::tr("Invalid input"),
         Text::tr("Infinities, NaNs and inverted windows: nothing is visible."), usual, nonsense},
        {"random", Text::tr("Random lines"),
         Text::tr("The paper's scene: both ends anywhere around the window."), usual, randomLines},
        {"again", Text::tr("Repeated lines"),
         Text::tr(
             "Some of these lines a second time, in another order: the results must not change."),
         usual, again, Asked::Again},
        {"race", Text::tr("In the race"),
         Text::tr("Its results while it is timed: no result may change from run to run."), usual,
         randomLines, Asked::InTheRace},
    };
    return all;
}

} // namespace app::plug_in
