// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/overlays/overlay_cases.h"
#include "tests/test_class.h"

namespace overlays_lines_test {

using app::Emphasis;
using app::Overlay;
using app::OverlayArea;
using app::OverlayMark;
using app::Point;
using app::Variant;
using app::YAxis;
using clipping::Edge;
using clipping::Segment;
using clipping::Window;

namespace {

constexpr int cases = 3000;

QString letters(Edge enter, Edge leave)
{
    const auto letter = [](Edge edge) {
        return QString(std::array{"", "L", "R", "B", "T"}[std::size_t(edge)]);
    };
    const QString both = letter(enter) + letter(leave);
    return both.isEmpty() ? QStringLiteral("in") : both;
}

bool isCorner(const Point& p, const Window& w)
{
    return (p.x == w.min.x || p.x == w.max.x) && (p.y == w.min.y || p.y == w.max.y);
}

Overlay of(const Variant& variant, const Window& w, const Segment& line,
           std::optional<Point> pointer = {}, YAxis y = YAxis::Up)
{
    return app::overlayOf({variant, w, line, pointer, everything, y});
}

} // namespace

class LinesTest : public QObject {
    Q_OBJECT

private slots:
    // By another way: which edges cut is what clipAll writes beside each piece.
    void theSectorUnderThePointerIsTheLibrarysBranch()
    {
        Cases some(1);
        for (int i = 0; i < 2 * cases; ++i) {
            const Window w = some.window();
            const Segment line{some.pointNear(w), some.pointNear(w)};
            for (const Variant& variant : formsOf({"NLN"})) {
                const QByteArray what = said(variant, w, line);
                clipping::Clipped piece[1];
                const bool visible = app::clipAll(variant, {&line, 1}, w, piece) == 1;
                const auto areas = pointed(of(variant, w, {line.a, line.a}, line.b));
                const auto highlighted = of(variant, w, line).areas;
                const auto isHighlighted = [](const OverlayArea& a) {
                    return a.emphasis == Emphasis::Highlighted;
                };
                QVERIFY2(areas.size() == (visible ? 1 : 0), what);
                QVERIFY2(std::ranges::count_if(highlighted, isHighlighted) == (visible ? 1 : 0),
                         what);
                if (!visible)
                    continue;
                QVERIFY2(std::ranges::find_if(highlighted, isHighlighted)->label == areas[0].label,
                         what);
                const auto& [a, b] = piece[0].segment;
                if (isCorner(a, w) || isCorner(b, w) || w.min.x == w.max.x
                    || w.min.y == w.max.y) // two are right
                    continue;
                const QString name =
                    letters(clipping::cutEdgeOfA(piece[0].cut), clipping::cutEdgeOfB(piece[0].cut));
                QVERIFY2(areas[0].label == name, what + " " + areas[0].label.toUtf8());
            }
        }
    }

    void sectorsCoverThePlaneOnce()
    {
        Cases some(2);
        const Variant nln{clipping::findAlgorithm("NLN")};
        int inside = 0;
        for (int i = 0; i < 2 * cases; ++i) {
            const Window w = some.window();
            const Segment line{some.point(), some.point()};
            if (w.min.x == w.max.x || w.min.y == w.max.y || isCorner(line.a, w))
                continue;
            const bool visible = nln.algorithm->corrected.clip(line, w).has_value();
            int here = 0;
            bool onBorder = false;
            for (const OverlayArea& area : of(nln, w, {line.a, line.a}, line.b).areas) {
                const double d = depth(area.corners, line.b);
                onBorder = onBorder || std::abs(d) < 1e-9;
                if (d < 1e-9)
                    continue;
                ++here;
                const bool hatched = area.ground == OverlayArea::Ground::Hatched;
                QVERIFY2(hatched != visible, said(nln, w, line));
                QVERIFY2(visible == area.pointed, said(nln, w, line));
            }
            QVERIFY2(onBorder || here == 1, said(nln, w, line));
            inside += !onBorder;
        }
        QVERIFY(inside > cases);
    }

    void parametersAreTheLibrarys()
    {
        Cases some(3);
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Segment line{some.pointNear(w), some.pointNear(w)};
            for (const Variant& variant : formsOf({"LB", "CB"})) {
                if (w.min.x == w.max.x || w.min.y == w.max.y)
                    if (variant.form == clipping::Form::Published)
                        continue; // CB's normals vanish, and with them what it could see
                const QByteArray what = said(variant, w, line);
                const auto trace = traceOf(variant, line, w);
                const Overlay overlay = of(variant, w, line);
                QVERIFY2((overlay.axis->from <= overlay.axis->to)
                             == (trace.outcome == clipping::Outcome::Visible),
                         what);
                for (const clipping::Step& step : trace.steps)
                    for (const clipping::NamedValue& value : step.values)
                        if (step.edge != Edge::NoEdge && (value.name == "r" || value.name == "t")) {
                            const QString name = std::array{"", "left", "right", "bottom",
                                                            "top"}[std::size_t(step.edge)];
                            const auto tick = std::ranges::find(overlay.axis->ticks, name,
                                                                &app::OverlayAxis::Tick::edge);
                            QVERIFY2(tick != overlay.axis->ticks.end(), what);
                            QVERIFY2(tick->t == value.value, what);
                        }
                if (trace.outcome != clipping::Outcome::Visible)
                    continue;
                const Point d = line.b - line.a, a = line.a + overlay.axis->from * d,
                            b = line.a + overlay.axis->to * d;
                const auto near = [](const Point& p, const Point& q) {
                    return std::abs(p.x - q.x) < 1e-12 && std::abs(p.y - q.y) < 1e-12;
                };
                QVERIFY2(near(a, trace.visible.a) && near(b, trace.visible.b), what);
            }
        }
    }

    void entriesAndExitsAreMarkedOnTheirEdges()
    {
        Cases some(4);
        const Variant lb{clipping::findAlgorithm("LB")};
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Segment line{some.point(), some.point()};
            const Overlay overlay = of(lb, w, line);
            const Point d = line.b - line.a;
            for (const app::OverlayAxis::Tick& tick : overlay.axis->ticks) {
                const auto way = tick.edge == "left"     ? d.x
                                 : tick.edge == "right"  ? -d.x
                                 : tick.edge == "bottom" ? d.y
                                                         : -d.y;
                QVERIFY2(tick.enters == (way > 0), said(lb, w, line));
            }
            QCOMPARE(overlay.axis->ticks.size(),
                     std::size_t((d.x != 0 ? 2 : 0) + (d.y != 0 ? 2 : 0)));
        }
    }

    // The corners' signs against whole numbers; the highlighted row against the trace.
    void signsAreTheLibrarys()
    {
        Cases some(5);
        int asked = 0;
        for (int i = 0; i < 4 * cases; ++i) {
            const auto whole = [](const Point& p) {
                return Point(std::round(p.x), std::round(p.y));
            };
            Window w = some.window();
            w = {whole(w.min), whole(w.max)};
            const Segment line{whole(some.pointNear(w)), whole(some.pointNear(w))};
            for (const Variant& variant : formsOf({"Skala"})) {
                const auto patterns = valuesNamed(traceOf(variant, line, w), "c");
                const Overlay overlay = of(variant, w, line);
                QVERIFY2(overlay.table->highlightedRow.has_value() == !patterns.empty(),
                         said(variant, w, line));
                std::vector<OverlayMark> signs = overlay.marks;
                std::erase_if(signs, [](const OverlayMark& m) { return !m.label.startsWith('x'); });
                QVERIFY2(signs.size() == (patterns.empty() ? 0 : 4), said(variant, w, line));
                if (patterns.empty())
                    continue;
                ++asked;
                QVERIFY2(*overlay.table->highlightedRow == std::size_t(patterns.back()),
                         said(variant, w, line));
                bool allLeft = true, allOnLine = true;
                const Point d = line.b - line.a;
                const auto sideOf = [&](const Point& p) {
                    const Point e = p - line.a;
                    return d.x * e.y - d.y * e.x;
                };
                for (const OverlayMark& mark : signs) {
                    allLeft = allLeft && sideOf(mark.at) >= 0;
                    allOnLine = allOnLine && sideOf(mark.at) == 0;
                }
                const bool strict = allLeft && variant.form == clipping::Form::Corrected;
                // A window without area on the line is taken for one that the line halves.
                const auto side = [&](const OverlayMark& mark) {
                    const int k = mark.label[1].digitValue();
                    const Point beside =
                        d.x != 0 ? Point(0, k < 2 ? -1 : 1) : Point(k == 0 || k == 3 ? -1 : 1, 0);
                    return sideOf(strict && allOnLine ? mark.at + beside : mark.at);
                };
                for (const OverlayMark& mark : signs)
                    QVERIFY(mark.label.endsWith(
                        mark.symbol == OverlayMark::Symbol::Plus ? u'+' : u'\u2212'));
                for (const OverlayMark& mark : signs)
                    QVERIFY2((mark.symbol == OverlayMark::Symbol::Plus)
                                 == (strict ? side(mark) > 0 : side(mark) >= 0),
                             said(variant, w, line));
            }
        }
        QVERIFY(asked > cases);
    }

    void theTableOfSignsIsTheAlgorithms()
    {
        const Variant skala{clipping::findAlgorithm("Skala")};
        const auto rows = of(skala, {{0, 0}, {4, 3}}, {{1, 1}, {5, 2}}).table->rows;
        QCOMPARE(rows.size(), std::size_t(16));
        QCOMPARE(rows[3], (QStringList{"3", "0011", "right, left"}));
        QCOMPARE(rows[8], (QStringList{"8", "1000", "top, left"}));
        QCOMPARE(rows[5][2], QString("impossible"));
        QCOMPARE(rows[15][2], QString("none"));
        for (std::size_t c = 0; c < 16; ++c)
            QCOMPARE(rows[c][2], rows[15 - c][2]);
    }

    void exactSaysWhichCornerDecides()
    {
        Cases some(6);
        const Variant exact = app::exactVariant();
        for (int i = 0; i < 2 * cases; ++i) {
            const Window w = some.window();
            const Segment line{some.pointNear(w), some.pointNear(w)};
            const Overlay overlay = of(exact, w, line);
            const auto missed = std::ranges::count(overlay.marks, OverlayMark::Symbol::Hollow,
                                                   &OverlayMark::symbol);
            const auto beyondOne = [&](glm::length_t k) {
                return (line.a[k] < w.min[k] && line.b[k] < w.min[k])
                       || (line.a[k] > w.max[k] && line.b[k] > w.max[k]);
            };
            const bool visible = exact.algorithm->corrected.clip(line, w).has_value();
            QVERIFY2((missed > 0) == (!visible && !beyondOne(0) && !beyondOne(1)),
                     said(exact, w, line));
        }
    }

    // A line that passes the window on the right, from the left and below to the right and above:
    // the top left corner does not reject it.
    void onlyTheCornerThatRejectsIsMissed()
    {
        const auto marks = of(app::exactVariant(), {{0, 0}, {4, 4}}, {{-1, -20}, {6, 5}}).marks;
        QCOMPARE(marks[0].at, Point(0, 4));
        QCOMPARE(marks[0].symbol, OverlayMark::Symbol::Filled);
        QCOMPARE(marks[1].at, Point(4, 0));
        QCOMPARE(marks[1].symbol, OverlayMark::Symbol::Hollow);
    }

    // What the pushes leave is what is visible, and the marks are where the trace has been.
    void pushesEndWhereTheTraceEnds()
    {
        Cases some(7);
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Segment line{some.pointNear(w), some.pointNear(w)};
            for (const Variant& variant : formsOf({"KWC", "MD", "CS", "SPY"})) {
                const auto trace = traceOf(variant, line, w);
                const Overlay overlay = of(variant, w, line);
                for (const OverlayMark& mark : overlay.marks) {
                    if (mark.symbol != OverlayMark::Symbol::Diamond)
                        continue;
                    const auto was = [&](const clipping::Step& step) {
                        return step.segment.a == mark.at || step.segment.b == mark.at;
                    };
                    QVERIFY2(std::ranges::any_of(trace.steps, was), said(variant, w, line));
                }
                if (variant.algorithm->abbreviation == "MD" && !trace.steps.empty())
                    QCOMPARE(overlay.table->rows.back()[0],
                             QString(trace.outcome == clipping::Outcome::Visible ? "visible"
                                                                                 : "rejected"));
            }
        }
    }

    void badInputIsASentence()
    {
        const double nan = std::nan(""), huge = 1e300;
        const Window w{{0, 0}, {4, 3}};
        for (const Variant& variant : everyForm()) {
            for (const auto& [window, line] : {std::pair{w, Segment{{nan, 0}, {1, 1}}},
                                               {Window{{4, 3}, {0, 0}}, {{0, 0}, {1, 1}}},
                                               {Window{{0, 0}, {INFINITY, 1}}, {{0, 0}, {1, 1}}}}) {
                const Overlay overlay = of(variant, window, line, Point(1, 1));
                QVERIFY(!overlay.caption.isEmpty() && overlay.areas.empty());
            }
            for (const auto& [window, line] :
                 {std::pair{Window{{2, 2}, {2, 2}}, Segment{{-huge, -huge}, {huge, huge}}},
                  {w, {{-huge, 1}, {huge, 2}}},
                  {w, {{1, 1}, {1, 1}}},
                  {Window{{-huge, -huge}, {huge, huge}}, {{0, 0}, {huge, 1}}}}) {
                const Overlay overlay = of(variant, window, line, Point(nan, 1));
                QVERIFY(!overlay.caption.isEmpty());
                for (const OverlayArea& area : overlay.areas)
                    for (const Point& corner : area.corners)
                        QVERIFY2(depth({{-8, -8}, {8, -8}, {8, 8}, {-8, 8}}, corner) > -1e-6,
                                 said(variant, window, line));
            }
            const Overlay nowhere = of(variant, w, {{0, 0}, {1, 1}}, Point(nan, 1)),
                          without = of(variant, w, {{0, 0}, {1, 1}});
            QVERIFY2(!nowhere.areas.empty() || !nowhere.lines.empty(),
                     said(variant, w, {{0, 0}, {1, 1}}));
            QCOMPARE(nowhere.areas.size(), without.areas.size());
            QCOMPARE(nowhere.lines.size(), without.lines.size());
        }
        for (const Variant& variant : app::variants())
            if (variant.misprint)
                QVERIFY(!of(variant, w, {{0, 0}, {9, 9}}).caption.isEmpty());
    }

    // Where y grows downwards on the screen, its top edge is the library's bottom.
    void namesAreAsTheyAreSeen()
    {
        const Window w{{0, 0}, {4, 3}};
        const Segment line{{1, -5}, {1, 2}};
        const Variant md{clipping::findAlgorithm("MD")};
        QVERIFY(of(md, w, line, {}, YAxis::Down).caption.contains("the top edge"));
        QVERIFY(of(md, w, line, {}, YAxis::Up).caption.contains("the bottom edge"));
        const Variant nln{clipping::findAlgorithm("NLN")};
        const auto label = [&](YAxis y) {
            return pointed(of(nln, w, {{1, 1}, {1, 1}}, Point(1, 9), y)).at(0).label;
        };
        QCOMPARE(label(YAxis::Up), QString("T"));
        QCOMPARE(label(YAxis::Down), QString("B"));
    }
};

} // namespace overlays_lines_test

TEST_CLASS(overlays_lines_test::LinesTest, Core)
#include "tests/app/overlays/lines_test.moc"
