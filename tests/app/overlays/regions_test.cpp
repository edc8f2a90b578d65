// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/midpoints.h"
#include "app/overlays/parts.h"

#include "tests/app/overlays/overlay_cases.h"
#include "tests/test_class.h"

namespace overlays_regions_test {

using app::Emphasis;
using app::Overlay;
using app::OverlayArea;
using app::Point;
using app::Variant;
using app::YAxis;
using clipping::Segment;
using clipping::Window;

namespace {

constexpr int cases = 3000;

unsigned codeOf(const Point& p, const Window& w) // by the definition
{
    return (p.x < w.min.x) | unsigned(p.x > w.max.x) << 1 | unsigned(p.y < w.min.y) << 2
           | unsigned(p.y > w.max.y) << 3;
}

/// The first two outcodes in a trace: of its ends.
std::optional<std::pair<unsigned, unsigned>> codesIn(const clipping::Trace& trace)
{
    std::vector<unsigned> codes;
    for (const clipping::Step& step : trace.steps)
        for (const clipping::NamedValue& value : step.values)
            if (value.kind == clipping::ValueKind::Bits)
                codes.push_back(unsigned(value.value));
    if (codes.size() < 2)
        return std::nullopt;
    return std::pair(codes[0], codes[1]);
}

/// The outcodes of the near and the far point after each halving.
std::vector<std::pair<unsigned, unsigned>> codesAfterHalvings(const clipping::Trace& trace)
{
    std::vector<std::pair<unsigned, unsigned>> all;
    std::pair<unsigned, unsigned> codes; // near, far
    for (const clipping::Step& step : trace.steps) {
        int told = 0; // both where a search begins
        for (const clipping::NamedValue& value : step.values)
            if (value.name == "near" || value.name == "far") {
                (value.name == "near" ? codes.first : codes.second) = unsigned(value.value);
                ++told;
            }
        if (told == 1)
            all.push_back(codes);
    }
    return all;
}

/// As Sobkow, Pospisil and Yang name a region.
QString nameOf(unsigned code)
{
    QString name;
    for (int bit = 0; bit < 4; ++bit)
        if (code >> bit & 1U)
            name += QStringLiteral("LRBT")[bit];
    return name.isEmpty() ? QStringLiteral("C") : name;
}

Overlay at(const Variant& variant, const Window& w, const Point& p, YAxis y,
           std::optional<Segment> line = {})
{
    return app::overlayOf({variant, w, line, p, everything, y});
}

} // namespace

class RegionsTest : public QObject {
    Q_OBJECT

private slots:
    /// Every algorithm has an overlay with a caption for any line, its own or the general one.
    void everyAlgorithmHasItsOverlay()
    {
        const Window w{{-4, -3}, {4, 3}};
        const Segment line{{-6, -1}, {3, 5}};
        for (const Variant& variant : everyForm()) {
            const Overlay without = app::overlayOf({variant, w, std::nullopt, {}, everything}),
                          with = app::overlayOf({variant, w, line, {}, everything});
            for (const Overlay* overlay : {&without, &with}) {
                QVERIFY2(overlay->areas.size() + overlay->lines.size() > 0, said(variant, w, line));
                QVERIFY2(!overlay->caption.isEmpty(), said(variant, w, line));
            }
            for (const Point& end : {line.a, line.b})
                QVERIFY2(std::ranges::count(with.marks, end, &app::OverlayMark::at) == 1,
                         said(variant, w, line));
            QVERIFY2(with.caption != without.caption, said(variant, w, line));
        }
    }

    void theRegionUnderThePointerIsTheLibrarys()
    {
        Cases some(1);
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Point p = some.pointNear(w), q = some.pointNear(w);
            for (const Variant& variant : formsOf({"CS", "Skala", "SPY", "MS", "EX"})) {
                const QByteArray what = said(variant, w, {p, q});
                const unsigned code = codeOf(p, w);
                if (const auto codes = codesIn(traceOf(variant, {p, q}, w))) {
                    QVERIFY2(codes->first == code, what);
                    QVERIFY2(codes->second == codeOf(q, w), what);
                } else
                    QVERIFY2(variant.algorithm->abbreviation == "EX", what);
                const bool letters = variant.algorithm->abbreviation == "SPY";
                for (const YAxis y : {YAxis::Up, YAxis::Down}) {
                    const auto areas = pointed(at(variant, w, p, y));
                    QVERIFY2(areas.size() == 1, what);
                    const QString name = letters ? nameOf(code)
                                                 : QStringLiteral("%1%2%3%4")
                                                       .arg(code >> 3 & 1U)
                                                       .arg(code >> 2 & 1U)
                                                       .arg(code >> 1 & 1U)
                                                       .arg(code & 1U);
                    QVERIFY2(areas[0].label == name, what);
                    for (qsizetype bit = 0; bit < 4 && !letters; ++bit)
                        QCOMPARE(areas[0].strong >> bit & 1U, unsigned(name[bit] == u'1'));
                }
            }
        }
    }

    void regionsAreWhereTheirPointsAre()
    {
        Cases some(2);
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Point p = some.point();
            for (const Variant& variant : formsOf({"CS", "SPY", "MD", "SB"}))
                for (const OverlayArea& area : at(variant, w, p, YAxis::Down).areas) {
                    const double d = depth(area.corners, p);
                    const bool here =
                        area.pointed
                        || (area.ground == OverlayArea::Ground::Hatched && p.x > w.max.x);
                    const bool agrees =
                        d > 1e-9 ? here : !here || d > -1e-9 || area.corners.empty();
                    QVERIFY2(agrees, said(variant, w, {p, p}));
                }
        }
    }

    // From an end to the middle of the window: nothing is rejected, so the tests that fire are all.
    void theTestsThatFireAreTheLibrarys()
    {
        Cases some(3);
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Point p = some.pointNear(w);
            for (const Variant& variant : formsOf({"KWC", "MD"})) {
                const Segment line{p, (w.min + w.max) / 2.0};
                const auto trace = traceOf(variant, line, w);
                QStringList fired;
                Point before = p;
                for (const clipping::Step& step : trace.steps) {
                    if (step.edge != clipping::Edge::NoEdge && step.segment.a != before)
                        fired << std::array{"", "left", "right", "bottom",
                                            "top"}[std::size_t(step.edge)];
                    before = step.segment.a;
                }
                fired.removeDuplicates();
                const auto areas = pointed(at(variant, w, p, YAxis::Up));
                QVERIFY2(areas.size() == 1, said(variant, w, line));
                const QString label = areas[0].label;
                const bool corner = (codeOf(p, w) & 3U) != 0 && (codeOf(p, w) & 12U) != 0;
                const bool straight = line.a.x == line.b.x || line.a.y == line.b.y;
                if (straight && variant.algorithm->abbreviation == "KWC")
                    continue; // its special cases ask otherwise
                if (fired.isEmpty())
                    QVERIFY2(label == "stays", said(variant, w, line));
                else
                    QVERIFY2(label.startsWith(fired[0]) && (fired.size() == 1 || corner)
                                 && label.contains(fired.back()),
                             said(variant, w, line));
                QCOMPARE(label.contains("then"), corner);
            }
        }
    }

    void theCellUnderThePointerIsTheLibrarys()
    {
        Cases some(4);
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Point p = some.pointNear(w);
            for (const Variant& variant : formsOf({"SB"})) {
                const Segment line{p,
                                   {w.max.x, (w.min.y + w.max.y) / 2}}; // begins at p, goes right
                const auto cells = valuesNamed(traceOf(variant, line, w), "c");
                const auto areas = pointed(at(variant, w, p, YAxis::Down));
                QVERIFY2(areas.size() == (p.x > w.max.x ? 0 : 1), said(variant, w, line));
                if (!areas.empty())
                    QVERIFY2(areas[0].label == QString::number(cells.at(0)),
                             said(variant, w, line));
            }
        }
    }

    void theCellsOfATraceAreHighlighted()
    {
        Cases some(5);
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Segment line{some.pointNear(w), some.pointNear(w)};
            for (const Variant& variant : formsOf({"SB"})) {
                const auto trace = traceOf(variant, line, w);
                std::vector<double> cells = valuesNamed(trace, "c");
                if (trace.outcome == clipping::Outcome::Visible)
                    cells.push_back(4);
                const Overlay overlay =
                    app::overlayOf({variant, w, line, std::nullopt, everything});
                for (const OverlayArea& area : overlay.areas)
                    if (area.ground == OverlayArea::Ground::Clear)
                        QVERIFY2((area.emphasis == Emphasis::Highlighted)
                                     == (std::ranges::count(cells, area.label.toDouble()) > 0),
                                 said(variant, w, line));
            }
        }
    }

    void halvingsAreTheLibrarys()
    {
        Cases some(6);
        const Variant ms{clipping::findAlgorithm("MS")};
        int compared = 0;
        for (int i = 0; i < cases; ++i) {
            const Window w = some.window();
            const Segment line{some.pointNear(w), some.pointNear(w)};
            const auto trace = traceOf(ms, line, w);
            const auto codes = codesAfterHalvings(trace);
            const auto mine = app::halvings(line, w, 5);
            for (std::size_t k = 0; k < std::min<std::size_t>(mine.size(), 5); ++k) {
                if (mine[k].forB != mine[0].forB)
                    break; // the library's first search goes on
                QVERIFY2(mine[k].nearCode == codes.at(k).first, said(ms, w, line));
                QVERIFY2(mine[k].farCode == codes.at(k).second, said(ms, w, line));
                ++compared;
            }
        }
        QVERIFY(compared > cases);
    }

    void codesOfBothEndsDecide()
    {
        const Variant cs{clipping::findAlgorithm("CS")};
        const Window w{{0, 0}, {4, 3}};
        const auto table = [&](const Segment& line) {
            return *app::overlayOf({cs, w, line, std::nullopt, everything, YAxis::Up}).table;
        };
        QCOMPARE(*table({{1, 1}, {2, 2}}).highlightedRow, std::size_t(3));
        QCOMPARE(*table({{-1, 5}, {2, 6}}).highlightedRow, std::size_t(2));
        QVERIFY(!table({{-1, 1}, {2, 6}}).highlightedRow);
        QCOMPARE(table({{-1, 5}, {2, 6}}).rows[2], (QStringList{"AND", "1000"}));
        QCOMPARE(table({{-1, 5}, {2, 6}}).rows[3], (QStringList{"OR", "1001"}));
    }
};

} // namespace overlays_regions_test

TEST_CLASS(overlays_regions_test::RegionsTest, Core)
#include "tests/app/overlays/regions_test.moc"
