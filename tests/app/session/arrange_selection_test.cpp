// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/scene/bounds.h"
#include "app/session/arrange_selection.h"
#include "app/session/arrangements.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/app/document/one_window.h"
#include "tests/test_class.h"

namespace session_arrange_selection_test {

using namespace app;

namespace {

Object box(const Point& from, const Point& to)
{
    const Subpath path{from, {{{to.x, from.y}}, {to}, {{from.x, to.y}}}, true};
    return {.path = Path(std::span(&path, 1)), .style = {.stroke = Colour{}, .width = 1}};
}

} // namespace

class ArrangeSelectionTest : public QObject {
    Q_OBJECT

    /// Four boxes; the second and the third are in a group.
    struct Drawing : Session {
        Drawing()
        {
            DocumentBuilder builder;
            builder.open({.name = "Drawing"});
            builder.add(box({0, 0}, {10, 10}));
            builder.open({.kind = Container::Kind::Group, .name = "group"});
            builder.add(box({20, 3}, {24, 5}));
            builder.add(box({26, 5}, {30, 7}));
            builder.close();
            builder.add(box({60, 20}, {80, 50}));
            builder.close();
            load({builder.take({}), {}});
            select({0, 1, 2, 3});
        }
        clipping::Window at(std::size_t object)
        {
            return *boundsOf(scene.lines(), ObjectRanges{object});
        }
    };
    static bool same(const clipping::Window& a, const clipping::Window& b)
    {
        return a.min == b.min && a.max == b.max;
    }

private slots:
    void selectedGroupIsOneUnit()
    {
        Drawing drawing;
        const auto units = arrangedUnits(drawing);
        QCOMPARE(units.size(), std::size_t(3));
        QVERIFY(same(units[1].box, {{20, 3}, {30, 7}}));
        drawing.select({0, 2});
        QCOMPARE(arrangedUnits(drawing).size(), std::size_t(2));
        QVERIFY(same(arrangedUnits(drawing)[1].box, {{26, 5}, {30, 7}}));
    }
    void unitsAreAlignedInOneStep()
    {
        Drawing drawing;
        align(drawing, 0, AlignTo::Most);
        QCOMPARE(drawing.history.count(), 1);
        QVERIFY(same(drawing.at(0), {{70, 0}, {80, 10}}));
        QVERIFY(same(drawing.at(1), {{70, 3}, {74, 5}}) && same(drawing.at(2), {{76, 5}, {80, 7}}));
        QVERIFY(same(drawing.at(3), {{60, 20}, {80, 50}}));
        align(drawing, 0, AlignTo::Most); // nothing changes
        QCOMPARE(drawing.history.count(), 1);
        QCOMPARE(drawing.selection().size(), std::size_t(4));
    }
    void everyTargetIsAlignedTo()
    {
        for (const AlignmentTarget& target : alignmentTargets()) {
            Drawing drawing;
            drawing.history.push(windowStep(drawing.document, {{5, 6}, {7, 8}}));
            drawing.arrange.alignTo = target.key;
            drawing.select({0, 3});
            align(drawing, 1, AlignTo::Least);
            const double top = target.key == "to-last"     ? 20
                               : target.key == "to-window" ? 6
                               : target.key == "to-page"   ? drawing.now().page().rectangle().min.y
                                                           : 0;
            QCOMPARE(drawing.at(0).min.y, top);
            QCOMPARE(drawing.at(3).min.y, top);
        }
    }
    void everyArrangementIsOneStepThatChangesSomething()
    {
        for (const Arrangement& how : arrangements()) {
            Drawing drawing;
            drawing.select({0, 1, 3}); // the middle one lies off the middle
            const Document before = drawing.now();
            how.run(drawing);
            QVERIFY2(drawing.history.count() == 1, how.key.data());
            QVERIFY2(drawing.now().objects() != before.objects(), how.key.data());
            drawing.history.undo();
            QVERIFY2(drawing.now().objects() == before.objects(), how.key.data());
        }
    }
    void objectsAreSpreadOverAnExtent()
    {
        Drawing drawing;
        drawing.history.push(windowStep(drawing.document, {{-10, 0}, {110, 50}}));
        alignTo(drawing,
                *std::ranges::find(alignmentTargets(), "to-window", &AlignmentTarget::key));
        QCOMPARE(leastSpread(drawing), std::size_t(2));
        drawing.select({0, 3});
        spreadEvenly(drawing, 0);
        QVERIFY(same(drawing.at(0), {{-10, 0}, {0, 10}}));
        QVERIFY(same(drawing.at(3), {{90, 20}, {110, 50}}));
        drawing.select({0, 1, 2, 3}); // the group is 10 wide, so the gaps are 40
        spreadEvenly(drawing, 0);
        QVERIFY(same(drawing.at(1), {{40, 3}, {44, 5}}) && same(drawing.at(2), {{46, 5}, {50, 7}}));
        QVERIFY(same(drawing.at(3), {{90, 20}, {110, 50}}));
    }
    void sameSizeScalesStrokesByChoice()
    {
        Drawing drawing;
        drawing.select({0, 3}); // 10 wide and high; the model is 20 wide, 30 high
        makeSameSize(drawing, true, true);
        QCOMPARE(drawing.now().objects()[0].style().width, 1.0);
        drawing.history.undo();
        scaleStrokes(drawing, StrokeScaling::Scale);
        makeSameSize(drawing, true, true);
        QVERIFY(std::abs(drawing.now().objects()[0].style().width - std::sqrt(6)) < 1e-9);
        QCOMPARE(drawing.now().objects()[3].style().width, 1.0);
    }
    void turnsGoAboutThePivotThatStays()
    {
        Drawing drawing;
        drawing.select({0});
        drawing.pivot.put({20, 0});
        std::ranges::find(arrangements(), "flip-horizontal", &Arrangement::key)->run(drawing);
        QVERIFY(same(drawing.at(0), {{30, 0}, {40, 10}}));
        QVERIFY(drawing.pivot.isMoved());
        drawing.select({3});
        QCOMPARE(drawing.pivot.at(), Point(70, 35)); // of another selection: its middle
    }
    void turnsKeepTheMiddle()
    {
        for (const Arrangement& how : arrangements()) {
            if (how.kind != Arrangement::Kind::Turn)
                continue;
            Drawing drawing;
            const clipping::Window before = *drawing.selectionBounds();
            how.run(drawing);
            const clipping::Window after = *drawing.selectionBounds();
            QCOMPARE(after.min + after.max, before.min + before.max);
        }
    }
    void missingClipWindowIsSaid()
    {
        Drawing drawing;
        drawing.arrange.alignTo = "to-window";
        QSignalSpy refused(&drawing, &Session::refused);
        align(drawing, 0, AlignTo::Least);
        QCOMPARE(refused.count(), 1);
        QCOMPARE(drawing.history.count(), 0);
    }
    void spreadAndSameSizeKeepGroupsTogether()
    {
        Drawing drawing;
        spreadEvenly(drawing, 0); // 10 + 10 + 20 on 80: gaps of 20
        QVERIFY(same(drawing.at(1), {{30, 3}, {34, 5}}) && same(drawing.at(2), {{36, 5}, {40, 7}}));
        makeSameSize(drawing, true, false);
        QVERIFY(same(drawing.at(0), {{0, 0}, {20, 10}}));
        QVERIFY(same(drawing.at(2), {{42, 5}, {50, 7}}));
        QCOMPARE(drawing.history.count(), 2);
    }
    void selectionIsRepeated()
    {
        Drawing drawing;
        drawing.select({0});
        QVERIFY(repeatSelection(drawing, grid(4, 5, {13, 13}), "Array"));
        QCOMPARE(drawing.now().objects().size(), std::size_t(23));
        QCOMPARE(drawing.selection().size(), std::size_t(20));
        QVERIFY(!repeatSelection(drawing, std::vector(60'000, translation({1, 1})), "Array"));
        drawing.history.undo();
        QCOMPARE(drawing.now().objects().size(), std::size_t(4));
    }
};

} // namespace session_arrange_selection_test

TEST_CLASS(session_arrange_selection_test::ArrangeSelectionTest, Core)
#include "tests/app/session/arrange_selection_test.moc"
#include "tests/app/document/one_window.h"
