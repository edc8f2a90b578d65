// SPDX-License-Identifier: GPL-3.0-or-later
// An algorithm without its own overlay gets one from its trace.
#include "app/overlays/parts.h"
#include "app/teaching/teaching.h"

#include "tests/app/overlays/overlay_cases.h"
#include "tests/test_class.h"

namespace overlays_cuts_test {

using app::Emphasis;
using app::Overlay;
using app::OverlayLine;
using app::OverlayMark;
using app::Variant;
using clipping::Segment;
using clipping::What;
using clipping::Window;

namespace {

constexpr int cases = 1000;

Overlay of(const Variant& variant, const Window& w, const Segment& line)
{
    app::OverlayContext context{{variant, w, line, {}, everything}};
    context.trace = context.traceOf(line);
    return app::traceOverlay(context);
}

/// The caption of an algorithm whose steps name no edge.
QString captionWithoutEdges(const Variant& variant, const Window& w, const Segment& line)
{
    app::OverlayContext context{{variant, w, line, {}, everything}};
    context.trace = context.traceOf(line);
    for (clipping::Step& step : context.trace.steps)
        step.edge = clipping::Edge::NoEdge;
    return app::traceOverlay(context).caption;
}

std::vector<OverlayMark> cutsIn(const Overlay& overlay)
{
    std::vector<OverlayMark> marks = overlay.marks;
    std::erase_if(marks, [](const OverlayMark& m) { return m.symbol == OverlayMark::Symbol::End; });
    return marks;
}

} // namespace

class CutsTest : public QObject {
    Q_OBJECT

private slots:
    /// An end of what is visible that was cut is marked, and the edge that it lies on is
    /// highlighted.
    void newEndsAreMarkedOnHighlightedEdges()
    {
        Cases some(31);
        int cut = 0;
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Segment line{some.pointNear(w), some.pointNear(w)};
            for (const Variant& variant : formsOf({"CS", "LB", "CB", "MD"})) {
                const auto trace = traceOf(variant, line, w);
                const Overlay overlay = of(variant, w, line);
                const auto marks = cutsIn(overlay);
                for (const clipping::Step& step : trace.steps)
                    if (step.what == What::Cut && marks.size() < 8)
                        QVERIFY2(std::ranges::any_of(marks,
                                                     [&](const OverlayMark& m) {
                                                         return m.at == step.segment.a
                                                                || m.at == step.segment.b;
                                                     })
                                     || step.segment == line,
                                 said(variant, w, line));
                const auto highlighted =
                    std::ranges::count_if(overlay.lines, [](const OverlayLine& l) {
                        return l.kind == OverlayLine::Kind::Border
                               && l.emphasis == Emphasis::Highlighted;
                    });
                QVERIFY2((highlighted > 0) == !marks.empty(), said(variant, w, line));
                QVERIFY2(overlay.table.has_value() == !marks.empty(), said(variant, w, line));
                if (!marks.empty())
                    QCOMPARE(overlay.table->rows.size(), marks.size());
                cut += int(marks.size());
            }
        }
        QVERIFY(cut > cases);
    }
    /// A row may cut both ends at once, at no edge that it names.
    void aCutWithoutAnEdgeIsACut()
    {
        const Window w{{0, 0}, {4, 3}};
        for (const Variant& variant : everyForm()) {
            const QString cut = captionWithoutEdges(variant, w, {{-2, 1}, {6, 2}});
            QVERIFY2(cut.endsWith("cuts the line: the remaining part is visible."),
                     qPrintable(cut));
            const QString whole = captionWithoutEdges(variant, w, {{1, 1}, {2, 2}});
            QVERIFY2(whole.endsWith("cuts nothing: the whole line is visible."), qPrintable(whole));
        }
    }
    void captionStatesTheOutcome()
    {
        const Variant md{clipping::findAlgorithm("MD")};
        const Window w{{0, 0}, {4, 3}};
        const auto caption = [&](const Segment& line) { return of(md, w, line).caption; };
        const QString name = "Matthes-Drakopoulos ";
        QCOMPARE(caption({{1, 1}, {2, 2}}), name + "cuts nothing: the whole line is visible.");
        QCOMPARE(caption({{-2, 1}, {-1, 2}}),
                 name + "rejects the line without a cut: nothing is visible.");
        QCOMPARE(caption({{-2, 1}, {6, 1}}),
                 name
                     + "cuts the line at the left edge and the right edge: the remaining part is "
                       "visible.");
        QVERIFY(caption({{-2, 2}, {1, 5}}).endsWith("and then rejects it: nothing is visible."));
        const Variant cs{clipping::findAlgorithm("CS"), clipping::Form::Published};
        QCOMPARE(of(cs, {{0.1, 0.1}, {3, 3}}, {{1, 1}, {-1, -1}}).caption,
                 "Cohen-Sutherland does not end on this line and is stopped: nothing is visible.");
        QCOMPARE(of({clipping::findAlgorithm("CS")}, w, {{-6, -1}, {6, 2.5}}).caption,
                 "Cohen-Sutherland cuts the line at the top edge, the left edge and the right "
                 "edge: the remaining part is visible.");
    }
};

} // namespace overlays_cuts_test

TEST_CLASS(overlays_cuts_test::CutsTest, Core)
#include "tests/app/overlays/cuts_test.moc"
