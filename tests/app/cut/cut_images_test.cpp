// SPDX-License-Identifier: GPL-3.0-or-later
// Images are cut at the rectangle around the windows.
#include "app/cut/permanent_cuts.h"
#include "app/document/document_builder.h"

#include <QTest>

#include "tests/app/document/test_image.h"
#include "tests/test_class.h"

namespace cut_cut_images_test {

using namespace app;

namespace {

ClipWindow rectangle(const clipping::Window& box, WindowOperation operation = WindowOperation::Add)
{
    return {.shape = RectangleShape{box}, .operation = operation};
}

ClipWindow triangle()
{
    const Subpath path{{0, 0}, {{{20, 0}}, {{0, 20}}}, true};
    return {.shape = PathShape{Path({&path, 1})}};
}

/// An image of 40 by 30 units at the origin, and a line.
Document drawing(ClipWindows windows, bool locked = false)
{
    DocumentBuilder builder;
    builder.open({.name = "a", .locked = locked, .underlay = testUnderlay({}, 10)});
    builder.addLine({{0, 0}, {100, 0}}, builder.style({.stroke = Colour{}}));
    builder.close();
    return builder.take({}, {}, std::move(windows));
}

Cut cutOf(const Document& document)
{
    CutOptions options{.clipAll = clipping::exactAlgorithm().corrected.clipAll};
    cutAt(options, document.windows(), document.page());
    return cut(document, options);
}

std::optional<clipping::Window> boxOfImage(const Document& document)
{
    const auto seen = seenUnderlays(document);
    if (seen.empty())
        return std::nullopt;
    const auto corners = outlineOf(*seen.front().underlay);
    return clipping::Window{corners.front(), corners[2]};
}

} // namespace

class CutImagesTest : public QObject {
    Q_OBJECT

private slots:
    void isCutAtTheBox_data()
    {
        QTest::addColumn<ClipWindows>("windows");
        QTest::addColumn<QList<double>>("left"); // nothing: removed
        QTest::addColumn<int>("uncut");
        QTest::addColumn<int>("whole");
        const clipping::Window small{{5, 6}, {15, 16}}, other{{20, 0}, {25, 10}};
        const auto row = [](const char* name, std::vector<ClipWindow> list, Keep keep,
                            const QList<double>& left, int uncut, int whole = 0) {
            QTest::newRow(name) << ClipWindows{std::move(list), keep} << left << uncut << whole;
        };
        row("no window", {}, Keep::Inside, {0, 0, 40, 30}, 0);
        row("rectangle", {rectangle(small)}, Keep::Inside, {5, 6, 15, 16}, 0);
        row("all of it", {rectangle({{-1, -1}, {50, 50}})}, Keep::Inside, {0, 0, 40, 30}, 0);
        row("none of it", {rectangle({{50, 50}, {60, 60}})}, Keep::Inside, {}, 0);
        row("outside", {rectangle(small)}, Keep::Outside, {0, 0, 40, 30}, 0, 1);
        row("outside of all of it", {rectangle({{-1, -1}, {50, 50}})}, Keep::Outside, {}, 0);
        row("outside, beside it", {rectangle({{50, 50}, {60, 60}})}, Keep::Outside, {0, 0, 40, 30},
            0);
        row("two", {rectangle(small), rectangle(other)}, Keep::Inside, {5, 0, 25, 16}, 1);
        row("cut out", {rectangle(small, WindowOperation::CutOut)}, Keep::Inside, {0, 0, 40, 30}, 0,
            1);
        row("intersection",
            {rectangle(small), rectangle({{10, 0}, {99, 99}}, WindowOperation::Intersect)},
            Keep::Inside, {10, 6, 15, 16}, 0);
        row("triangle", {triangle()}, Keep::Inside, {0, 0, 20, 20}, 1);
    }
    void isCutAtTheBox()
    {
        QFETCH(ClipWindows, windows);
        QFETCH(QList<double>, left);
        QFETCH(int, uncut);
        Document document = drawing(windows);
        const Document before = document;
        const Cut made = cutOf(document);
        QFETCH(int, whole);
        QCOMPARE(made.counts.imagesUncut, std::size_t(uncut));
        QCOMPARE(made.counts.imagesWhole, std::size_t(whole));
        const Edit back = document.apply(made.edit);
        const auto box = boxOfImage(document);
        QCOMPARE(box.has_value(), !left.isEmpty());
        if (box)
            QCOMPARE((QList<double>{box->min.x, box->min.y, box->max.x, box->max.y}), left);
        document.apply(back);
        QVERIFY(document == before);
    }

    void lockedImagesStayWithTheirLayer()
    {
        const Document document = drawing({{rectangle({{5, 6}, {15, 16}})}}, true);
        CutOptions options{.clipAll = clipping::exactAlgorithm().corrected.clipAll,
                           .leaveLocked = true};
        cutAt(options, document.windows(), document.page());
        QVERIFY(!cut(document, options).edit.containers);
    }

    // What is inside stays on its layer, with the whole image; there is no second one.
    void aSplitLeavesThemWhole()
    {
        Document document = drawing({{rectangle({{5, -6}, {15, 16}})}});
        CutOptions options{.clipAll = clipping::exactAlgorithm().corrected.clipAll};
        cutAt(options, document.windows(), document.page());
        document.apply(permanentCut("split").make(document, options, {}).edit);
        QCOMPARE(document.containers().size(), std::size_t(2));
        QCOMPARE(seenUnderlays(document).size(), std::size_t(1));
        QCOMPARE(boxOfImage(document)->max, Point(40, 30));
    }
};

} // namespace cut_cut_images_test

TEST_CLASS(cut_cut_images_test::CutImagesTest, Core)
#include "tests/app/cut/cut_images_test.moc"
