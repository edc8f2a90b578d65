// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/occlude.h"
#include "app/document/recipe_outline.h"

#include <QTest>

#include <random>

#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace cut_occlude_test {

using namespace app;

namespace {

const Style line{.stroke = Colour{}}, white{.stroke = Colour{}, .fill = Colour{255, 255, 255}};

Shape box(const QString& id, double x0, double y0, double x1, double y1, Style style = white)
{
    return {{{{x0, y0}, {{{x1, y0}}, {{x1, y1}}, {{x0, y1}}}, true}}, std::move(style), id};
}

struct Done {
    Sheet sheet;
    CutCounts counts;
    Document document;
};

Done occluded(const Sheet& sheet, const CutOptions& options = {})
{
    Document document = documentOf(sheet);
    const Cut cut = occlude(document, options);
    document.apply(cut.edit);
    return {sheetOf(document), cut.counts, document};
}

Done occluded(std::vector<Shape> shapes)
{
    Sheet sheet;
    sheet.shapes = std::move(shapes);
    return occluded(sheet);
}

// "a: 0,0 4,0 4,4; …", each open run of an object.
QStringList textOf(const Sheet& sheet)
{
    QStringList all;
    for (const Shape& shape : sheet.shapes)
        for (const Subpath& path : shape.paths) {
            QString text = QStringLiteral("%1%2:").arg(shape.id, path.closed ? "*" : "");
            const auto add = [&](const Point& p) {
                text += QStringLiteral(" %1,%2").arg(p.x).arg(p.y);
            };
            add(path.start);
            for (const PathSegment& segment : path.segments)
                add(segment.to);
            all << text;
        }
    return all;
}

} // namespace

class OccludeTest : public QObject {
    Q_OBJECT

private slots:
    void anAreaCoversTheLinesBelowIt()
    {
        const Done done = occluded({box("below", 0, 0, 4, 4), box("above", 2, 2, 6, 6)});
        QCOMPARE(textOf(done.sheet),
                 (QStringList{"below: 2,4 0,4 0,0 4,0 4,2", "above*: 2,2 6,2 6,6 2,6"}));
        for (const Shape& shape : done.sheet.shapes)
            QVERIFY(!shape.style.fill && shape.style.stroke);
        QCOMPARE(done.counts.cut, 1u);
        QCOMPARE(done.counts.whole, 1u);
        QCOMPARE(done.counts.opened, 1u);
        QCOMPARE(done.counts.fillsRemoved, 2u);
    }

    void onlyOpaqueFillsCover()
    {
        Style glass = white, none = line, hole = white;
        glass.fill->alpha = 254;
        hole.fillRule = FillRule::EvenOdd;
        const Shape below = box("below", 1, 1, 3, 3, line);
        for (const Style& style : {glass, none})
            QCOMPARE(textOf(occluded({below, box("above", 0, 0, 4, 4, style)}).sheet).front(),
                     "below*: 1,1 3,1 3,3 1,3");
        QCOMPARE(textOf(occluded({below, box("above", 0, 0, 4, 4)}).sheet),
                 QStringList{"above*: 0,0 4,0 4,4 0,4"});
        Shape ring = box("above", 0, 0, 9, 9, hole);
        ring.paths.push_back(box({}, 2, 0.5, 8, 8).paths.front());
        QCOMPARE(textOf(occluded({below, ring}).sheet).front(), "below: 2,1 3,1 3,3 2,3");
    }

    void equalShapesLeaveTheUpperOne()
    {
        const Done done = occluded({box("a", 0, 0, 4, 4), box("b", 0, 0, 4, 4)});
        QCOMPARE(textOf(done.sheet), QStringList{"b*: 0,0 4,0 4,4 0,4"});
        QCOMPARE(done.counts.gone, 1u);
    }

    // An edge that two shapes share is drawn once.
    void sharedEdgesAreDrawnOnce()
    {
        const Done done = occluded({box("a", 0, 0, 4, 4), box("b", 4, 0, 8, 4)});
        QCOMPARE(textOf(done.sheet), (QStringList{"a: 4,4 0,4 0,0 4,0", "b*: 4,0 8,0 8,4 4,4"}));
    }

    void selfCrossingFillsCoverByTheirRule()
    {
        Shape bow{{{{0, 0}, {{{8, 8}}, {{8, 0}}, {{0, 8}}}, true}}, white, "bow"};
        const Shape across{{{{-1, 4}, {{{9, 4}}}, false}}, line, "across"};
        // A line through the middle of the bow tie only touches it.
        const Shape low{{{{4, 1}, {{{4, 7}}}, false}}, line, "low"};
        QCOMPARE(textOf(occluded({across, low, bow}).sheet).mid(0, 3),
                 (QStringList{"across: -1,4 0,4", "across: 8,4 9,4", "low: 4,1 4,7"}));
        // Twice around, even-odd: nothing is filled.
        Shape twice = box("twice", 0, 0, 8, 8);
        twice.style.fillRule = FillRule::EvenOdd;
        twice.paths.push_back(twice.paths.front());
        QCOMPARE(textOf(occluded({across, twice}).sheet).front(), "across: -1,4 9,4");
        twice.style.fillRule = FillRule::NonZero;
        QCOMPARE(textOf(occluded({across, twice}).sheet).mid(0, 2),
                 (QStringList{"across: -1,4 0,4", "across: 8,4 9,4"}));
    }

    void aMaskWithoutAStrokeOnlyCovers()
    {
        const Style mask{.fill = Colour{255, 255, 255}};
        const Done done = occluded({box("a", 0, 0, 4, 4, line), box("mask", 2, -1, 5, 5, mask)});
        QCOMPARE(textOf(done.sheet), QStringList{"a: 2,4 0,4 0,0 2,0"});
        QCOMPARE(done.counts.gone, 1u);
        QCOMPARE(done.counts.fillsRemoved, 1u);
    }

    void hiddenObjectsDoNotCoverAndLockedOnesDo()
    {
        Sheet sheet;
        sheet.layers = {{"open"}, {"locked", true, true}, {"hidden", false}};
        sheet.shapes = {box("a", 0, 0, 4, 4), box("b", 0, 0, 2, 2), box("c", -9, -9, 9, 9)};
        sheet.shapes[1].layer = 1;
        sheet.shapes[2].layer = 2;
        sheet.shapes[2].hidden = true;
        const Done done = occluded(sheet, {.leaveLocked = true});
        QCOMPARE(textOf(done.sheet), (QStringList{"a: 2,0 4,0 4,4 0,4 0,2", "b*: 0,0 2,0 2,2 0,2",
                                                  "c*: -9,-9 9,-9 9,9 -9,9"}));
        QVERIFY(done.sheet.shapes[1].style.fill && done.sheet.shapes[2].style.fill);
        QCOMPARE(done.counts.leftLocked, 1u);
        QCOMPARE(done.counts.leftHidden, 1u);
    }

    void curvesStayCurves()
    {
        const auto circle = outlineOf(EllipseRecipe{{0, 0}, Point(10)});
        const Shape below{{*circle}, line, "circle"};
        const Done done = occluded({below, box("above", 0, -20, 20, 20)});
        QCOMPARE(done.sheet.shapes[0].paths.size(), 1u);
        const auto& segments = done.sheet.shapes[0].paths[0].segments;
        QVERIFY(segments.size() >= 2);
        QVERIFY(std::ranges::all_of(segments, &PathSegment::curved));
    }

    void groupsAndLayersStay()
    {
        DocumentBuilder builder;
        builder.open({.name = "L"});
        builder.open({.kind = Container::Kind::Group, .svgId = "g"});
        for (const Shape& shape : {box("a", 0, 0, 4, 4), box("b", 2, 2, 6, 6)})
            builder.add({Path(shape.paths), shape.style, {.id = shape.id}});
        builder.close();
        builder.close();
        Document document = builder.take({});
        const Document before = document;
        const Edit back = document.apply(occlude(document, {}).edit);
        QVERIFY(document.containers() == before.containers());
        document.apply(back);
        QVERIFY(document.objects() == before.objects());
    }

    // Nothing covers anything any more.
    void twiceIsOnce()
    {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> number(0, 20);
        std::vector<Shape> shapes;
        for (int i = 0; i < 100; ++i) {
            const Point a(number(random), number(random));
            shapes.push_back(box(QString::number(i), a.x, a.y, a.x + number(random) / 4,
                                 a.y + number(random) / 4));
        }
        const Done once = occluded(shapes);
        const Done twice = occluded(once.sheet, {});
        QCOMPARE(twice.sheet, once.sheet);
        QVERIFY(once.counts.cut > 20);
    }

    void nothingToDoIsNoChange()
    {
        const Done done = occluded({box("a", 0, 0, 4, 4, line), box("b", 2, 2, 6, 6, line)});
        QCOMPARE(done.counts.whole, 2u);
        Sheet sheet;
        sheet.shapes = {box("a", 0, 0, 4, 4, line)};
        QVERIFY(occlude(documentOf(sheet), {}).edit.splices.empty());
    }

    void progressGrowsToTheEnd()
    {
        Sheet sheet;
        for (int i = 0; i < 60; ++i)
            sheet.shapes.push_back(box(QString::number(i), i, i, 100 + i, 100 + i));
        std::vector<double> shares;
        occlude(documentOf(sheet), {},
                {{}, [&](const Progress& progress) { shares.push_back(progress.share); }});
        QCOMPARE(shares.size(), 60u);
        QVERIFY(std::ranges::is_sorted(shares));
        QCOMPARE(shares.back(), 1.0);
        QVERIFY(shares[29] > 0.7); // lower objects have more above them
    }

    void aStopEndsIt()
    {
        Sheet sheet;
        for (int i = 0; i < 60; ++i)
            sheet.shapes.push_back(box(QString::number(i), i, i, 100 + i, 100 + i));
        std::stop_source stop;
        int told = 0;
        occlude(documentOf(sheet), {}, {stop.get_token(), [&](const Progress&) {
                                            ++told;
                                            stop.request_stop();
                                        }});
        QCOMPARE(told, 1);
    }
};

} // namespace cut_occlude_test

TEST_CLASS(cut_occlude_test::OccludeTest, Core)
#include "tests/app/cut/occlude_test.moc"
