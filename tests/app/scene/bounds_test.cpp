// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/bounds.h"

#include <QTest>

#include <glm/common.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "tests/test_class.h"

namespace scene_bounds_test {

namespace {

using app::Point;
using clipping::Window;

/// Line by line.
std::optional<Window> plainBounds(const app::SceneLines& lines, const app::ObjectRanges& objects)
{
    std::optional<Window> all;
    for (const std::size_t object : objects)
        for (std::size_t i = lines.firstLineOf(object); i < lines.firstLineOf(object + 1); ++i) {
            const auto [a, b] = lines[i];
            const Point min = glm::min(a, b), max = glm::max(a, b);
            all = all ? Window{glm::min(all->min, min), glm::max(all->max, max)} : Window{min, max};
        }
    return all;
}

bool sameBits(const std::optional<Window>& a, const std::optional<Window>& b)
{
    return a.has_value() == b.has_value() && (!a || std::memcmp(&*a, &*b, sizeof *a) == 0);
}

} // namespace

class BoundsTest : public QObject {
    Q_OBJECT

private slots:
    void boundsAreThoseOfTheLinesBitForBit()
    {
        for (int round = 0; round < 60; ++round) {
            const std::size_t count = 1 + random_() % (round % 6 == 0 ? 12'000 : 300);
            app::Objects objects;
            const bool odd = round % 4 == 3; // numbers that are not finite
            for (std::size_t i = 0; i < count; ++i)
                objects.append(app::Object{path(odd), {}, {}, random_() % 9 == 0});
            const app::SceneLines lines = app::linesOf(objects, {}, 0.1);
            for (int some = 0; some < 20; ++some) {
                app::ObjectRanges ranges;
                for (auto n = random_() % 4; n > 0; --n) {
                    const std::size_t first = random_() % count;
                    ranges.insert(app::ObjectRange{first, first + 1 + random_() % (count - first)});
                }
                QVERIFY(sameBits(boundsOf(lines, ranges), plainBounds(lines, ranges)));
            }
            const app::ObjectRanges all(app::ObjectRange{0, count});
            QVERIFY(sameBits(boundsOf(lines, all), plainBounds(lines, all)));
            QVERIFY(sameBits(boundsOf(lines), plainBounds(lines, all)));
        }
    }
    /// What is the least of zeros of both signs, or beside what is no number, depends on the order.
    void orderDecidesBeforeBoxes()
    {
        const double nan = std::nan("");
        for (const auto& [place, special] :
             {std::pair<std::size_t, double>{64, nan}, {0, 0.0}, {66, -0.0}, {3, nan}}) {
            app::Objects objects;
            for (std::size_t i = 0; i < 72; ++i) {
                const double x = i == place ? special : place == 0 ? -0.0 : 0.0;
                objects.append(
                    app::Object{app::Path(clipping::Segment{{x, 0}, {1, 1}}), {}, {}, false});
            }
            const app::SceneLines lines = app::linesOf(objects, {}, 0.1);
            for (const std::size_t end : {64, 65, 66, 67, 70, 72})
                for (const std::size_t first : {0, 1, 63, 64}) {
                    if (first >= end)
                        continue;
                    const app::ObjectRanges some(app::ObjectRange{first, end});
                    QVERIFY(sameBits(boundsOf(lines, some), plainBounds(lines, some)));
                }
        }
    }
    void nothingHasNoBounds()
    {
        QVERIFY(!app::boundsOf(app::SceneLines()));
        QVERIFY(!app::boundsOf(app::SceneLines(), {}));
        app::Objects objects;
        objects.append(app::Object{app::Path(clipping::Segment{{1, 2}, {3, 4}}), {}, {}, true});
        const app::SceneLines lines = app::linesOf(objects, {}, 0.1);
        QVERIFY(!app::boundsOf(lines));
        QVERIFY(!app::boundsOf(lines, {0}));
    }

private:
    // Zeros of both signs are among them, and numbers that floats do not have.
    double number(bool odd)
    {
        const auto kind = random_() % 400;
        if (odd && kind < 2)
            return kind ? std::numeric_limits<double>::infinity() : std::nan("");
        if (kind < 100)
            return random_() % 2 ? -0.0 : 0.0;
        if (kind < 200)
            return double(random_() % 5) * 1e9 + 0.1;
        return std::uniform_real_distribution<double>(-1, kind < 210 ? 1e10 : 1)(random_);
    }
    Point point(bool odd) { return {number(odd), number(odd)}; }
    app::Path path(bool odd)
    {
        if (random_() % 3)
            return app::Path(clipping::Segment{point(odd), point(odd)});
        std::vector<app::Subpath> subpaths;
        for (auto n = random_() % 3; n > 0; --n) {
            subpaths.push_back({point(odd), {}, random_() % 2 == 0});
            for (auto m = random_() % 40; m > 0; --m)
                subpaths.back().segments.push_back({point(odd)});
        }
        return app::Path(subpaths);
    }

    std::mt19937_64 random_{7};
};

} // namespace scene_bounds_test

TEST_CLASS(scene_bounds_test::BoundsTest, None)
#include "tests/app/scene/bounds_test.moc"
