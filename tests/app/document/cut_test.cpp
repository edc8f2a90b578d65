// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/cut.h"
#include "app/document/flatten.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <numbers>
#include <random>

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

app::Cut cutAt(const Sheet& sheet, Keep keep, double tolerance = 1e-3)
{
    const auto* algorithm = clipping::findAlgorithm("matthes-drakopoulos");
    return app::cut(sheet, {&algorithm->corrected, window, keep, tolerance});
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

    void aCutFillBecomesAnOutline()
    {
        const app::Colour red{255, 0, 0, 255};
        const auto cut =
            cutAt(sheetOf({{{0, 0}, {{{9, 0}}, {{9, 9}}}, true}}, {.fill = red}), Keep::Inside);
        QCOMPARE(cut.counts.unfilled, 1u);
        QCOMPARE(cut.sheet.shapes[0].style.stroke, std::optional(red));
        QVERIFY(!cut.sheet.shapes[0].style.fill);
    }

    void aLineHasNothingToFill()
    {
        const app::Style filled{.fill = app::Colour{}};
        const auto cut = cutAt(sheetOf({{{0, 0}, {{{9, 0}}}, false}}, filled), Keep::Inside);
        QCOMPARE(cut.counts.unfilled, 0u);
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
        QCOMPARE(cutAt(sheet, Keep::Inside).sources, (std::vector<std::size_t>{1, 1, 2}));
        QCOMPARE(cutAt(sheet, Keep::Outside).sources, (std::vector<std::size_t>{0, 1, 1, 1}));
    }

    void aContactIsLeftOutAPointIsKept()
    {
        const Subpath touch{{2, 3}, {{{4, 1}}}, false}; // the corner (3, 2)
        QVERIFY(cutAt(sheetOf({touch}), Keep::Inside).sheet.shapes.empty());
        QCOMPARE(cutAt(sheetOf({touch}), Keep::Outside).sheet, sheetOf({touch}));
        const Subpath point{{1, 1}, {}, false};
        QCOMPARE(cutAt(sheetOf({point}), Keep::Inside).sheet, sheetOf({point}));
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
        QVERIFY(cut.sheet.shapes[1].id.isEmpty());
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

QTEST_APPLESS_MAIN(CutTest)
#include "cut_test.moc"
