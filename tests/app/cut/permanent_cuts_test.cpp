// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/usual_algorithm.h"
#include "app/cut/permanent_cuts.h"

#include <QTest>

#include "tests/app/document/sheet.h"

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
    const app::Cut cut = app::permanentCut(key).make(document, options);
    document.apply(cut.edit);
    return {app::sheetOf(document), cut.counts, document};
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

    void splittingKeepsBothPartsOnLayersOfTheirOwn()
    {
        const Made split = made("split", drawing());
        QCOMPARE(rowsOf(split.sheet),
                 (QStringList{"Lower/in 1..2", "Upper/through 0..10", "Outside/out 20..22",
                              "Outside/through-2 -5..0", "Outside/through-2 10..15"}));
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
        QCOMPARE(rowsOf(split.sheet),
                 (QStringList{"Lower/in 1..2", "Upper/through -5..15", "Outside/out 20..22"}));
        QCOMPARE(split.counts.leftLocked, 1u);
    }

    void theSecondPartHasAnIdThatIsNew()
    {
        Sheet sheet = drawing();
        sheet.shapes[0].id = QStringLiteral("through-2");
        QVERIFY(rowsOf(made("split", sheet).sheet).contains("Outside/through-3 -5..0"));
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
            document.apply(app::permanentCut("split").make(document, options).edit);
        document.apply(back);
        QVERIFY(document.objects() == before.objects());
        QVERIFY(document.containers() == before.containers());
    }
};

QTEST_GUILESS_MAIN(PermanentCutsTest)
#include "permanent_cuts_test.moc"
