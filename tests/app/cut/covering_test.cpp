// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/covering.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace cut_covering_test {

using namespace app;

namespace {

// Small multiples of 1/8 and their products are exact in double.
double turn(const Point& a, const Point& b, const Point& p)
{
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

enum class Place : std::uint8_t { Inside, Outside, Border };

// By counting the edges that a ray to the right crosses.
Place placeIn(const clipping::Area& area, const Point& p)
{
    int winding = 0;
    std::size_t first = 0;
    for (const std::size_t end : area.ringEnds) {
        for (std::size_t i = first; i < end; ++i) {
            const Point a = area.points[i], b = area.points[i + 1 < end ? i + 1 : first];
            const double side = turn(a, b, p);
            if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x)
                && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y))
                return Place::Border;
            if (a.y <= p.y && p.y < b.y && side > 0)
                ++winding;
            if (b.y <= p.y && p.y < a.y && side < 0)
                --winding;
        }
        first = end;
    }
    const bool filled = area.rule == clipping::FillRule::NonZero ? winding != 0 : winding % 2 != 0;
    return filled ? Place::Inside : Place::Outside;
}

class RandomAreas {
public:
    explicit RandomAreas(std::uint64_t seed, int size) : random_(seed), size_(size) {}

    Point point() { return {number(), number()}; }

    clipping::Area area()
    {
        clipping::Area area;
        area.rule = random_() % 2 ? clipping::FillRule::NonZero : clipping::FillRule::EvenOdd;
        if (random_() % 2) { // a rectangle, sometimes with its edges on those of others
            const Point a = point(), b = point();
            area.points = {a, {b.x, a.y}, b, {a.x, b.y}};
        } else { // crosses itself as it likes
            for (auto n = 3 + random_() % 4; n > 0; --n)
                area.points.push_back(point());
        }
        area.ringEnds = {std::uint32_t(area.points.size())};
        return area;
    }

    std::vector<Chord> chords()
    {
        const Subpath path{point(), {{point()}, {point()}}, true};
        std::vector<Chord> chords;
        flatten(path, 1, chords);
        return chords;
    }

private:
    double number() { return double(random_() % std::uint64_t(size_)); }

    std::mt19937_64 random_;
    int size_;
};

bool isOn(const clipping::Clipped& piece, std::size_t chord, const Point& p)
{
    constexpr double little = 1e-9;
    const auto& [a, b] = piece.segment;
    return piece.source == chord && std::min(a.x, b.x) - little <= p.x
           && p.x <= std::max(a.x, b.x) + little && std::min(a.y, b.y) - little <= p.y
           && p.y <= std::max(a.y, b.y) + little;
}

bool isEnd(std::span<const clipping::Clipped> pieces, const Point& p)
{
    return std::ranges::any_of(pieces, [&](const clipping::Clipped& piece) {
        return glm::distance(piece.segment.a, p) < 1e-9 || glm::distance(piece.segment.b, p) < 1e-9;
    });
}

clipping::Area box(double x0, double y0, double x1, double y1)
{
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}};
}

// "0..2 4..5": what is visible of a horizontal line from 0 to 9.
QString visible(std::vector<clipping::Area> areas, std::size_t first = 0, double y = 1)
{
    Covering covering(std::move(areas));
    const std::vector<Chord> chords{{{{0, y}, {9, y}}, 0, 0, 1}};
    QStringList text;
    for (const auto& piece : covering.visible(chords, first))
        text << QStringLiteral("%1..%2").arg(piece.segment.a.x).arg(piece.segment.b.x);
    return text.join(u' ');
}

} // namespace

class CoveringTest : public QObject {
    Q_OBJECT

private slots:
    void areasAreUnited()
    {
        QCOMPARE(visible({}), "0..9");
        QCOMPARE(visible({box(2, 0, 4, 2)}), "0..2 4..9");
        QCOMPARE(visible({box(4, 0, 6, 2), box(2, 0, 4, 2)}), "0..2 6..9"); // they touch
        QCOMPARE(visible({box(2, 0, 5, 2), box(3, 0, 4, 2)}), "0..2 5..9");
        QCOMPARE(visible({box(-1, 0, 5, 2), box(4, 0, 10, 2)}), "");
        QCOMPARE(visible({box(-1, 0, 10, 2), box(4, 0, 10, 2)}), "");
        QCOMPARE(visible({box(2, 0, 4, 2), box(6, 0, 7, 2)}, 1), "0..6 7..9");
    }

    void bordersCoverAndContactsDoNot()
    {
        QCOMPARE(visible({box(2, 1, 4, 2)}), "0..2 4..9");
        QCOMPARE(visible({{{{2, 1}, {4, 2}, {0, 2}}, {3}}}), "0..9");
        QCOMPARE(visible({{{{2, 1}, {6, 1}, {4, 1}}, {3}}}), "0..9"); // without area
        Covering covering({box(2, 0, 4, 2)});
        const std::vector<Chord> points{{{{3, 1}, {3, 1}}, 0, 0, 1}, {{{5, 1}, {5, 1}}, 0, 0, 1}};
        QCOMPARE(covering.visible(points, 0).size(), 1u);
        QCOMPARE(covering.visible(points, 0)[0].source, 1u);
    }

    void infinitiesAndNaNsCoverNothing()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(visible({box(2, 0, nan, 2)}), "0..9");
        QCOMPARE(visible({box(2, 0, 1e300 * 1e300, 2)}), "0..9");
    }

    // Against exact winding numbers at many points of every line.
    void whatIsVisibleIsInNoArea()
    {
        std::size_t hidden = 0, seen = 0;
        for (std::uint64_t seed = 0; seed < 1500; ++seed) {
            RandomAreas random(seed, seed % 3 == 0 ? 6 : 60);
            std::vector<clipping::Area> areas;
            for (std::uint64_t i = 0; i < 1 + seed % 7; ++i)
                areas.push_back(random.area());
            const auto chords = random.chords();
            Covering covering(areas);
            const auto pieces = covering.visible(chords, seed % 2);
            for (std::size_t chord = 0; chord < chords.size(); ++chord)
                for (int step = 1; step < 64; ++step) {
                    const auto& [a, b] = chords[chord].segment;
                    const Point p = a + (b - a) * (step / 64.0);
                    bool inside = false, onBorder = isEnd(pieces, p);
                    for (std::size_t i = seed % 2; i < areas.size(); ++i) {
                        const Place place = placeIn(areas[i], p);
                        inside = inside || place == Place::Inside;
                        onBorder = onBorder || place == Place::Border;
                    }
                    const bool kept = std::ranges::any_of(
                        pieces, [&](const auto& piece) { return isOn(piece, chord, p); });
                    if (!inside && onBorder)
                        continue;
                    QVERIFY2(kept != inside || (kept && isEnd(pieces, p)),
                             qPrintable(QStringLiteral("seed %1, chord %2, at %3")
                                            .arg(seed)
                                            .arg(chord)
                                            .arg(step / 64.0)));
                    (inside ? hidden : seen) += 1;
                }
        }
        QVERIFY(hidden > 50'000 && seen > 50'000);
    }

    void theDirectionDoesNotMatter()
    {
        RandomAreas random(5, 40);
        for (int i = 0; i < 500; ++i) {
            Covering covering({random.area(), random.area(), random.area()});
            auto chords = random.chords();
            const auto forth = covering.visible(chords, 0);
            std::vector<clipping::Segment> expected;
            for (const auto& piece : forth)
                expected.push_back({piece.segment.b, piece.segment.a});
            for (Chord& chord : chords)
                std::swap(chord.segment.a, chord.segment.b);
            std::ranges::reverse(chords);
            std::ranges::reverse(expected);
            const auto back = covering.visible(chords, 0);
            QVERIFY(std::ranges::equal(back, expected, {}, &clipping::Clipped::segment));
        }
    }
};

} // namespace cut_covering_test

TEST_CLASS(cut_covering_test::CoveringTest, Core)
#include "tests/app/cut/covering_test.moc"
