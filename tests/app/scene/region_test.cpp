// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/compared_window.h"
#include "app/scene/region.h"
#include "clipping/algorithm.h"
#include "clipping/outside.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <bit>
#include <cmath>

#include "tests/app/scene/region_truth.h"
#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace scene_region_test {

using namespace app;
using clipping::Clipped;
using clipping::Segment;

namespace {

constexpr int grid = 8; // numbers go from 0 to it
constexpr double infinity = Limits<double>::infinity(), notANumber = Limits<double>::quiet_NaN();

using Uses = clipping::Functions<Segment, clipping::Window>;

std::vector<Clipped> keptOf(const ClipRegion& region, const Segment& line,
                            const Uses& uses = clipping::exactAlgorithm().corrected)
{
    std::vector<std::optional<Clipped>> atStep;
    for (const auto& step : region.steps) {
        std::array<Clipped, 1> piece{};
        const auto count = uses.clipAll(std::span(&line, 1), step.box, piece);
        atStep.push_back(count ? std::optional(piece[0]) : std::nullopt);
    }
    std::vector<Clipped> kept;
    fold(region, line, 7, atStep, kept);
    return kept;
}

bool isFinite(const Segment& s)
{
    return std::isfinite(s.a.x) && std::isfinite(s.a.y) && std::isfinite(s.b.x)
           && std::isfinite(s.b.y);
}

bool sameBits(const Segment& a, const Segment& b)
{
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    return bits(a.a.x) == bits(b.a.x) && bits(a.a.y) == bits(b.a.y) && bits(a.b.x) == bits(b.b.x)
           && bits(a.b.y) == bits(b.b.y);
}

bool sameBits(const std::vector<Clipped>& a, const std::vector<Clipped>& b)
{
    return std::ranges::equal(a, b, [](const Clipped& x, const Clipped& y) {
        return sameBits(x.segment, y.segment) && x.source == y.source && x.cut == y.cut;
    });
}

/// Lists of windows on the grid, and lines; some have shared edges, some are points.
class GridCases {
public:
    explicit GridCases(unsigned seed) : random_(seed) {}

    std::vector<truth::Rectangle> list(int most = 5)
    {
        std::vector<truth::Rectangle> all(std::size_t(random_.whole(1, most)));
        for (auto& r : all) {
            for (std::size_t k = 0; k < 2; ++k) {
                const int p = random_.whole(0, grid), q = random_.whole(0, grid);
                const bool inverted = random_.whole(0, 40) == 0;
                r.min[k] = inverted ? std::max(p, q) : std::min(p, q);
                r.max[k] = inverted ? std::min(p, q) : std::max(p, q);
            }
            r.does = truth::Does(random_.whole(0, 3));
        }
        return all;
    }
    truth::Line line()
    {
        truth::Line line{point(), point()};
        if (const int kind = random_.whole(0, 9); kind < 3)
            line.b = kind == 2   ? line.a
                     : kind == 1 ? std::array{line.a[0], line.b[1]}
                                 : std::array{line.b[0], line.a[1]};
        return line;
    }
    std::array<int, 2> point()
    {
        return {random_.whole(-1, grid + 1), random_.whole(-1, grid + 1)};
    }
    Random& random() { return random_; }

private:
    Random random_;
};

glm::dvec2 toDouble(const std::array<int, 2>& p) { return {p[0], p[1]}; }
Segment toSegment(const truth::Line& line) { return {toDouble(line.a), toDouble(line.b)}; }

/// Through ClipWindows, with hidden windows in between that must not matter.
ClipRegion toRegion(const std::vector<truth::Rectangle>& list, bool inside, Random& random)
{
    ClipWindows windows{{}, inside ? Keep::Inside : Keep::Outside};
    for (const auto& r : list) {
        if (random.whole(0, 2) == 0)
            windows.list.push_back({QStringLiteral("hidden"),
                                    RectangleShape{{{0, 0}, {grid, random.whole(0, grid)}}},
                                    WindowOperation(random.whole(0, 3)), false});
        windows.list.push_back({QStringLiteral("shown"),
                                RectangleShape{{toDouble(r.min), toDouble(r.max)}},
                                WindowOperation(r.does), true});
    }
    return regionOf(windows, 1);
}

std::string describe(const std::vector<truth::Rectangle>& list, bool inside,
                     const truth::Line& line)
{
    std::ostringstream text;
    for (const auto& r : list)
        text << "+-x="[int(r.does)] << "[" << r.min[0] << ".." << r.max[0] << "," << r.min[1]
             << ".." << r.max[1] << "] ";
    text << (inside ? "inside" : "outside") << " line " << line.a[0] << "," << line.a[1] << " "
         << line.b[0] << "," << line.b[1];
    return text.str();
}

/// The number of rectangles from the last one that replaces on.
std::size_t counting(const std::vector<truth::Rectangle>& list)
{
    const auto last = std::find_if(list.rbegin(), list.rend(), [](const truth::Rectangle& r) {
        return r.does == truth::Does::Replace;
    });
    return last == list.rend() ? list.size() : std::size_t(last - list.rbegin()) + 1;
}

/// Whether `x` is the fraction, or a number beside it where it has no double.
bool isAt(double x, const truth::Fraction& exact)
{
    const double nearest = double(exact.numerator()) / double(exact.denominator());
    if (std::has_single_bit(std::uint64_t(exact.denominator())))
        return x == nearest;
    return x >= nudged(nearest, -1) && x <= nudged(nearest, 1);
}

bool agrees(const std::vector<Clipped>& kept, const std::vector<truth::Kept>& truth,
            const truth::Line& line)
{
    const auto isPoint = [&](const glm::dvec2& p, const truth::Fraction& t) {
        const auto exact = truth::pointOf(line, t);
        return isAt(p.x, exact[0]) && isAt(p.y, exact[1]);
    };
    const auto agrees = [&](const Clipped& piece, const truth::Kept& t) {
        return isPoint(piece.segment.a, t.from) && isPoint(piece.segment.b, t.to)
               && piece.source == 7
               && (clipping::cutEdgeOfA(piece.cut) == clipping::Edge::NoEdge)
                      == (t.from == truth::Fraction(0))
               && (clipping::cutEdgeOfB(piece.cut) == clipping::Edge::NoEdge)
                      == (t.to == truth::Fraction(line.a == line.b ? 0 : 1));
    };
    return std::equal(kept.begin(), kept.end(), truth.begin(), truth.end(), agrees);
}

} // namespace

class RegionTest : public QObject {
    Q_OBJECT

private slots:
    void listsOfWindowsKeepWhatTheyShould()
    {
        GridCases cases(1);
        int pieces = 0, contacts = 0, several = 0;
        for (int i = 0; i < 10'000; ++i) {
            const auto list = cases.list();
            for (const bool inside : {true, false}) {
                const ClipRegion region = toRegion(list, inside, cases.random());
                QCOMPARE(region.steps.size(), counting(list));
                for (int n = 0; n < 8; ++n) {
                    const truth::Line line = cases.line();
                    const auto kept = keptOf(region, toSegment(line));
                    const auto truth = truth::kept(list, inside, line);
                    QVERIFY2(agrees(kept, truth, line), describe(list, inside, line).c_str());
                    pieces += int(truth.size());
                    several += truth.size() > 1;
                    contacts += int(std::ranges::count_if(truth, [&](const truth::Kept& t) {
                        return t.from == t.to && line.a != line.b;
                    }));
                }
            }
        }
        QVERIFY(pieces > 50'000 && several > 2'000 && contacts > 500);
    }

    void longListsKeepWhatTheyShould()
    {
        GridCases cases(2);
        for (int i = 0; i < 300; ++i) {
            const auto list = cases.list(200);
            const ClipRegion region = toRegion(list, i % 2, cases.random());
            for (int n = 0; n < 8; ++n) {
                const truth::Line line = cases.line();
                QVERIFY2(
                    agrees(keptOf(region, toSegment(line)), truth::kept(list, i % 2, line), line),
                    describe(list, i % 2, line).c_str());
            }
        }
    }

    void oneRectangleIsWhatTheAlgorithmSays()
    {
        Random random(2);
        std::array<Clipped, 2> inside{}, outside{};
        for (int i = 0; i < 20'000; ++i) {
            const bool plain = i % 2 == 0; // else of any size, and some windows are inverted
            const auto number = [&] {
                return plain ? random.whole(-3, 3) + random.unit() : anyNumber(random);
            };
            const Segment line{{number(), number()}, {number(), number()}};
            const clipping::Window window{{number(), number()}, {number(), number()}};
            for (const auto& row : clipping::algorithms())
                for (const auto form : {clipping::Form::Corrected, clipping::Form::Published}) {
                    const Uses* uses = functionsOf(row, form);
                    if (!uses)
                        continue;
                    auto count = uses->clipAll(std::span(&line, 1), window, inside);
                    if (count && !isFinite(inside[0].segment))
                        count = 0;
                    const auto removed = clipping::outsideAll(
                        std::span(&line, 1), std::span(inside).first(count), outside);
                    const auto keptAre = [&](Keep keep, std::span<const Clipped> expected) {
                        std::vector<Clipped> all(expected.begin(), expected.end());
                        for (Clipped& piece : all)
                            piece.source = 7;
                        return sameBits(
                            keptOf({{{window, WindowOperation::Add}}, keep}, line, *uses), all);
                    };
                    QVERIFY(keptAre(Keep::Inside, std::span(inside).first(count)));
                    QVERIFY(keptAre(Keep::Outside, std::span(outside).first(removed)));
                }
        }
    }

    // The general way must not differ where it could have been the short one.
    void listsThatAreOneRectangleGiveTheSameBits()
    {
        Random random(3);
        const clipping::Window away{{100, 100}, {101, 101}};
        for (int i = 0; i < 20'000; ++i) {
            const auto number = [&] {
                return random.whole(-3, 3) + random.of(std::array{0.0, random.unit()});
            };
            const Segment line{{number(), number()}, {number(), number()}};
            const glm::dvec2 p(number(), number()), q(number(), number());
            const clipping::Window window{glm::min(p, q), glm::max(p, q)};
            for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                const auto expected = keptOf({{{window, WindowOperation::Add}}, keep}, line);
                using enum WindowOperation;
                const Keep other = keep == Keep::Inside ? Keep::Outside : Keep::Inside;
                for (const ClipRegion& region : std::initializer_list<ClipRegion>{
                         {{{window, Add}, {window, Add}}, keep},
                         {{{window, Add}, {away, CutOut}}, keep},
                         {{{window, Intersect}}, keep},
                         {{{window, Intersect}, {window, Intersect}}, keep},
                         {{{away, Add}, {window, Add}}, keep},
                         {{{window, CutOut}}, other},
                         {{{away, CutOut}, {window, CutOut}}, other}})
                    QVERIFY(sameBits(keptOf(region, line), expected));
            }
        }
    }
    void anEndThatIsOutByLessThanAnUlpStaysOut()
    {
        const clipping::Window window{{0, 0}, {3, 3}};
        const Segment line{{1, -1e-30}, {2, 1}}; // x is 1 where it enters, to the last bit
        const auto kept =
            keptOf({{{window, WindowOperation::Add}, {window, WindowOperation::Intersect}}}, line);
        QCOMPARE(kept.size(), 1u);
        QCOMPARE(kept[0].segment, (Segment{{1, 0}, {2, 1}}));
    }
    void everyRowLeavesTheSameButForRounding()
    {
        GridCases cases(4);
        const auto isLong = [](const Segment& s) { return glm::distance(s.a, s.b) > 1e-9; };
        for (int i = 0; i < 2'000; ++i) {
            const auto list = cases.list();
            const bool inside = i % 2 == 0;
            const ClipRegion region = toRegion(list, inside, cases.random());
            const truth::Line line = cases.line();
            std::vector<Segment> expected;
            for (const auto& [from, to] : truth::kept(list, inside, line)) {
                const auto at = [&](const truth::Fraction& t) {
                    const auto p = truth::pointOf(line, t);
                    return glm::dvec2(boost::rational_cast<double>(p[0]),
                                      boost::rational_cast<double>(p[1]));
                };
                if (from != to)
                    expected.push_back({at(from), at(to)});
            }
            for (const auto& row : clipping::algorithms()) {
                std::vector<Segment> found;
                for (const Clipped& piece : keptOf(region, toSegment(line), row.corrected))
                    if (isLong(piece.segment))
                        found.push_back(piece.segment);
                QVERIFY2(std::ranges::equal(found, expected,
                                            [&](const Segment& a, const Segment& b) {
                                                return !isLong({a.a, b.a}) && !isLong({a.b, b.b});
                                            }),
                         (std::string(row.key) + " " + describe(list, inside, line)).c_str());
            }
        }
    }
    void boxesAreDecidedAsTheirLines()
    {
        GridCases cases(5);
        std::array<int, 3> decided{};
        for (int i = 0; i < 10'000; ++i) {
            const auto list = cases.list();
            const bool inside = i % 2 == 0;
            const ClipRegion region = toRegion(list, inside, cases.random());
            const auto p = cases.point(), q = cases.point();
            const clipping::Window box{glm::min(toDouble(p), toDouble(q)),
                                       glm::max(toDouble(p), toDouble(q))};
            const Remains remains = remainsOf(region, box);
            ++decided[std::size_t(remains)];
            for (int n = 0; n < 20 && remains != Remains::Pieces; ++n) {
                truth::Line line{};
                for (int k = 0; k < 2; ++k) {
                    line.a[std::size_t(k)] = cases.random().whole(int(box.min[k]), int(box.max[k]));
                    line.b[std::size_t(k)] = cases.random().whole(int(box.min[k]), int(box.max[k]));
                }
                const auto kept = truth::kept(list, inside, line);
                const bool whole = kept.size() == 1 && kept[0].from == truth::Fraction(0)
                                   && kept[0].to == truth::Fraction(line.a == line.b ? 0 : 1);
                QVERIFY2(remains == Remains::Whole ? whole : kept.empty(),
                         describe(list, inside, line).c_str());
            }
        }
        for (const int count : decided)
            QVERIFY(count > 1'000);
    }
    void boxesOnAnEdge()
    {
        const clipping::Window window{{0, 0}, {2, 2}};
        const ClipRegion in{{{window, WindowOperation::Add}}, Keep::Inside};
        const ClipRegion out{{{window, WindowOperation::Add}}, Keep::Outside};
        const auto are = [&](const clipping::Window& box, Remains inside, Remains outside) {
            return remainsOf(in, box) == inside && remainsOf(out, box) == outside;
        };
        QVERIFY(are({{0, 0}, {2, 2}}, Remains::Whole, Remains::Gone));
        QVERIFY(are({{2, 0}, {2, 1}}, Remains::Whole, Remains::Gone));
        QVERIFY(are({{2, 0}, {3, 1}}, Remains::Pieces, Remains::Pieces));
        QVERIFY(are({{2.5, 0}, {3, 1}}, Remains::Gone, Remains::Whole));
        QCOMPARE(remainsOf({}, {{notANumber, 0}, {3, 1}}), Remains::Whole);
        QCOMPARE(remainsOf({{}, Keep::Outside}, {{0, 0}, {3, 1}}), Remains::Whole);
    }
    void boxesThatAreNoneAreNotDecided()
    {
        const ClipRegion region{{{{{0, 0}, {2, 2}}, WindowOperation::Add}}, Keep::Inside};
        for (const double bad : {infinity, -infinity, notANumber})
            for (int i = 0; i < 4; ++i) {
                clipping::Window box{{5, 5}, {6, 6}};
                (i < 2 ? box.min : box.max)[i % 2] = bad;
                QCOMPARE(remainsOf(region, box), Remains::Pieces);
            }
        QCOMPARE(remainsOf(region, {{6, 5}, {5, 6}}), Remains::Pieces);
        QCOMPARE(remainsOf(region, {{5, 5}, {6, 6}}), Remains::Gone);
    }
    void invertedAndEndlessWindowsContainNothing()
    {
        const Segment line{{0, 0}, {4, 0}};
        const clipping::Window usual{{-1, -1}, {2, 1}}, box{{0, 0}, {4, 0}};
        using enum WindowOperation;
        for (const clipping::Window& empty : {clipping::Window{{3, -1}, {-1, 1}},
                                              {{-1, 1}, {5, -1}},
                                              {{-infinity, -1}, {5, 1}},
                                              {{-1, -1}, {notANumber, 1}}}) {
            const auto isGone = [&](const ClipRegion& region) {
                return keptOf(region, line).empty() && remainsOf(region, box) == Remains::Gone;
            };
            const auto isWhole = [&](const ClipRegion& region) {
                const auto kept = keptOf(region, line);
                return kept.size() == 1 && sameBits(kept[0].segment, line)
                       && remainsOf(region, box) == Remains::Whole;
            };
            QVERIFY(isGone({{{empty, Add}}, Keep::Inside}));
            QVERIFY(isWhole({{{empty, Add}}, Keep::Outside}));
            QVERIFY(isWhole({{{empty, CutOut}}, Keep::Inside}));
            QVERIFY(isGone({{{usual, Add}, {empty, Intersect}}, Keep::Inside}));
            QVERIFY(isGone({{{empty, CutOut}, {empty, Intersect}}, Keep::Inside}));
            QVERIFY(sameBits(keptOf({{{empty, Add}, {usual, Add}, {empty, CutOut}}}, line),
                             keptOf({{{usual, Add}}}, line)));
        }
    }
    void linesThatAreNotFiniteAreInNoWindow()
    {
        using enum WindowOperation;
        const clipping::Window window{{0, 0}, {2, 2}}, other{{1, 1}, {3, 3}};
        for (const double bad : {infinity, notANumber}) {
            const Segment line{{1, 1}, {bad, 1}};
            QVERIFY(keptOf({{{window, Add}, {other, Add}}, Keep::Inside}, line).empty());
            QCOMPARE(keptOf({{{window, Add}, {other, Add}}, Keep::Outside}, line).size(), 1u);
            std::vector<Clipped> kept; // whatever an algorithm says
            fold({{{window, Add}, {other, Add}}}, line, 0,
                 std::vector{2, std::optional(Clipped{{{1, 1}, {2, 1}}, 0, 0})}, kept);
            QVERIFY(kept.empty());
        }
    }
    // As published forms do: turned pieces, ends beyond the line's, and no numbers at all.
    void oddPiecesAreBorne()
    {
        using enum WindowOperation;
        const clipping::Window window{{1, -1}, {2, 1}}, other{{2, -1}, {5, 1}};
        const ClipRegion region{{{window, Add}, {other, Add}}};
        const Segment line{{0, 0}, {4, 0}};
        const auto foldOf = [&](const Segment& first, const std::optional<Segment>& second) {
            std::vector<Clipped> kept;
            const std::vector pieces{std::optional(Clipped{first, 0, 0xffffffff}),
                                     second ? std::optional(Clipped{*second, 0, 0}) : std::nullopt};
            fold(region, line, 0, pieces, kept);
            return kept;
        };
        const auto turned = foldOf({{2, 0}, {1, 0}}, Segment{{2, 0}, {4, 0}});
        QCOMPARE(turned.size(), 1u);
        QCOMPARE(turned[0].segment, (Segment{{1, 0}, {4, 0}}));
        QCOMPARE(foldOf({{notANumber, 0}, {1, 0}}, std::nullopt).size(), 0u);
        QCOMPARE(foldOf({{1, 0}, {2, 0}}, Segment{{3, infinity}, {4, 0}}).size(), 1u);
        QCOMPARE(foldOf({{-9, 0}, {9, 0}}, std::nullopt)[0].segment, (Segment{{-9, 0}, {9, 0}}));
    }
    void hiddenWindowsAreLeftOutAndOtherShapesArePrepared()
    {
        const RectangleShape straight{{{1, 2}, {3, 4}}}, turned{{{1, 2}, {3, 4}}, 0.5};
        const Subpath triangle{{0, 0}, {{{1, 0}}, {{0, 1}}}, true};
        const PathShape polygon{Path({&triangle, 1})};
        const auto hidden = WindowOperation::Add;
        ClipWindows windows{{{{}, polygon, hidden, false}, {{}, straight, hidden, false}}};
        const Page page;
        QVERIFY(regionOf(windows, 1).everything());
        QCOMPARE(comparedWindow(windows, page), (ComparedWindow{page.rectangle(), true}));
        windows.list.push_back({{}, straight, WindowOperation::CutOut});
        QVERIFY(regionOf(windows, 1).prepared && regionOf(windows, 1).startsFull());
        QVERIFY(!regionOf({{{.shape = straight}}}, 1).prepared);
        windows.list.push_back({{}, turned});
        windows.list.push_back({{}, polygon});
        const ClipRegion region = regionOf(windows, 1);
        QVERIFY(region.prepared && region.startsFull());
        QCOMPARE(region.steps.size(), 3u);
        QCOMPARE(region.steps[1].rings.at(0).size(), 4u);
        QVERIFY(region.steps[2].box == (clipping::Window{{0, 0}, {1, 1}}));
        QCOMPARE(comparedWindow(windows, page), (ComparedWindow{straight.box, false, 2}));
    }
    void manyWindowsFoldAsWell()
    {
        ClipRegion tiles; // a row of tiles with shared edges, of which every tenth is cut out again
        constexpr int count = int(ClipWindows::most) * 10 / 11;
        for (int i = 0; i < count; ++i)
            tiles.steps.push_back({{{i, 0}, {i + 1, 1}}, WindowOperation::Add});
        for (int i = 9; i < count; i += 10)
            tiles.steps.push_back({{{i, 0}, {i + 1, 1}}, WindowOperation::CutOut});
        for (const auto& row : clipping::algorithms()) {
            const auto kept = keptOf(tiles, {{-1, 0.1}, {count + 1, 0.9}}, row.corrected);
            QCOMPARE(kept.size(), std::size_t((count + 9) / 10));
            for (std::size_t i = 0; i < kept.size(); ++i) {
                QCOMPARE(kept[i].segment.a.x, double(i) * 10);
                QCOMPARE(kept[i].segment.b.x, std::min(double(i) * 10 + 9, double(count)));
            }
        }
    }
};

} // namespace scene_region_test

TEST_CLASS(scene_region_test::RegionTest, Gui)
#include "tests/app/scene/region_test.moc"
