// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/first_traced_line.h"
#include "app/session/window_in_hand.h"
#include "app/session/window_kinds.h"
#include "app/teaching/narration.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <numbers>

#include "tests/benchmarks/short_lines.h"
#include "tests/test_class.h"

namespace session_traced_window_test {

using namespace app;

namespace {

const WindowShape rotated30 = RectangleShape{{{200, 200}, {900, 600}}, -std::numbers::pi / 6};

WindowShape starShape()
{
    const auto kinds = windowKinds();
    return std::ranges::find(kinds, "star", &WindowKind::key)->make({{200, 200}, {900, 600}});
}

void show(Session& session, std::initializer_list<ClipWindow> windows)
{
    session.load({shortLines(3000), {}});
    Edit edit;
    edit.windows = ClipWindows{windows};
    session.document.apply(edit);
}

} // namespace

class TracedWindowTest : public QObject {
    Q_OBJECT

private slots:
    void aRotatedRectangleIsTracedInItsOwnDirections()
    {
        Session session;
        show(session, {{.shape = rotated30}});
        const auto& step = session.region().steps[0];
        std::size_t cut = 0;
        for (std::size_t i = 0; i < session.scene.lines().size(); ++i) {
            const TracedLine traced = tracedLineOf(session, i);
            QVERIFY(traced.window == (clipping::Window{{200, 200}, {900, 600}})
                    && !traced.windowIsPage);
            QVERIFY2(traced.origin.endsWith("in the directions of a window rotated by 30.0°")
                         || traced.origin.endsWith("in the directions of a window rotated by 30°"),
                     qPrintable(traced.origin));
            const auto visible = narrationOf(traced).visible;
            const auto expected =
                clipping::clipTurned(session.uses(), session.scene.lines()[i], *step.turned);
            QCOMPARE(visible.has_value(), expected.has_value());
            if (!visible)
                continue;
            cut += *expected != session.scene.lines()[i];
            const clipping::Segment there = tracedWindow(session).into(*expected);
            QVERIFY(glm::distance(there.a, visible->a) < 1e-9);
            QVERIFY(glm::distance(there.b, visible->b) < 1e-9);
        }
        QVERIFY(cut > 3);
    }
    void anotherShapeIsReplacedAndThatIsSaid()
    {
        Session session;
        show(session, {{.name = "Star", .shape = starShape()}});
        QVERIFY(tracedLineOf(session, 0).windowIsPage);
        QVERIFY(tracedLineOf(session, 0).origin.endsWith(", at the page, as Star is not convex"));
        const ClipWindow box{.shape = RectangleShape{{{1, 1}, {9, 9}}}};
        show(session, {{.name = "Star", .shape = starShape()}, box});
        QVERIFY(tracedLineOf(session, 0).window == (clipping::Window{{1, 1}, {9, 9}}));
        QVERIFY(
            tracedLineOf(session, 0).origin.endsWith(", at another window, as Star is not convex"));
        session.chooseWindow(1);
        QCOMPARE(tracedLineOf(session, 0).origin,
                 "Line 1 of 3,000, at the selected window alone, of 2 clip windows");
    }
    void aConvexPolygonIsTracedWhereItLies()
    {
        const auto kinds = windowKinds();
        const auto hexagon = std::ranges::find(kinds, "polygon", &WindowKind::key);
        QVERIFY(hexagon != kinds.end());
        Session session;
        show(session, {{.name = "Comb", .shape = hexagon->make({{200, 200}, {900, 600}})}});
        const auto& step = session.region().steps[0];
        QVERIFY(!step.polygon.corners.empty());
        std::size_t cut = 0;
        for (std::size_t i = 0; i < session.scene.lines().size(); ++i) {
            const TracedLine traced = tracedLineOf(session, i);
            QVERIFY(traced.corners == step.polygon.corners && traced.window == step.box);
            QVERIFY(traced.line == session.scene.lines()[i] && !traced.windowIsPage);
            const auto expected =
                clipping::exactAlgorithm().polygon->clip(traced.line, step.polygon);
            QCOMPARE(narrationOf(traced).visible, expected);
            cut += expected && *expected != traced.line;
        }
        QVERIFY(cut > 3);
        QCOMPARE(tracedLineOf(session, 0).origin, "Line 1 of 3,000");
        const Narration first = narrationOf(firstTracedLine(session));
        QVERIFY(first.visible && *first.visible != firstTracedLine(session).line);
        session.changeDisplay([](app::Display& display) {
            display.variant.algorithm = clipping::findAlgorithm("lb");
        });
        QVERIFY(narrationOf(tracedLineOf(session, 0))
                    .refusal.startsWith("Liang-Barsky clips at rectangles only."));
    }
    void numbersHaveTheUnitOfTheDrawing()
    {
        Session session;
        session.load({shortLines(3), {}});
        QCOMPARE(tracedLineOf(session, 0).unit, "px");
        const auto unitAt = [&](const Length& width, const Length& height) {
            Edit edit;
            edit.page = Page{{0, 0}, {1280, 800}, width, height};
            session.document.apply(edit);
            return firstTracedLine(session).unit;
        };
        QCOMPARE(unitAt({1280, Unit::Mm}, {800, Unit::Mm}), "mm");
        QCOMPARE(unitAt({128, Unit::Cm}, {80, Unit::Cm}), "mm");
        QCOMPARE(unitAt({1280, Unit::Inch}, {800, Unit::Inch}), "in");
        QCOMPARE(unitAt({300, Unit::Mm}, {187.5, Unit::Mm}), "");
    }
    void headingsNameTheWindowInHand()
    {
        Session session;
        show(session, {});
        QCOMPARE(headingInHand(session), "");
        const ClipWindow hidden{.name = "Hidden", .shape = starShape(), .visible = false};
        show(session, {hidden, {.shape = rotated30}, {.name = "Star", .shape = starShape()}});
        QCOMPARE(headingInHand(session), "for a window: rotated rectangle");
        QCOMPARE(needsInHand(session), WindowNeeds::RotatedRectangle);
        session.chooseWindow(2);
        QCOMPARE(headingInHand(session), "for Star: concave, 10 edges");
        QCOMPARE(stepInHand(session), &session.region().steps[1]);
        const std::vector<NamedNeeds> needs{{"Rectangle", WindowNeeds::RotatedRectangle},
                                            {"Star", WindowNeeds::AnyArea}};
        QVERIFY(needsByName(session) == needs); // of the visible ones
        session.changeDisplay([](app::Display& display) {
            display.variant.algorithm = clipping::findAlgorithm("lb");
        });
        QCOMPARE(usedVariant(session), Variant{&clipping::exactAlgorithm()});
    }
};

} // namespace session_traced_window_test

TEST_CLASS(session_traced_window_test::TracedWindowTest, Gui)
#include "tests/app/session/traced_window_test.moc"
