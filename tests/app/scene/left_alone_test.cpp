// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/left_alone.h"

#include <QTest>

#include "tests/app/document/sheet_edits.h"
#include "tests/app/scene/block_scene.h"
#include "tests/app/session/concave_window.h"
#include "tests/test_class.h"

namespace scene_left_alone_test {

using namespace app;
using clipping::Window;

namespace {

constexpr Window box{{10, 10}, {30, 30}};
const Page page{};

ClipWindow star(WindowOperation operation = WindowOperation::Add)
{
    ClipWindow window = concaveWindow("Star", {{50, 50}, {90, 90}});
    window.operation = operation;
    return window;
}

ClipWindow rectangle(const Window& place = box) { return {.shape = RectangleShape{place}}; }

Variant variant(const char* key, clipping::Form form = clipping::Form::Corrected)
{
    return {clipping::findAlgorithm(key), form};
}

std::vector<std::size_t> alone(const ClipWindows& windows, const Variant& by)
{
    return leftAlone(shownRegionOf(windows, page), by);
}

app::Sheet grid()
{
    app::Sheet sheet;
    for (double at = 1; at < 100; at += 3)
        for (const auto& [from, to] : {std::pair(Point(0, at), Point(100, at + 0.5)),
                                       std::pair(Point(at, 0), Point(at + 0.5, 100))}) {
            app::Shape line;
            line.paths = {{from, {{{to}}}}};
            line.style.stroke = app::Colour{};
            sheet.shapes.push_back(std::move(line));
        }
    return sheet;
}

} // namespace

class LeftAloneTest : public QObject {
    Q_OBJECT

private slots:
    void aVariantLeavesAloneWhereItCannotClip()
    {
        using Steps = std::vector<std::size_t>;
        ClipWindow hidden = star();
        hidden.visible = false;
        const ClipWindows windows{{hidden, rectangle(), star(), rectangle()}};
        QCOMPARE(alone(windows, variant("cs")), Steps{1});
        QCOMPARE(alone(windows, variant("cb")), Steps{1});
        QCOMPARE(alone(windows, variant("cs", clipping::Form::Published)), Steps{1});
        QCOMPARE(alone(windows, variant("ex")), Steps{});
        QCOMPARE(alone({{rectangle()}}, variant("cs")), Steps{});
        QCOMPARE(alone({{star()}}, variant("cs")), Steps{0});
    }
    void whatIsReplacedIsNoStep()
    {
        using Steps = std::vector<std::size_t>;
        const ClipWindows windows{{star(), rectangle(), star(WindowOperation::Replace), star()}};
        QCOMPARE(alone(windows, variant("cs")), (Steps{0, 1}));
        const ClipWindows left = without(windows, Steps{1});
        QVERIFY(left.list[2] == windows.list[2] && left.list[3].shape != windows.list[3].shape);
    }
    /// Without such a window another result would be shown where it can clip.
    void notWhereTheOthersDependOnIt()
    {
        QVERIFY(alone({{rectangle(), star(WindowOperation::CutOut)}}, variant("cs")).empty());
        QVERIFY(alone({{rectangle(), star(WindowOperation::Intersect)}}, variant("cs")).empty());
        QVERIFY(alone({{rectangle(), star()}, Keep::Outside}, variant("cs")).empty());
    }
    void theOthersAreClippedAsIfTheyWereAlone()
    {
        Session session;
        load(session.document, grid());
        const auto kept = [&](const ClipWindows& windows, const Variant& by) {
            return visibleIn(session.scene.lines(), shownRegionOf(windows, page), by);
        };
        const Variant cs = variant("cs"), exact = variant("ex");
        const ClipWindows both{{rectangle(), star()}};
        const ClipWindows left = without(both, std::vector<std::size_t>{1});
        const ClipRegion region = shownRegionOf(left, page);
        QCOMPARE(region.steps.size(), std::size_t(2)); // each window keeps its number
        QCOMPARE(usedAt(region, cs), cs);
        const std::size_t inBox = kept({{rectangle()}}, exact);
        QVERIFY(inBox > 0);
        QCOMPARE(kept(left, cs), inBox);
        QVERIFY(kept(both, cs) > inBox); // `exact` clips in its place
        QCOMPARE(kept(without({{star()}}, std::vector<std::size_t>{0}), cs), std::size_t(0));
    }
};

} // namespace scene_left_alone_test

TEST_CLASS(scene_left_alone_test::LeftAloneTest, Core)
#include "tests/app/scene/left_alone_test.moc"
