// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of an algorithm without an overlay of its own is what its trace tells.
#include "app/overlays/family.h"
#include "app/teaching/teaching.h"

#include "tests/app/overlays/overlay_cases.h"

using app::Clipper;
using app::Emphasis;
using app::Overlay;
using app::OverlayLine;
using app::OverlayMark;
using clipping::Segment;
using clipping::What;
using clipping::Window;

namespace {

constexpr int cases = 1000;

Overlay of(const Clipper& clipper, const Window& w, const Segment& line)
{
    app::Seeing seeing{{clipper, w, line, {}, everything}};
    seeing.trace = seeing.traceOf(line);
    return app::traceOverlay(seeing);
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
    /// An end of what is visible that was cut is marked, and the edge that it lies on is lit.
    void newEndsAreMarkedOnLitEdges()
    {
        Cases some(31);
        int cut = 0;
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Segment line{some.pointNear(w), some.pointNear(w)};
            for (const Clipper& clipper : formsOf({"CS", "LB", "CB", "MD"})) {
                const auto trace = traceOf(clipper, line, w);
                const Overlay overlay = of(clipper, w, line);
                const auto marks = cutsIn(overlay);
                for (const clipping::Step& step : trace.steps)
                    if (step.what == What::Cut && marks.size() < 8)
                        QVERIFY2(std::ranges::any_of(marks,
                                                     [&](const OverlayMark& m) {
                                                         return m.at == step.segment.a
                                                                || m.at == step.segment.b;
                                                     })
                                     || step.segment == line,
                                 said(clipper, w, line));
                const auto lit = std::ranges::count_if(overlay.lines, [](const OverlayLine& l) {
                    return l.kind == OverlayLine::Kind::Border && l.emphasis == Emphasis::Lit;
                });
                QVERIFY2((lit > 0) == !marks.empty(), said(clipper, w, line));
                QVERIFY2(overlay.table.has_value() == !marks.empty(), said(clipper, w, line));
                if (!marks.empty())
                    QCOMPARE(overlay.table->rows.size(), marks.size());
                cut += int(marks.size());
            }
        }
        QVERIFY(cut > cases);
    }
    void theCaptionSaysWhatBecomesOfTheLine()
    {
        const Clipper md{clipping::findAlgorithm("MD")};
        const Window w{{0, 0}, {4, 3}};
        const auto caption = [&](const Segment& line) { return of(md, w, line).caption; };
        const QString name = "Matthes-Drakopoulos ";
        QCOMPARE(caption({{1, 1}, {2, 2}}), name + "cuts nothing: the whole line is visible.");
        QCOMPARE(caption({{-2, 1}, {-1, 2}}),
                 name + "rejects the line without a cut: nothing is visible.");
        QCOMPARE(caption({{-2, 1}, {6, 1}}),
                 name
                     + "cuts the line at the left edge and the right edge: what is left is "
                       "visible.");
        QVERIFY(caption({{-2, 2}, {1, 5}}).endsWith("and then rejects it: nothing is visible."));
        const Clipper cs{clipping::findAlgorithm("CS"), clipping::Form::Published};
        QVERIFY(of(cs, {{0.1, 0.1}, {3, 3}}, {{1, 1}, {-1, -1}}).caption.contains("round"));
    }
};

QTEST_GUILESS_MAIN(CutsTest)
#include "cuts_test.moc"
