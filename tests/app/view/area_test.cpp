// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/cut_fill.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace view_area_test {

namespace {

double areaOf(const std::vector<app::Point>& p)
{
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const app::Point &a = p[i], &b = p[(i + 1) % p.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2;
}

} // namespace

class AreaTest : public QObject {
    Q_OBJECT

private slots:
    // A triangle's area inside the window, compared with counting points of a fine grid.
    void keepsTheAreaInside()
    {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> number(-2, 3);
        const clipping::Window window{{0, 0}, {1, 1}};
        for (int round = 0; round < 50; ++round) {
            const std::vector<app::Point> triangle{{number(random), number(random)},
                                                   {number(random), number(random)},
                                                   {number(random), number(random)}};
            const auto side = [&](int i, app::Point p) {
                const app::Point a = triangle[i], b = triangle[(i + 1) % 3];
                return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0;
            };
            int inside = 0;
            for (int y = 0; y < 200; ++y)
                for (int x = 0; x < 200; ++x) {
                    const app::Point p((x + 0.5) / 200, (y + 0.5) / 200);
                    inside += side(0, p) == side(1, p) && side(1, p) == side(2, p);
                }
            const auto clipped = app::areaInside(triangle, window);
            for (const app::Point& p : clipped)
                QVERIFY(p.x >= 0 && p.y >= 0 && p.x <= 1 && p.y <= 1);
            QVERIFY(std::abs(areaOf(clipped) - inside / 40000.0) < 0.01);
        }
    }
    void whatIsInsideStays()
    {
        const std::vector<app::Point> square{{1, 1}, {2, 1}, {2, 2}, {1, 2}};
        QCOMPARE(app::areaInside(square, {{0, 0}, {3, 3}}), square);
        QVERIFY(app::areaInside(square, {{5, 5}, {6, 6}}).empty());
    }
};

} // namespace view_area_test

TEST_CLASS(view_area_test::AreaTest, None)
#include "tests/app/view/area_test.moc"
