// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/tasks/player.h"

namespace tasks_shapes_test {

using namespace tasks;

// Tasks of README.md about shapes and curves.
class ShapesTest : public QObject {
    Q_OBJECT

    /// How far the handles of a quarter circle reach, in radii.
    static inline const double quarter = 4.0 / 3 * std::tan(std::numbers::pi / 8);

    static Steps all(const std::vector<Steps>& parts)
    {
        Steps all;
        for (const Steps& part : parts)
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }
    /// From a path of curves.
    static double distance(const app::Point& from, const Drawn& path)
    {
        double nearest = HUGE_VAL;
        for (std::size_t i = 0; i + 3 < path.points.size(); i += 3)
            for (double t = 0; t <= 1; t += 1.0 / 64)
                nearest = std::min(nearest, glm::distance(from, at(path, i, t)));
        return nearest;
    }
    static app::Point at(const Drawn& path, std::size_t first, double t)
    {
        const app::Point* p = &path.points[first];
        const double u = 1 - t;
        return u * u * u * p[0] + 3 * u * u * t * p[1] + 3 * u * t * t * p[2] + t * t * t * p[3];
    }
    static Steps line(const char* from, const char* by)
    {
        return {key("L"), type(from), enter(), type(by), enter()};
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void roundedPlate()
    {
        const double r = 5, k = r * (1 - quarter), left = 20, top = 30, right = 80, bottom = 70;
        check({key("R"), type("20,30"), enter(), type("60"), tab(), type("40"), tab(), type("5"),
               enter()},
              {{{{left + r, top},
                 {right - r, top},
                 {right - k, top},
                 {right, top + k},
                 {right, top + r},
                 {right, bottom - r},
                 {right, bottom - k},
                 {right - k, bottom},
                 {right - r, bottom},
                 {left + r, bottom},
                 {left + k, bottom},
                 {left, bottom - k},
                 {left, bottom - r},
                 {left, top + r},
                 {left, top + k},
                 {left + k, top},
                 {left + r, top}},
                true}});
    }
    void hexagon()
    {
        const double side = 17 / std::sqrt(3.0);
        Table table{{{}, true}};
        for (int i = 0; i < 6; ++i) {
            const double angle = glm::radians(-60.0 + 60 * i);
            table[0].points.push_back(app::Point(60, 50)
                                      + side * app::Point(std::cos(angle), std::sin(angle)));
        }
        check({key("Y"), type("60,50"), enter(), move({80, 50}, Qt::AltModifier), type("17/2"),
               tab(), type("90"), enter()},
              table);
    }
    void arcWindow()
    {
        const double q = 15 * quarter;
        check({key("P"), type("20,40"), enter(), type("0,40"), enter(), type("30,0"), enter(),
               type("0,-40"), enter(), key("A"), type("20,40"), enter(), type("30,0"), enter(),
               move({35, 20}), type("15"), enter()},
              {{{{20, 40}, {20, 80}, {50, 80}, {50, 40}}},
               {{{20, 40},
                 {20, 40 - q},
                 {35 - q, 25},
                 {35, 25},
                 {35 + q, 25},
                 {50, 40 - q},
                 {50, 40}}}});
    }
    void slot()
    {
        const double q = 4 * quarter;
        check(all({{key("A"), key("C"), type("24,24"), enter(), type("4<90"), enter(), type("180"),
                    enter(), key("A"), type("56,24"), enter(), type("4<-90"), enter(), type("180"),
                    enter()},
                   line("24,28", "32,0"),
                   line("56,20", "-32,0"),
                   {key("Ctrl+A"), key("Shift+J"), enter()}}),
              {{{{24, 20},
                 {24 - q, 20},
                 {20, 24 - q},
                 {20, 24},
                 {20, 24 + q},
                 {24 - q, 28},
                 {24, 28},
                 {56, 28},
                 {56 + q, 28},
                 {60, 24 + q},
                 {60, 24},
                 {60, 24 - q},
                 {56 + q, 20},
                 {56, 20}},
                true}});
    }
    void bezierLeaf()
    {
        check({key("Shift+F5"), key("D"), drag({20, 50}, {50, 20}), drag({100, 50}, {130, 80}),
               click({20, 50})},
              {{{{20, 50}, {50, 20}, {70, 20}, {100, 50}, {130, 80}, {-10, 80}, {20, 50}}, true}});
    }
    void pencilSmooth()
    {
        std::vector<app::Point> wave;
        for (int i = 0; i <= 120; ++i)
            wave.emplace_back(20 + i, 60 + 20 * std::sin(i / 20.0) + 0.8 * std::sin(i / 4.0));
        const Drawn curves{{{20.0144404332, 59.9675090253}, {22.638325738, 62.59139433},
                            {24.8710788218, 65.9843084869}, {27.8772563177, 68.5451263538},
                            {30.3241951931, 70.6295557662}, {44.9847242587, 79.2822692743},
                            {47.8916967509, 80.3393501805}, {49.6615547619, 80.9829349118},
                            {54.3048668174, 80.6390572912}, {56.1119133574, 79.9819494585},
                            {57.6411507915, 79.4258631188}, {73.3189768174, 69.9332661995},
                            {75.0541516245, 68.5451263538}, {79.9617286914, 64.6190647003},
                            {84.9410200449, 56.5881598073}, {90.0649819495, 52.1046931408},
                            {94.6950756365, 48.0533611647}, {100.181930329, 45.9265628787},
                            {105.075812274, 42.8122743682}, {108.135001601, 40.8655175237},
                            {112.130884243, 38.3236420539}, {116.155234657, 39.238267148},
                            {121.367245597, 40.4228150889}, {135.673046103, 49.8442652544},
                            {140.101083032, 53.5342960289}}};
        QVERIFY((curves.points.size() - 1) / 3 + 1 <= 12);
        constexpr double pixel = 0.5; // the pointer moves by whole ones
        for (const app::Point& p : wave)
            QVERIFY(distance(p, curves) <= 0.5 + pixel / std::sqrt(2.0));
        check({key("B"), type("0.5"), enter(), stroke(wave)}, {curves});
    }
    void gear()
    {
        const Steps tooth{key("P"), type("#40<0"),  enter(), type("#45<3"),  enter(), type("#45<9"),
                          enter(),  type("#40<12"), enter(), type("#40<15"), enter()};
        const Steps teeth{key("O"),      move({0.3, 0.3}), key("P"),    key("C"),
                          type("15"),    enter(),          type("23x"), enter(),
                          key("Ctrl+A"), key("Shift+J"),   enter()};
        Table gear{{{}, true}};
        for (int i = 0; i < 24; ++i)
            for (const auto& [radius, degrees] :
                 {std::pair{40.0, 0.0}, {45.0, 3.0}, {45.0, 9.0}, {40.0, 12.0}}) {
                const double angle = glm::radians(degrees + 15 * i);
                gear[0].points.push_back({radius * std::cos(angle), -radius * std::sin(angle)});
            }
        check(all({tooth, teeth}), gear);
    }
    void labelText()
    {
        const double unit = 20.0 / 21; // of the letters
        const auto at = [&](double x, double y) {
            return app::Point(20 + x * unit, 80 + y * unit);
        };
        const app::Point onL = at(4, -10), top = at(4, -21);
        check({key("T"), type("20,80"), enter(), clickField("Height of capital letters"),
               key("Ctrl+A"), type("20"), enter(), type("LT"), enter(), key("V"), doubleClick(onL),
               type("LV"), enter(), key("Ctrl+Shift+P"), doubleClick(onL), click(top),
               type("10,50"), enter()},
              {{{{10, 50}, at(4, 0)}, false},
               {{at(4, 0), at(16, 0)}, false},
               {{at(18, -21), at(26, 0)}, false},
               {{at(34, -21), at(26, 0)}, false}});
    }
};

} // namespace tasks_shapes_test

TEST_CLASS(tasks_shapes_test::ShapesTest, Widgets)
#include "tests/ui/tasks/shapes_test.moc"
