// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/window_frame.h"

#include <glm/geometric.hpp>

#include "tests/app/overlays/overlay_cases.h"
#include "tests/test_class.h"

namespace overlays_shaped_test {

using app::Overlay;
using app::OverlayMark;
using app::Point;

// Overlays at windows that are no rectangles along the axes.

class ShapedTest : public QObject {
    Q_OBJECT

private slots:
    void aRotatedRectangleIsThatOfItsFrame()
    {
        Cases some(1);
        for (int i = 0; i < 300; ++i)
            for (const app::Variant& variant : everyForm()) {
                const app::WindowFrame frame{some.window(), 0.3};
                const clipping::Segment line{some.point(), some.point()};
                const clipping::Segment there{intoFrame(frame, line.a), intoFrame(frame, line.b)};
                const Overlay turned = app::overlayOf({.variant = variant,
                                                       .window = frame.box,
                                                       .line = line,
                                                       .seen = everything,
                                                       .angle = frame.angle});
                const Overlay straight = app::overlayOf({.variant = variant,
                                                         .window = frame.box,
                                                         .line = there,
                                                         .seen = {{-20, -20}, {20, 20}}});
                QCOMPARE(turned.caption, straight.caption);
                QCOMPARE(turned.marks.size(), straight.marks.size());
                for (std::size_t m = 0; m < turned.marks.size(); ++m)
                    QVERIFY(
                        glm::distance(turned.marks[m].at, outOfFrame(frame, straight.marks[m].at))
                        < 1e-9);
            }
    }
    void aConvexPolygonShowsItsEdgesAndCuts()
    {
        const std::vector<Point> corners{{-4, -3}, {4, -3}, {2, 4}, {-2, 4}};
        for (const app::Variant& variant : everyForm()) {
            const app::OverlaySubject subject{.variant = variant,
                                              .window = {{-4, -3}, {4, 4}},
                                              .line = clipping::Segment{{-6, 0}, {1, 6}},
                                              .seen = everything,
                                              .corners = corners};
            const Overlay overlay = app::overlayOf(subject);
            if (!app::polygonUsesOf(variant)) {
                QVERIFY(overlay.lines.empty() && overlay.caption.contains("rectangles only"));
                continue;
            }
            const auto visible = variant.algorithm->polygon->clip(*subject.line, {corners});
            QCOMPARE(overlay.marks.size(), visible ? 4U : 2U);
            QVERIFY(overlay.lines.size() >= corners.size());
            for (const app::OverlayLine& line : overlay.lines)
                if (line.kind == app::OverlayLine::Kind::Border)
                    QVERIFY(glm::dot(line.outwards, line.segment.a - Point(0, 0)) > 0);
            QVERIFY2(!visible || overlay.caption.contains("edge 4"), qPrintable(overlay.caption));
        }
    }
};

} // namespace overlays_shaped_test

TEST_CLASS(overlays_shaped_test::ShapedTest, Gui)
#include "tests/app/overlays/shaped_test.moc"
