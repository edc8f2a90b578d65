// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/ulps.h"
#include "app/exactness/exactness_columns.h"
#include "app/experiment/paper_scene.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <random>

#include "tests/app/scene/scene_lines_of.h"
#include "tests/clipping/oracle.h"
#include "tests/test_class.h"

namespace exactness_exactness_test {

using namespace clipping;
using namespace app;

namespace {

std::vector<Segment> paperLines(std::size_t count)
{
    std::vector<Segment> lines(count);
    PaperScene(7).fill(lines);
    return lines;
}

/// Small whole numbers: every kind of contact.
std::vector<Segment> gridLines(std::size_t count)
{
    std::mt19937_64 random(3);
    std::uniform_int_distribution<int> place(-2, 6);
    std::vector<Segment> lines(count);
    const auto point = [&] { return glm::dvec2(place(random), place(random)); };
    for (Segment& line : lines)
        line = {point(), point()};
    return lines;
}

/// Of every size, from 1e-300 to 1e300, and next to each other.
std::vector<Segment> wildLines(std::size_t count)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> fraction(-1, 1);
    std::uniform_int_distribution<int> exponent(-990, 990);
    std::vector<Segment> lines(count);
    const auto number = [&] { return std::ldexp(fraction(random), exponent(random)); };
    for (Segment& line : lines) {
        line = {{number(), number()}, {number(), number()}};
        if (exponent(random) > 0)
            line.b.y = std::nextafter(line.a.y, line.b.y);
    }
    return lines;
}

std::optional<oracle::Part> oracleOf(const Segment& s, const Window& w)
{
    return oracle::inside(oracle::Line{{s.a.x, s.a.y}, {s.b.x, s.b.y}},
                          oracle::Box{{w.min.x, w.min.y}, {w.max.x, w.max.y}});
}

QByteArray text(const Segment& s)
{
    return QStringLiteral("%1,%2 %3,%4")
        .arg(s.a.x, 0, 'g', 17)
        .arg(s.a.y, 0, 'g', 17)
        .arg(s.b.x, 0, 'g', 17)
        .arg(s.b.y, 0, 'g', 17)
        .toUtf8();
}

bool same(const glm::dvec2& p, const oracle::Point& q) { return p.x == q.x && p.y == q.y; }

void compareWithOracle(std::span<const Segment> lines, const Window& window)
{
    for (const Segment& line : lines) {
        const auto part = exactPart(line, window);
        const auto exactness = oracleOf(line, window);
        QVERIFY2(part.has_value() == exactness.has_value(), text(line));
        if (!part)
            continue;
        QVERIFY2(same(part->a.nearest, exactness->line.a)
                     && same(part->b.nearest, exactness->line.b),
                 text(line));
        for (const ExactEnd* end : {&part->a, &part->b})
            for (const int k : {0, 1}) {
                const double n = end->nearest[k], r = end->rest[k];
                QVERIFY2(n + r == n, text(line)); // half a unit at most
                QVERIFY2(end->isNew || r == 0, text(line));
            }
    }
}

LineExactness exactness(const char* key, const Segment& line, const Window& window)
{
    return *exactnessOf(*findVariant(QString::fromLatin1(key)), line, window);
}

constexpr Window two{{0, 0}, {2, 2}};

} // namespace

class ExactnessTest : public QObject {
    Q_OBJECT

private slots:
    void exactEndsAreTheOraclesOnes()
    {
        compareWithOracle(paperLines(20'000), paperWindow);
        compareWithOracle(gridLines(20'000), {{0, 0}, {4, 4}});
        compareWithOracle(wildLines(5'000), {{-1e-3, -1e-30}, {1e20, 1e3}});
        compareWithOracle(wildLines(5'000), {{-1e-300, -1e300}, {1e-200, 0}});
    }

    void theRestIsWhatTheNearestLacks()
    {
        std::mt19937_64 random(9);
        std::uniform_int_distribution<int> place(-1000, 1000);
        int cut = 0;
        for (int i = 0; i < 10'000; ++i) {
            const Segment line{{place(random), place(random)}, {place(random), place(random)}};
            const auto part = exactPart(line, {{0, -1e9}, {1e9, 1e9}}); // only its left edge cuts
            if (!part || !part->a.isNew)
                continue;
            const glm::dvec2 d = line.b - line.a;
            const double over = line.a.y * d.x - line.a.x * d.y; // whole, as d.x is
            const double lacks = std::fma(-part->a.nearest.y, d.x, over) / d.x;
            QVERIFY2(std::abs(part->a.rest.y - lacks) <= std::abs(lacks) * 1e-15, text(line));
            cut += part->a.rest.y != 0;
        }
        QVERIFY(cut > 1000);
    }

    void everyAlgorithmIsJudgedAsTheOracleWould_data()
    {
        QTest::addColumn<QString>("key");
        for (const Variant& variant : variants())
            QTest::newRow(qPrintable(keyOf(variant))) << keyOf(variant);
    }
    void everyAlgorithmIsJudgedAsTheOracleWould()
    {
        QFETCH(QString, key);
        const Variant variant = *findVariant(key);
        const bool ours = variant.form == Form::Corrected;
        const auto check = [&](std::span<const Segment> lines, const Window& window) {
            const ExactnessResults all = extended({window}, variant, lines);
            auto next = all.list.begin();
            for (std::uint32_t i = 0; i < lines.size(); ++i) {
                const auto oracle = oracleOf(lines[i], window);
                const auto piece = clipped(variant, lines[i], window);
                const auto other = clipped(variant, {lines[i].b, lines[i].a}, window);
                if (!oracle && !piece && !other)
                    continue;
                QVERIFY2(next != all.list.end() && next->source == i, text(lines[i]));
                const LineExactness& line = *next++;
                const bool finite = !piece
                                    || (std::isfinite(piece->a.x) && std::isfinite(piece->a.y)
                                        && std::isfinite(piece->b.x) && std::isfinite(piece->b.y));
                const Fault fault = !finite            ? Fault::NotFinite
                                    : oracle && !piece ? Fault::Lost
                                    : piece && !oracle ? Fault::Invented
                                                       : Fault::None;
                QVERIFY2(line.fault == fault, text(lines[i]));
                if (!oracle || !piece || !finite)
                    continue;
                const double ulp = ulpFor(lines[i], window);
                const Segment rounded{{oracle->line.a.x, oracle->line.a.y},
                                      {oracle->line.b.x, oracle->line.b.y}};
                const double apart =
                    endsApart(*piece, rounded, ours ? Ends::InOrder : Ends::EitherWay) / ulp;
                QVERIFY2(std::abs(errorOf(line, ErrorUnit::Largest) - apart) <= 0.5 + 1e-9 * apart,
                         text(lines[i]));
                const auto inside = [&](const glm::dvec2& p) {
                    return p.x >= window.min.x && p.x <= window.max.x && p.y >= window.min.y
                           && p.y <= window.max.y;
                };
                QVERIFY2(line.outside() == !(inside(piece->a) && inside(piece->b)), text(lines[i]));
                if (ours) {
                    QVERIFY2(!line.outside(), text(lines[i]));
                    QVERIFY2(errorOf(line, ErrorUnit::Largest) <= variant.algorithm->ulps,
                             text(lines[i]));
                }
            }
            QVERIFY(next == all.list.end());
        };
        check(paperLines(3'000), paperWindow);
        check(gridLines(3'000), {{0, 0}, {4, 4}});
    }

    void exactIsNeverOffByMoreThanOneUlpOfItself()
    {
        const auto check = [&](std::span<const Segment> lines, const Window& window) {
            for (const LineExactness& line : extended({window}, exactVariant(), lines).list) {
                QVERIFY2(!line.isWrong() && !line.orderMatters, text(lines[line.source]));
                QVERIFY2(errorOf(line, ErrorUnit::Own) <= 1, text(lines[line.source]));
            }
        };
        check(paperLines(20'000), paperWindow);
        check(gridLines(20'000), {{0, 0}, {4, 4}});
        check(wildLines(5'000), {{-1e-3, -1e-30}, {1e20, 1e3}});
    }

    void publishedFaultsAreFound()
    {
        // X5: Skala drops an edge; from the other end it is seen.
        const LineExactness edge = exactness("skala:published", {{-1, 0}, {1, 0}}, two);
        QVERIFY(edge.fault == Fault::Lost && edge.orderMatters);
        QCOMPARE(edge.lost, 1 / ulpFor({{-1, 0}, {1, 0}}, two));
        // X6: and a contact
        const LineExactness contact = exactness("skala:published", {{-1, 0}, {0, 0}}, two);
        QVERIFY(contact.fault == Fault::Lost && contact.lost == 0);
        // X7: KWC drops a steep line of any length, from either end.
        const Segment steep{{100, 0}, {100.5, 300}};
        const Window large{{0, 0}, {300, 300}};
        const LineExactness lost = exactness("kwc:published", steep, large);
        QVERIFY(lost.fault == Fault::Lost && !lost.orderMatters && lost.isWrong());
        QCOMPARE(lost.lost, 300 / ulpFor(steep, large));
        QVERIFY(!exactness("kwc", steep, large).isWrong());
        // X9, X10: Slater-Barsky loses a corner, and returns no number.
        QVERIFY(exactness("sb:published", {{-1, 0}, {0, 1}}, {{0, 0}, {1, 1}}).fault
                == Fault::Lost);
        QVERIFY(exactness("sb:published", {{2, 1}, {2, -1}}, two).fault == Fault::NotFinite);
        // X12: MD returns a piece that is far from the line, which misses.
        const double u = 0x1p-52;
        const Segment missing{{-1, 1 + 2 * u}, {3, 1 - u}};
        QVERIFY(exactness("md:published", missing, {{0, 0}, {1, 1}}).fault == Fault::Invented);
        QVERIFY(!exactnessOf(exactVariant(), missing, {{0, 0}, {1, 1}}));
        // X2: the misprint begins at (0,0) instead of (1/2,0): half a unit, 2^51 ulps of 2
        const LineExactness misprint = exactness("md-step-2", {{0, -1}, {1, 1}}, two);
        QCOMPARE(errorOf(misprint, ErrorUnit::Largest), 0.5 / 0x1p-51);
        QCOMPARE(errorOf(misprint, ErrorUnit::Own), 0.5 / 0x1p-53);
    }

    void endsOutsideByUlpsAreFound()
    {
        std::size_t outside = 0;
        const auto lines = paperLines(20'000);
        for (const LineExactness& line :
             extended({paperWindow}, *findVariant("lb:published"), lines).list)
            outside += line.outside();
        QVERIFY2(outside > 100, qPrintable(QString::number(outside))); // 8 % of what is visible
    }

    void theWorstComeFirst()
    {
        std::vector<LineExactness> list(6);
        for (std::uint32_t i = 0; i < 6; ++i)
            list[i].source = i;
        list[1].ends[1].ulps = 3;
        list[2].fault = Fault::NotFinite;
        list[3].fault = Fault::Lost;
        list[3].lost = 5e13;
        list[4].fault = Fault::Invented;
        list[4].lost = 6e13;
        list[5].ends[0].ulps = 1e300;
        const auto rows =
            sortedBy(list, exactnessColumns()[std::size_t(errorColumn)], Qt::DescendingOrder);
        QCOMPARE(rows, std::vector<std::uint32_t>({2, 4, 3, 5, 1, 0}));
    }

    void everyErrorHasItsClass()
    {
        LineExactness line{};
        const auto classOf = [&](double ulps) {
            line.ends[0].ulps = ulps;
            return errorClasses()[errorClassOf(line, ErrorUnit::Largest)].name;
        };
        QCOMPARE(classOf(0), "exact");
        QCOMPARE(classOf(0.5), "≤ ½ ulp");
        QCOMPARE(classOf(0.51), "≤ 1 ulp");
        QCOMPARE(classOf(64), "≤ 64 ulps");
        QCOMPARE(classOf(1e300), "more");
        line.ends[0].outside = true;
        QCOMPARE(classOf(0.1), "wrong");
        line = {.source = 0, .fault = Fault::Lost};
        QCOMPARE(classOf(0), "wrong");
    }

    void badInputHasNoResult()
    {
        const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
        QVERIFY(!exactPart({{nan, 0}, {1, 1}}, two));
        QVERIFY(!exactPart({{0, 0}, {infinite, 1}}, two));
        QVERIFY(!exactPart({{0, 0}, {1, 1}}, {{2, 0}, {0, 2}}));
        QVERIFY(exactPart({{0, 0}, {1, 1}}, {{1, 1}, {1, 1}}));
        QVERIFY(!exactnessOf(*findVariant("md"), {{nan, 0}, {1, 1}}, two));
    }

    void distancesFromALineAreExact()
    {
        QCOMPARE(distanceLeftOf({{0, 0}, {10, 0}}, {3, 2}), 2.0);
        QCOMPARE(distanceLeftOf({{0, 0}, {0, 10}}, {3, 2}), -3.0);
        QCOMPARE(distanceLeftOf({{1e9, 1e9}, {3e9, 3e9}}, {2e9, 2e9}), 0.0);
        // One ulp beside a line through (1e15, 1e15): what doubles alone would lose.
        const double x = 1e15, next = std::nextafter(x, 2e15);
        QCOMPARE(distanceLeftOf({{0, 0}, {3e15, 3e15}}, {x, next}), (next - x) / std::sqrt(2.0));
        QCOMPARE(distanceLeftOf({{0, 0}, {1e-300, 0}}, {0, 1e-290}), 1e-290);
        QCOMPARE(distanceLeftOf({{-1e300, 0}, {1e300, 0}}, {0, 1e290}), 1e290);
    }

    void itGrowsInSlices()
    {
        const auto lines = paperLines(5'000);
        const Variant variant = *findVariant("skala:published");
        const SceneLines scene = sceneLinesOf(lines, 1'200);
        ExactnessResults slices{paperWindow};
        while (slices.lines < lines.size())
            slices = extended(std::move(slices), variant, scene, 700);
        const ExactnessResults all = extended({paperWindow}, variant, lines);
        QCOMPARE(slices.list.size(), all.list.size());
        for (std::size_t i = 0; i < all.list.size(); ++i) {
            QCOMPARE(slices.list[i].source, all.list[i].source);
            QCOMPARE(errorOf(slices.list[i], ErrorUnit::Own), errorOf(all.list[i], ErrorUnit::Own));
        }
    }
};

} // namespace exactness_exactness_test

TEST_CLASS(exactness_exactness_test::ExactnessTest, Gui)
#include "tests/app/exactness/exactness_test.moc"
