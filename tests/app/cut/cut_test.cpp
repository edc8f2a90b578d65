// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut.h"
#include "app/document/document_builder.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <numbers>
#include <random>

#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace cut_cut_test {

using app::Keep;
using app::Point;
using app::Sheet;
using app::Subpath;

namespace {

constexpr clipping::Window window{{-1, -2}, {3, 2}};

Sheet sheetOf(std::vector<Subpath> paths, app::Style style = {.stroke = app::Colour{}})
{
    Sheet sheet;
    sheet.shapes.push_back({std::move(paths), std::move(style), QStringLiteral("s"), 0, false});
    return sheet;
}

struct Left {
    Sheet sheet;
    app::CutCounts counts;
    std::vector<std::uint32_t> sources;
    app::Document document{};
};

// Each group with the number of its objects.
QStringList groupsOf(const app::Document& document)
{
    const app::Containers& tree = document.containers();
    QStringList groups;
    for (const app::ContainerId id : tree.inOrder())
        if (tree[id].kind == app::Container::Kind::Group)
            groups << QStringLiteral("%1: %2").arg(tree[id].svgId).arg(tree.rangeOf(id).size());
    return groups;
}

std::pair<app::Document, app::CutCounts> cutAt(app::Document document, app::CutOptions options)
{
    options.clipAll = clipping::exactAlgorithm().corrected.clipAll;
    options.region = {{{window, app::WindowOperation::Add}}};
    const app::Cut cut = app::cut(document, options);
    document.apply(cut.edit);
    return {document, cut.counts};
}

Left cutAt(const Sheet& sheet, const app::ClipRegion& region, double tolerance = 1e-3)
{
    const auto* algorithm = clipping::findAlgorithm("matthes-drakopoulos");
    app::Document document = app::documentOf(sheet);
    const app::Cut cut = app::cut(document, {algorithm->corrected.clipAll, region, tolerance});
    const auto sources = app::sourcesOf(cut, document.objects().size());
    document.apply(cut.edit);
    return {app::sheetOf(document), cut.counts, sources, document};
}

Left cutAt(const Sheet& sheet, Keep keep, double tolerance = 1e-3)
{
    return cutAt(sheet, {{{window, app::WindowOperation::Add}}, keep}, tolerance);
}

double lengthOf(const Sheet& sheet, double tolerance = 1e-6)
{
    double length = 0;
    std::vector<app::Chord> chords;
    for (const auto& shape : sheet.shapes)
        for (const auto& path : shape.paths)
            app::flatten(path, tolerance, chords);
    for (const auto& chord : chords)
        length += glm::distance(chord.segment.a, chord.segment.b);
    return length;
}

bool within(const Point& p)
{
    return p.x >= window.min.x && p.x <= window.max.x && p.y >= window.min.y && p.y <= window.max.y;
}

Subpath randomPath(std::mt19937_64& random, bool curves)
{
    std::uniform_real_distribution<double> number(-6, 6);
    const auto point = [&] { return Point(number(random), number(random)); };
    Subpath path{point(), {}, random() % 2 == 0};
    for (auto n = 1 + random() % 6; n > 0; --n)
        path.segments.push_back(curves && random() % 2
                                    ? app::PathSegment{point(), point(), point(), true}
                                    : app::PathSegment{point()});
    return path;
}

} // namespace

class CutTest : public QObject {
    Q_OBJECT

private slots:
    void aClosedShapeIsOneRunAcrossItsStart()
    {
        // The start lies inside, so the inside part goes over it.
        const Subpath square{{0, 0}, {{{10, 0}}, {{10, 1}}, {{0, 1}}}, true};
        const auto cut = cutAt(sheetOf({square}), Keep::Inside);
        QCOMPARE(cut.sheet.shapes.size(), 1u);
        const auto& paths = cut.sheet.shapes[0].paths;
        QCOMPARE(paths.size(), 1u);
        QCOMPARE(paths[0], (Subpath{{3, 1}, {{{0, 1}}, {{0, 0}}, {{3, 0}}}, false}));
        QCOMPARE(cut.counts.opened, 1u);

        const auto rest = cutAt(sheetOf({square}), Keep::Outside);
        QCOMPARE(rest.sheet.shapes[0].paths.size(), 1u);
        QCOMPARE(rest.sheet.shapes[0].paths[0],
                 (Subpath{{3, 0}, {{{10, 0}}, {{10, 1}}, {{3, 1}}}, false}));
    }

    void wholeShapesComeBackUnchanged()
    {
        app::Style style{.stroke = {}, .fill = app::Colour{1, 2, 3, 4}};
        style.cap = app::Cap::Round;
        const Sheet sheet =
            sheetOf({{{0, 0}, {{{1, 1}}, {{2, 0}, {1, 0}, {1.5, 0}, true}}, true}}, style);
        const auto cut = cutAt(sheet, Keep::Inside);
        QCOMPARE(cut.sheet, sheet);
        QCOMPARE(cut.counts.whole, 1u);
        QVERIFY(cutAt(sheet, Keep::Outside).sheet.shapes.empty());
    }

    void aCutAreaStaysFilled()
    {
        const app::Style red{.fill = app::Colour{255, 0, 0, 255}};
        const auto cut = cutAt(sheetOf({{{0, 0}, {{{9, 0}}, {{9, 9}}}, true}}, red), Keep::Inside);
        QCOMPARE(cut.sheet.shapes.size(), 1u);
        QCOMPARE(cut.sheet.shapes[0].style, red);
        QCOMPARE(cut.sheet.shapes[0].id, QStringLiteral("s"));
        QCOMPARE(cut.sheet.shapes[0].paths,
                 (std::vector{Subpath{{0, 0}, {{{3, 0}}, {{3, 2}}, {{2, 2}}}, true}}));
    }

    // No stroke runs along the cut.
    void anAreaWithAStrokeBecomesAGroup()
    {
        const app::Colour red{255, 0, 0, 255}, blue{0, 0, 255, 255};
        const Subpath triangle{{0, 0}, {{{9, 0}}, {{9, 9}}}, true};
        const auto cut = cutAt(sheetOf({triangle}, {.stroke = blue, .fill = red}), Keep::Inside);
        QCOMPARE(cut.sheet.shapes.size(), 2u);
        QVERIFY(!cut.sheet.shapes[0].style.stroke);
        QCOMPARE(cut.sheet.shapes[0].style.fill, std::optional(red));
        QVERIFY(!cut.sheet.shapes[1].style.fill);
        QCOMPARE(cut.sheet.shapes[1].style.stroke, std::optional(blue));
        QCOMPARE(cut.sheet.shapes[1].paths,
                 (std::vector{Subpath{{2, 2}, {{{0, 0}}, {{3, 0}}}, false}}));
        QCOMPARE(groupsOf(cut.document), QStringList{"s: 2"});
        QCOMPARE(cut.sheet.shapes[0].id + cut.sheet.shapes[1].id, QString());
    }

    // Also between other objects, in groups, and with dashes.
    void theGroupStandsWhereTheAreaStood()
    {
        app::Style both{.stroke = app::Colour{}, .fill = app::Colour{}};
        const auto square = [](double x) {
            return std::vector{Subpath{{x, 0}, {{{x + 5, 0}}, {{x + 5, 5}}, {{x, 5}}}, true}};
        };
        app::DocumentBuilder builder;
        builder.open({.name = "layer"});
        builder.add({app::Path(square(8)), both, {.id = "gone"}});
        builder.open({.kind = app::Container::Kind::Group, .svgId = "houses"});
        builder.add({app::Path(square(1)), both, {.id = "first", .title = "<title/>"}});
        builder.add({app::Path(clipping::Segment{{0, 0}, {9, 0}}), both, {.id = "line"}});
        both.dashes = {3, 1};
        builder.add({app::Path(square(-3)), both, {.id = "dashed"}});
        builder.close();
        builder.close();
        const auto [document, counts] = cutAt(builder.take({}), {});
        QCOMPARE(groupsOf(document), (QStringList{"houses: 5", "first: 2", "dashed: 2"}));
        const auto groups = document.containers().inOrder();
        QCOMPARE(document.containers()[groups[2]].title, QStringLiteral("<title/>"));
        QCOMPARE(document.containers().rangeOf(groups[2]), (app::ObjectRange{0, 2}));
        QCOMPARE(document.objects()[2].particulars().id, QStringLiteral("line"));
        QCOMPARE(counts.cut, 3u);
    }

    void cuttingTwiceChangesNothing()
    {
        std::mt19937_64 random(21);
        const app::Style both{.stroke = app::Colour{}, .fill = app::Colour{}};
        for (int i = 0; i < 200; ++i) {
            const auto sheet =
                sheetOf({randomPath(random, false), randomPath(random, false)}, both);
            const auto once = cutAt(app::documentOf(sheet), {}).first;
            QVERIFY(cutAt(once, {}).first == once);
        }
    }

    void aCutAreaCanBeClosedAlongTheWindow()
    {
        const app::Style both{.stroke = app::Colour{1, 2, 3}, .fill = app::Colour{}};
        const Subpath triangle{{0, 0}, {{{9, 0}}, {{9, 9}}}, true};
        const Subpath spur{{-5, 1}, {{{0, 1}}}, false};
        const auto sheet = sheetOf({triangle}, both);
        const auto [document, counts] = cutAt(app::documentOf(sheet), {.closeAreas = true});
        const Sheet cut = app::sheetOf(document);
        QCOMPARE(cut.shapes.size(), 1u);
        QCOMPARE(cut.shapes[0].style, both);
        QCOMPARE(cut.shapes[0].id, QStringLiteral("s"));
        QCOMPARE(cut.shapes[0].paths,
                 (std::vector{Subpath{{0, 0}, {{{3, 0}}, {{3, 2}}, {{2, 2}}}, true}}));
        QCOMPARE(counts.opened, 0u);

        const auto more = app::documentOf(sheetOf({triangle, spur}, both));
        const Sheet two = app::sheetOf(cutAt(more, {.closeAreas = true}).first);
        QCOMPARE(two.shapes.size(), 2u);
        QCOMPARE(two.shapes[1].paths, (std::vector{Subpath{{-1, 1}, {{{0, 1}}}, false}}));
    }

    void shortPiecesCanBeDropped()
    {
        // Pieces of 0.5 at the left edge and of 2 at the right one; and a whole line of 0.1.
        const auto sheet = sheetOf({{{-3, 0}, {{{-0.5, 0}}}, false},
                                    {{1, 0}, {{{9, 0}}}, false},
                                    {{0, 1}, {{{0, 1.1}}}, false}});
        const auto [document, counts] = cutAt(app::documentOf(sheet), {.leastLength = 1});
        QCOMPARE(app::sheetOf(document).shapes.at(0).paths,
                 (std::vector{Subpath{{1, 0}, {{{3, 0}}}, false},
                              Subpath{{0, 1}, {{{0, 1.1}}}, false}}));
        QCOMPARE(counts.dropped, 1u);
        const auto [none, both] =
            cutAt(app::documentOf(sheetOf({{{-3, 0}, {{{-0.5, 0}}}, false}})), {.leastLength = 1});
        QCOMPARE(none.objects().size(), 0u);
        QCOMPARE(both.dropped, 1u);
        QCOMPARE(both.gone, 1u);
    }

    // None of its lines is in the window, or all of them are.
    void anAreaAroundAWindowIsCut()
    {
        const app::Style red{.fill = app::Colour{255, 0, 0, 255}};
        const Subpath square{{-9, -9}, {{{9, -9}}, {{9, 9}}, {{-9, 9}}}, true};
        const auto inside = cutAt(sheetOf({square}, red), Keep::Inside);
        QCOMPARE(inside.sheet.shapes.size(), 1u);
        QCOMPARE(inside.sheet.shapes[0].paths,
                 (std::vector{Subpath{{-1, -2}, {{{3, -2}}, {{3, 2}}, {{-1, 2}}}, true}}));
        const auto outside = cutAt(sheetOf({square}, red), Keep::Outside);
        QCOMPARE(outside.sheet.shapes.size(), 1u);
        QCOMPARE(outside.sheet.shapes[0].paths.size(), 2u); // with a hole
        QCOMPARE(outside.counts.cut, 1u);
    }

    void aLineHasNothingToFill()
    {
        const app::Style filled{.fill = app::Colour{}};
        const auto cut = cutAt(sheetOf({{{0, 0}, {{{9, 0}}}, false}}, filled), Keep::Inside);
        QVERIFY(!cut.sheet.shapes[0].style.stroke && !cut.sheet.shapes[0].style.fill);
    }

    void everyShapeKnowsWhereItCameFrom()
    {
        app::Style dashed{.stroke = app::Colour{}};
        dashed.dashes = {1};
        Sheet sheet = sheetOf({{{9, 9}, {{{8, 8}}}, false}});
        const auto add = [&](Subpath path) {
            sheet.shapes.push_back({{std::move(path)}, dashed, {}, 0, false});
        };
        add({{-5, 0}, {{{5, 0}}, {{5, 1}}, {{-5, 1}}}, false});
        add({{0, 0}, {{{1, 1}}}, false});
        QCOMPARE(cutAt(sheet, Keep::Inside).sources, (std::vector<std::uint32_t>{1, 1, 2}));
        QCOMPARE(cutAt(sheet, Keep::Outside).sources, (std::vector<std::uint32_t>{0, 1, 1, 1}));
    }

    void aContactIsLeftOutAPointIsKept()
    {
        const Subpath touch{{2, 3}, {{{4, 1}}}, false}; // the corner (3, 2)
        QVERIFY(cutAt(sheetOf({touch}), Keep::Inside).sheet.shapes.empty());
        QCOMPARE(cutAt(sheetOf({touch}), Keep::Outside).sheet, sheetOf({touch}));
        const Subpath point{{1, 1}, {}, false};
        QCOMPARE(cutAt(sheetOf({point}), Keep::Inside).sheet, sheetOf({point}));
    }

    void onlyDashesKeepTheirCaps()
    {
        for (const bool dotted : {true, false}) {
            app::Style style{.stroke = app::Colour{}, .width = 2, .cap = app::Cap::Round};
            if (dotted)
                style.dashes = {0, 4};
            const auto kept = cutAt(sheetOf({{{-5, 0}, {{{5, 0}}}, false}}, style), Keep::Inside);
            QCOMPARE(kept.sheet.shapes[0].style.cap, dotted ? app::Cap::Round : app::Cap::Butt);
        }
    }

    void dashesGoOnWhereTheyWere()
    {
        app::Style style{.stroke = app::Colour{}};
        style.dashes = {2, 1};
        style.dashOffset = 0.5;
        const Subpath zigzag{{-5, 0}, {{{5, 0}}, {{5, 1}}, {{-5, 1}}}, false};
        const auto cut = cutAt(sheetOf({zigzag}, style), Keep::Inside);
        QCOMPARE(cut.sheet.shapes.size(), 2u);
        QCOMPARE(cut.sheet.shapes[0].style.dashOffset, 4.5);
        QCOMPARE(cut.sheet.shapes[1].style.dashOffset, 13.5);
        QCOMPARE(cut.sheet.shapes[0].id, QStringLiteral("s"));
        QCOMPARE(cut.sheet.shapes[1].id, QStringLiteral("s-2"));
    }

    void aCurveIsSplitOnItself()
    {
        // A quarter circle of radius 4 about the origin: it leaves the window through x = 3.
        constexpr double k = 4 * 4 * (std::numbers::sqrt2 - 1) / 3;
        const Subpath arc{{4, 0}, {{{0, 4}, {4, k}, {k, 4}, true}}, false};
        const auto rest = cutAt(sheetOf({arc}), Keep::Outside);
        QCOMPARE(rest.sheet, sheetOf({arc})); // it passes the corner (3, 2) outside
        const Subpath big{
            {2.5, 0}, {{{0, 2.5}, {2.5, 2.5 * k / 4}, {2.5 * k / 4, 2.5}, true}}, false};
        const auto cut = cutAt(sheetOf({big}), Keep::Inside);
        QCOMPARE(cut.sheet.shapes[0].paths.size(), 1u);
        const auto& part = cut.sheet.shapes[0].paths[0];
        QCOMPARE(part.segments.size(), 1u);
        QVERIFY(part.segments[0].curved);
        QCOMPARE(part.segments[0].to.y, 2.0);                  // on the edge, bit for bit
        QVERIFY(std::abs(part.segments[0].to.x - 1.5) < 1e-3); // 2.5² = 1.5² + 2²
    }

    void severalWindowsAreFolded()
    {
        using app::WindowOperation;
        // Two windows side by side, and a hole across the edge that they share.
        const app::ClipRegion region{{{{{0, 0}, {2, 4}}, WindowOperation::Add},
                                      {{{2, 0}, {4, 4}}, WindowOperation::Add},
                                      {{{1, 1}, {3, 2}}, WindowOperation::CutOut}}};
        const Subpath across{{-1, 3}, {{{5, 3}}}, false}, holed{{-1, 1.5}, {{{5, 1.5}}}, false};
        const auto cut = cutAt(sheetOf({across}), region);
        QCOMPARE(cut.sheet.shapes.at(0).paths, (std::vector{Subpath{{0, 3}, {{{4, 3}}}, false}}));
        QCOMPARE(cutAt(sheetOf({holed}), region).sheet.shapes.at(0).paths,
                 (std::vector{Subpath{{0, 1.5}, {{{1, 1.5}}}, false},
                              Subpath{{3, 1.5}, {{{4, 1.5}}}, false}}));
        app::ClipRegion outside = region;
        outside.keep = Keep::Outside;
        QCOMPARE(cutAt(sheetOf({holed}), outside).sheet.shapes.at(0).paths,
                 (std::vector{Subpath{{-1, 1.5}, {{{0, 1.5}}}, false},
                              Subpath{{1, 1.5}, {{{3, 1.5}}}, false},
                              Subpath{{4, 1.5}, {{{5, 1.5}}}, false}}));
        QCOMPARE(cutAt(sheetOf({across}), app::ClipRegion()).sheet, sheetOf({across}));
    }

    void curvesEndOnTheEdgeOfTheWindowThatCutsThem()
    {
        using app::WindowOperation;
        const app::ClipRegion region{{{{{-9, -9}, {0, 9}}, WindowOperation::Add},
                                      {{{1, -9}, {9, 9}}, WindowOperation::Add}}};
        std::mt19937_64 random(9);
        std::size_t ends = 0;
        for (int round = 0; round < 200; ++round) {
            const auto cut = cutAt(sheetOf({randomPath(random, true)}), region);
            for (const auto& shape : cut.sheet.shapes)
                for (const auto& path : shape.paths)
                    if (!path.closed)
                        for (const Point& end : {path.start, path.segments.back().to}) {
                            QVERIFY(end.x <= 0 || end.x >= 1);
                            ends += end.x == 0 || end.x == 1;
                        }
        }
        QVERIFY(ends > 100);
    }

    // The same as object by object, however many are clipped at once.
    void manyObjectsAreCutAsEachAlone()
    {
        std::mt19937_64 random(10);
        const app::Style style{.stroke = app::Colour{}};
        app::Objects objects, left;
        std::vector<std::uint32_t> sources;
        app::CutOptions options{clipping::algorithms().front().corrected.clipAll};
        options.region.steps = {{window, app::WindowOperation::Add}};
        options.tolerance = 1e-3;
        for (std::uint32_t i = 0; i < 3'000; ++i) {
            const std::vector paths{randomPath(random, true), randomPath(random, i % 2 == 0)};
            const app::Object object{app::Path(paths), style};
            objects.append(object);
            for (const app::Object& part : app::cutAlone(object, options)) {
                left.append(part);
                sources.push_back(i);
            }
        }
        app::DocumentBuilder builder;
        builder.open({});
        builder.add(objects);
        builder.close();
        app::Document document = builder.take({});
        const app::Cut cut = app::cut(document, options);
        QVERIFY(cut.counts.segmentsBefore > 200'000);
        QCOMPARE(app::sourcesOf(cut, objects.size()), sources);
        document.apply(cut.edit);
        QVERIFY(document.objects() == left);
    }

    void whatIsKeptIsSharedAndEmptyGroupsGo()
    {
        app::DocumentBuilder builder;
        const auto style = builder.style({.stroke = app::Colour{}});
        builder.open({.name = "layer"});
        for (int i = 0; i < 10'000; ++i)
            builder.addLine({{0, 0}, {1e-4 * i, 1}}, style);
        builder.open({.kind = app::Container::Kind::Group, .name = "outside"});
        builder.addLine({{8, 8}, {9, 9}}, style);
        builder.close();
        builder.open({.kind = app::Container::Kind::Group, .name = "across"});
        app::Object object{app::Path(clipping::Segment{{0, 1}, {9, 1}}), {}};
        object.particulars = {"id", "<title/>", {}, app::EllipseRecipe{}};
        builder.add(object);
        builder.close();
        builder.close();
        builder.open({.name = "empty afterwards"});
        builder.addLine({{8, 8}, {9, 9}}, style);
        builder.close();
        const app::Document before = builder.take({});
        app::CutOptions options{clipping::exactAlgorithm().corrected.clipAll};
        options.region.steps = {{window, app::WindowOperation::Add}};
        app::Document after = before;
        after.apply(app::cut(before, options).edit);
        QVERIFY(sameAddress(after.objects().blocks()[0], before.objects().blocks()[0]));
        const app::Containers& containers = after.containers();
        QStringList names;
        for (const app::ContainerId id : containers.inOrder())
            names << containers[id].name;
        QCOMPARE(names, (QStringList{"layer", "across", "empty afterwards"}));
        const app::ObjectView last = after.objects()[after.objects().size() - 1];
        QCOMPARE(last.singleLine()->b, Point(3, 1));
        QVERIFY(last.particulars() == (app::Particulars{"id", "<title/>"}));
    }

    void progressIsToldAndAStopEndsTheCut()
    {
        Sheet sheet;
        for (int i = 0; i < 50; ++i)
            sheet.shapes.push_back({{{{-5, 0}, {{{double(i), 1}}}, false}}, {}, {}, 0, false});
        const app::Document document = app::documentOf(sheet);
        app::CutOptions options{clipping::exactAlgorithm().corrected.clipAll};
        options.region.steps = {{window, app::WindowOperation::Add}};
        std::vector<double> shares;
        const auto note = [&](const app::Progress& progress) { shares.push_back(progress.share); };
        app::cut(document, options, {{}, note});
        QVERIFY(!shares.empty() && std::ranges::is_sorted(shares));
        QCOMPARE(shares.back(), 1.0);
        std::stop_source stop;
        shares.clear();
        app::cut(document, options, {stop.get_token(), [&](const app::Progress& progress) {
                                         note(progress);
                                         stop.request_stop();
                                     }});
        QCOMPARE(shares.size(), std::size_t(1));
    }

    void insideAndOutsideAreTheWhole()
    {
        std::mt19937_64 random(7);
        for (int round = 0; round < 2000; ++round) {
            const Sheet sheet = sheetOf({randomPath(random, false), randomPath(random, false)});
            const auto inside = cutAt(sheet, Keep::Inside), outside = cutAt(sheet, Keep::Outside);
            const double whole = lengthOf(sheet);
            QVERIFY(std::abs(lengthOf(inside.sheet) + lengthOf(outside.sheet) - whole)
                    <= 1e-9 * whole);
            for (const auto& shape : inside.sheet.shapes)
                for (const auto& path : shape.paths) {
                    QVERIFY(within(path.start));
                    QVERIFY(std::ranges::all_of(path.segments, within, &app::PathSegment::to));
                }
            QCOMPARE(lengthOf(cutAt(inside.sheet, Keep::Inside).sheet), lengthOf(inside.sheet));
        }
    }

    void curvesKeepTheirLengthAndTheirEndsInside()
    {
        std::mt19937_64 random(8);
        for (int round = 0; round < 500; ++round) {
            const Sheet sheet = sheetOf({randomPath(random, true)});
            const auto inside = cutAt(sheet, Keep::Inside), outside = cutAt(sheet, Keep::Outside);
            const double whole = lengthOf(sheet);
            const double both = lengthOf(inside.sheet) + lengthOf(outside.sheet);
            QVERIFY2(std::abs(both - whole) < 0.2 + 1e-3 * whole,
                     qPrintable(QString::number(both - whole)));
            for (const auto& shape : inside.sheet.shapes)
                for (const auto& path : shape.paths) {
                    QVERIFY(within(path.start));
                    QVERIFY(path.closed || within(path.segments.back().to));
                }
        }
    }
};

} // namespace cut_cut_test

TEST_CLASS(cut_cut_test::CutTest, None)
#include "tests/app/cut/cut_test.moc"
