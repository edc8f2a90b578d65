// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/cut/permanent_cuts.h"

#include <QTest>

#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace cut_permanent_cuts_test {

using app::Point;
using app::Sheet;
using app::Subpath;

namespace {

constexpr clipping::Window window{{0, 0}, {10, 10}};

Subpath line(const Point& a, const Point& b) { return {a, {{b}}, false}; }

/// A line inside, one outside, and one through the window, on two layers.
Sheet drawing()
{
    const app::Style style{.stroke = app::Colour{}};
    Sheet sheet;
    sheet.layers = {{QStringLiteral("Lower")}, {QStringLiteral("Upper")}};
    sheet.shapes = {{{line({1, 1}, {2, 2})}, style, QStringLiteral("in"), 0},
                    {{line({20, 1}, {22, 2})}, style, QStringLiteral("out"), 0},
                    {{line({-5, 5}, {15, 5})}, style, QStringLiteral("through"), 1}};
    return sheet;
}

struct Made {
    Sheet sheet;
    app::CutCounts counts;
    app::Document document;
};

Made made(std::string_view key, const Sheet& sheet, const app::CutOptions& more = {})
{
    app::CutOptions options = more;
    options.clipAll = app::usualAlgorithm().corrected.clipAll;
    options.region = {{{window, app::WindowOperation::Add}}, more.region.keep};
    app::Document document = app::documentOf(sheet);
    const app::Cut cut = app::permanentCut(key).make(document, options, {});
    document.apply(cut.edit);
    return {app::sheetOf(document), cut.counts, document};
}

QString treeOf(const app::Document& document)
{
    const app::Containers& tree = document.containers();
    QString text;
    std::size_t object = 0;
    const app::Containers::Parts parts = tree.parts();
    for (const app::ContainerMark& mark : parts.marks) {
        if (mark.id != 0 && mark.closes)
            text += QStringLiteral("] ");
        if (mark.id != 0 && !mark.closes)
            text += tree[mark.id].name
                    + (tree[mark.id].svgId.isEmpty() ? QString() : u'#' + tree[mark.id].svgId)
                    + u'[';
        for (std::size_t end = object + mark.objects; object < end; ++object) {
            const QString id = document.objects()[object].particulars().id;
            text += (id.isEmpty() ? QStringLiteral("-") : id) + u' ';
        }
    }
    return text;
}

QStringList rowsOf(const Sheet& sheet)
{
    QStringList rows;
    for (const app::Shape& shape : sheet.shapes)
        for (const Subpath& path : shape.paths)
            rows << QStringLiteral("%1/%2 %3..%4")
                        .arg(sheet.layers[shape.layer].name, shape.id)
                        .arg(path.start.x)
                        .arg(path.segments.back().to.x);
    return rows;
}

} // namespace

class PermanentCutsTest : public QObject {
    Q_OBJECT

private slots:
    void croppingKeepsWhatIsSeen()
    {
        QCOMPARE(rowsOf(made("crop", drawing()).sheet),
                 (QStringList{"Lower/in 1..2", "Upper/through 0..10"}));
        app::CutOptions outside;
        outside.region.keep = app::Keep::Outside;
        QCOMPARE(rowsOf(made("crop", drawing(), outside).sheet),
                 (QStringList{"Lower/out 20..22", "Upper/through -5..0", "Upper/through 10..15"}));
    }

    void cuttingOutRemovesTheInside()
    {
        const QStringList left{"Lower/out 20..22", "Upper/through -5..0", "Upper/through 10..15"};
        QCOMPARE(rowsOf(made("cut-out", drawing()).sheet), left);
        app::CutOptions outside;
        outside.region.keep = app::Keep::Outside;
        QCOMPARE(rowsOf(made("cut-out", drawing(), outside).sheet), left);
    }

    void whatIsLeftIsSeen()
    {
        Sheet sheet = drawing();
        sheet.window = window;
        for (const char* key : {"crop", "cut-out"}) {
            const Made cut = made(key, sheet);
            const app::ClipWindows& windows = cut.document.windows();
            QCOMPARE(windows.list.size(), std::size_t(1));
            QVERIFY(!app::cuts(windows));
            QCOMPARE(windows.keep, app::Keep::Inside);
            // Where nothing is cut, the window stays.
            app::Sheet again = cut.sheet;
            again.window = window;
            QVERIFY(app::cuts(made(key, again).document.windows()));
        }
        QVERIFY(app::cuts(made("split", sheet).document.windows()));
    }

    void splittingKeepsBothPartsOnLayersOfTheirOwn()
    {
        const Made split = made("split", drawing());
        QCOMPARE(
            rowsOf(split.sheet),
            (QStringList{"Lower/in 1..2", "Lower, outside/out 20..22", "Upper/through 0..10",
                         "Upper, outside/through-2 -5..0", "Upper, outside/through-2 10..15"}));
        QCOMPARE(split.counts.whole, 2u);
        QCOMPARE(split.counts.cut, 1u);
        QCOMPARE(split.counts.gone, 0u);
    }

    void splittingWhereNothingIsOutsideChangesNothing()
    {
        Sheet sheet = drawing();
        sheet.shapes.resize(1);
        const Made split = made("split", sheet);
        QCOMPARE(split.sheet, app::sheetOf(app::documentOf(sheet)));
    }

    void splittingLeavesLockedLayersAlone()
    {
        Sheet sheet = drawing();
        sheet.layers[1].locked = true;
        const Made split = made("split", sheet, {.leaveLocked = true});
        QCOMPARE(rowsOf(split.sheet), (QStringList{"Lower/in 1..2", "Lower, outside/out 20..22",
                                                   "Upper/through -5..15"}));
        QCOMPARE(split.counts.leftLocked, 1u);
    }

    void theSecondPartHasAnIdThatIsNew()
    {
        Sheet sheet = drawing();
        sheet.shapes[0].id = QStringLiteral("through-2");
        QVERIFY(rowsOf(made("split", sheet).sheet).contains("Upper, outside/through-3 -5..0"));
    }

    // Each object, group and inner layer with its id, and in brackets what it holds.
    void splittingMirrorsLayersAndGroups()
    {
        const auto add = [](app::DocumentBuilder& builder, const char* id, const Point& a,
                            const Point& b, const app::Style& style) {
            const Subpath box{a, {{{b.x, a.y}}, {b}, {{a.x, b.y}}}, true};
            builder.add({app::Path({&box, 1}), style, {.id = id}});
        };
        const app::Style stroke{.stroke = app::Colour{}};
        const app::Style both{.stroke = app::Colour{}, .fill = app::Colour{}};
        app::DocumentBuilder builder;
        builder.open({.name = "Roads", .svgId = "roads"});
        add(builder, "a", {5, 5}, {15, 6}, stroke);
        builder.open({.kind = app::Container::Kind::Group, .svgId = "g"});
        add(builder, "b", {5, 5}, {15, 6}, both);
        add(builder, "c", {1, 1}, {2, 2}, both);
        builder.close();
        builder.open({.name = "Paths"});
        builder.open({.kind = app::Container::Kind::Group, .svgId = "h"});
        add(builder, "d", {15, 5}, {16, 6}, both);
        builder.close();
        builder.close();
        add(builder, "e", {15, 5}, {16, 6}, both);
        builder.close();
        builder.open({.name = "Houses"});
        add(builder, "f", {15, 5}, {16, 6}, both);
        add(builder, "g1", {1, 5}, {6, 6}, both);
        builder.close();
        builder.open({.name = "Inside"});
        add(builder, "i", {1, 5}, {6, 6}, both);
        builder.close();
        app::Document document = builder.take({});
        const app::Document before = document;
        app::CutOptions options{.clipAll = app::usualAlgorithm().corrected.clipAll};
        options.region = {{{window, app::WindowOperation::Add}}};
        const app::Cut split = app::permanentCut("split").make(document, options, {});
        const app::Edit back = document.apply(split.edit);
        QCOMPARE(treeOf(document), QStringLiteral("Roads#roads[a #g[#b[- - ] c ] Paths[] ] "
                                                  "Roads, outside#roads-2[a-2 #g-2[#b-2[- - ] ] "
                                                  "Paths, outside[#h[d ] ] e ] "
                                                  "Houses[g1 ] Houses, outside[f ] Inside[i ] "));
        document.apply(back);
        QVERIFY(document.objects() == before.objects());
        QVERIFY(document.containers() == before.containers());
    }

    // Where the document can have no further layers.
    void thePartsOutsideThenShareALayer()
    {
        Sheet sheet = drawing();
        sheet.layers.resize(app::Containers::mostLayers);
        const Made split = made("split", sheet);
        QCOMPARE(split.document.containers().childrenOf(0).size(), app::Containers::mostLayers);
        const QStringList rows = rowsOf(split.sheet);
        QCOMPARE(rows.size(), 5);
        QVERIFY(rows.contains("/out 20..22") && rows.contains("/through-2 -5..0"));
        QCOMPARE(split.sheet.shapes.back().layer + 1, app::Containers::mostLayers);
    }

    void furtherPiecesOfADashedLineGetNumberedIds()
    {
        Sheet sheet = drawing();
        sheet.shapes[2].style.dashes = {3, 1};
        QCOMPARE(
            rowsOf(made("cut-out", sheet).sheet),
            (QStringList{"Lower/out 20..22", "Upper/through -5..0", "Upper/through-2 10..15"}));
    }

    void whatIsSplitCanBeUndone()
    {
        const app::Document before = app::documentOf(drawing());
        app::Document document = before;
        app::CutOptions options{.clipAll = app::usualAlgorithm().corrected.clipAll};
        options.region = {{{window, app::WindowOperation::Add}}};
        const app::Edit back =
            document.apply(app::permanentCut("split").make(document, options, {}).edit);
        document.apply(back);
        QVERIFY(document.objects() == before.objects());
        QVERIFY(document.containers() == before.containers());
    }
};

} // namespace cut_permanent_cuts_test

TEST_CLASS(cut_permanent_cuts_test::PermanentCutsTest, Core)
#include "tests/app/cut/permanent_cuts_test.moc"
