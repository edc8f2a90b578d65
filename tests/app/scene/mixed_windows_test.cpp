// SPDX-License-Identifier: GPL-3.0-or-later
// What the scene keeps at windows of several shapes together, against exact fractions.
#include "app/cut/cut.h"
#include "app/document/document_builder.h"
#include "app/scene/window_needs.h"
#include "clipping/region/catalogue.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

#include "tests/app/document/kept_in.h"
#include "tests/app/scene/block_scene.h"
#include "tests/app/scene/mixed_windows.h"
#include "tests/clipping/region/contract.h"
#include "tests/test_class.h"

namespace scene_mixed_windows_test {

using namespace app;
using clipping::Clipped;
using clipping::Segment;

namespace {

constexpr double tolerance = 2; // so that curves have few edges
using Truth = region_oracle::Truth<Rational>;

/// Some lines as a scene.
class LineScene {
public:
    explicit LineScene(const std::vector<Segment>& lines)
    {
        for (const Segment& line : lines)
            objects_.append({Path(line), {.stroke = Colour{}}});
        scene_.update(objects_, {}, tolerance);
    }
    std::vector<Clipped> kept(const ClipRegion& region, const Variant& variant)
    {
        return keptIn(scene_.clip(region, variant));
    }

private:
    Objects objects_;
    BlockScene scene_;
};

std::vector<Segment> piecesOf(const std::vector<Clipped>& all, std::uint32_t line)
{
    std::vector<Segment> pieces;
    for (const Clipped& piece : all)
        if (piece.source == line)
            pieces.push_back(piece.segment);
    return pieces;
}

// To 2^-60, far less than any error here.
double toDouble(const Rational& number)
{
    const Rational::int_type scaled = (number.numerator() << 60) / number.denominator();
    return scaled.convert_to<double>() * 0x1p-60;
}

glm::dvec2 nearest(const region_oracle::Point<Rational>& p)
{
    return {toDouble(p.x), toDouble(p.y)};
}

constexpr double far = 1e-10; // more than any row's error here, in user units

/// Whether the pieces are those, apart from rounding.
bool areNear(std::vector<Segment> pieces, std::vector<Segment> expected)
{
    const auto isShort = [](const Segment& s) { return glm::distance(s.a, s.b) < 2 * far; };
    std::erase_if(pieces, isShort);
    std::erase_if(expected, isShort);
    return std::ranges::equal(pieces, expected, [](const Segment& p, const Segment& q) {
        return glm::distance(p.a, q.a) < far && glm::distance(p.b, q.b) < far;
    });
}

/// Every form that clips itself at such windows.
std::vector<Variant> variantsFor(WindowNeeds needs)
{
    std::vector<Variant> all;
    for (const clipping::Algorithm& row : clipping::algorithms())
        if (usedAt(needs, {&row}) == Variant{&row})
            all.push_back({&row});
    return all;
}

std::vector<Variant> everyForm()
{
    std::vector<Variant> all;
    for (const clipping::Algorithm& row : clipping::algorithms())
        for (const auto form : {clipping::Form::Corrected, clipping::Form::Published})
            if (functionsOf(row, form))
                all.push_back({&row, form});
    return all;
}

/// Ascending: a cut may join the pieces of a line in a path.
using Segments = std::vector<std::array<double, 4>>;

Segments sorted(Segments all)
{
    std::ranges::sort(all);
    return all;
}

Segments linesOf(const Objects& objects)
{
    Segments all;
    for (std::size_t i = 0; i < objects.size(); ++i)
        for (const Subpath& path : objects[i].path().subpaths()) {
            Point from = path.start;
            for (const PathSegment& segment : path.segments) {
                all.push_back({from.x, from.y, segment.to.x, segment.to.y});
                from = segment.to;
            }
        }
    return sorted(std::move(all));
}

Segments segmentsOf(const std::vector<Clipped>& pieces)
{
    Segments all;
    for (const auto& [piece, source, cut] : pieces)
        if (std::isfinite(piece.a.x + piece.a.y + piece.b.x + piece.b.y))
            all.push_back({piece.a.x, piece.a.y, piece.b.x, piece.b.y});
    return sorted(std::move(all));
}

} // namespace

class MixedWindowsTest : public QObject {
    Q_OBJECT

private slots:
    void fiveWindowsKeepWhatTheyShould_data()
    {
        QTest::addColumn<int>("most");
        QTest::addRow("rectangles") << int(Mixed::Rectangle);
        QTest::addRow("rotated rectangles") << int(Mixed::Rotated);
        QTest::addRow("convex polygons") << int(Mixed::Convex);
        QTest::addRow("stars") << int(Mixed::Any);
    }
    void fiveWindowsKeepWhatTheyShould()
    {
        QFETCH(const int, most);
        MixedWindows random{unsigned(most)};
        std::size_t pieces = 0;
        for (int round = 0; round < 12; ++round) {
            const ClipRegion region =
                regionOf(random.windows(round < 6 ? 5 : 1, Mixed(most)), tolerance);
            const clipping::Region areas = areasOf(region); // the truth refers to it
            const Truth truth(areas);
            std::vector<Segment> lines;
            while (lines.size() < 6)
                lines.push_back(random.line());
            LineScene scene(lines);
            std::vector<std::vector<Segment>> expected(lines.size());
            const auto exact = scene.kept(region, {&clipping::exactAlgorithm()});
            for (std::uint32_t line = 0; line < lines.size(); ++line) {
                const auto kept = truth.kept(lines[line]);
                const auto found = piecesOf(exact, line);
                QCOMPARE(found.size(), kept.size());
                for (std::size_t i = 0; i < kept.size(); ++i) {
                    const auto from = truth.pointOf(lines[line], kept[i].from);
                    const auto to = truth.pointOf(lines[line], kept[i].to);
                    expected[line].push_back({nearest(from), nearest(to)});
                    for (const auto& [end, truly] :
                         {std::pair(found[i].a, from), std::pair(found[i].b, to)})
                        QVERIFY(region_contract::isNearest(end.x, truly.x)
                                && region_contract::isNearest(end.y, truly.y));
                }
                pieces += kept.size();
            }
            for (const Variant& variant : variantsFor(needsOf(region))) {
                const auto all = scene.kept(region, variant);
                for (std::uint32_t line = 0; line < lines.size(); ++line)
                    QVERIFY2(areNear(piecesOf(all, line), expected[line]),
                             variant.algorithm->key.data());
            }
        }
        QVERIFY(pieces > 30);
    }

    // Hexagons and a rectangle in a row: a line across all of them is one piece.
    void windowsThatShareAnEdgeLeaveOnePiece()
    {
        const double h = 8.66;
        const auto polygon = [](std::vector<Point> corners) {
            Subpath ring{corners[0], {}, true};
            for (std::size_t i = 1; i < corners.size(); ++i)
                ring.segments.push_back({corners[i]});
            return PathShape{Path({&ring, 1})};
        };
        const ClipWindows windows{
            {{.shape = polygon({{0, 0}, {10, -h}, {20, 0}, {17, 9.1}, {3, 10}})},
             {.shape = polygon({{20, 0}, {30, -h}, {30, 20}, {17, 9.1}})},
             {.shape = RectangleShape{{{30, -10}, {45, 22}}}},
             {.shape = polygon({{45, -5}, {60, 1}, {45, 20}})}}};
        const ClipRegion region = regionOf(windows, tolerance);
        MixedWindows random(7);
        std::vector<Segment> lines;
        while (lines.size() < 300)
            lines.push_back({{random.number(1, 5), random.number(0, 3)},
                             {random.number(46, 50), random.number(0, 3)}});
        LineScene scene(lines);
        for (const Variant& variant : variantsFor(needsOf(region))) {
            const auto kept = scene.kept(region, variant);
            QCOMPARE(kept.size(), lines.size());
            for (const Clipped& piece : kept)
                QVERIFY(piece.segment == lines[piece.source] && piece.cut == 0);
        }
    }

    // What the canvas shows is what export writes, with every algorithm, chosen or used instead.
    void aCutLeavesWhatTheFrameShows()
    {
        MixedWindows random(11);
        for (int round = 0; round < 12; ++round) {
            const ClipRegion region =
                regionOf(random.windows(round % 3 == 0 ? 1 : 4, Mixed(round % 4)), tolerance);
            DocumentBuilder builder;
            builder.open({.name = "Lines"});
            const StyleEntry style = builder.style({.stroke = Colour{}});
            std::vector<Segment> lines;
            while (lines.size() < 150)
                builder.addLine(lines.emplace_back(random.line()), style);
            builder.close();
            const Document document = builder.take({});
            LineScene scene(lines);
            for (const Variant& variant : everyForm()) {
                CutOptions options{functionsOf(*variant.algorithm, variant.form)->clipAll, region};
                options.keepContacts = true;
                Document after = document;
                after.apply(cut(document, options).edit);
                QVERIFY2(linesOf(after.objects()) == segmentsOf(scene.kept(region, variant)),
                         variant.algorithm->key.data());
            }
        }
    }

    void aWindowWithoutAreaContainsNothingAloneAndBesideOthers()
    {
        LineScene scene({{{0, 5}, {9, 5}}, {{3, 0}, {3, 9}}});
        const ClipWindow flat{.shape = RectangleShape{{{3, 1}, {3, 8}}}},
            turned{.shape = RectangleShape{{{3, 1}, {3, 8}}, 0.3}},
            rotated{.shape = RectangleShape{{{20, 20}, {30, 30}}, 0.3}},
            box{.shape = RectangleShape{{{20, 20}, {30, 30}}}};
        for (const ClipWindows& windows : std::initializer_list<ClipWindows>{
                 {{flat}}, {{turned}}, {{flat, box}}, {{flat, rotated}}, {{turned, rotated}}})
            for (const auto& row : clipping::algorithms())
                QCOMPARE(scene.kept(regionOf(windows, tolerance), {&row}).size(), 0u);
    }

    // A published form clips at rotated rectangles itself; it may lose what its authors lost.
    void publishedFormsClipAtRotatedRectangles()
    {
        const ClipRegion region =
            regionOf({{{.shape = RectangleShape{{{20, 20}, {60, 50}}, 0.4}}}}, tolerance);
        MixedWindows random(9);
        std::vector<Segment> lines;
        while (lines.size() < 500)
            lines.push_back(random.line());
        LineScene scene(lines);
        for (const auto& row : clipping::algorithms())
            if (row.published) {
                std::vector<Clipped> expected(lines.size());
                expected.resize(
                    clipAllTurned(*row.published, lines, *region.steps[0].turned, expected));
                const auto kept = scene.kept(region, {&row, clipping::Form::Published});
                QVERIFY(std::ranges::equal(kept, expected, {}, &Clipped::source, &Clipped::source));
                QVERIFY(
                    std::ranges::equal(kept, expected, {}, &Clipped::segment, &Clipped::segment));
            }
    }
};

} // namespace scene_mixed_windows_test

TEST_CLASS(scene_mixed_windows_test::MixedWindowsTest, None)
#include "tests/app/scene/mixed_windows_test.moc"
