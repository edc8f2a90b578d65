// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "app/teaching/overlay_of.h"

#include <QTest>

#include <algorithm>

#include "tests/clipping/random.h"
#include "tests/not_empty.h"

// Windows, lines and points for overlays: half of them small whole numbers, so that many lie on
// edges, in line with corners, and in one another.

class Cases {
public:
    explicit Cases(unsigned seed) : random_(seed) {}

    clipping::Window window()
    {
        const app::Point p = point(), q = point();
        clipping::Window window{{std::min(p.x, q.x), std::min(p.y, q.y)},
                                {std::max(p.x, q.x), std::max(p.y, q.y)}};
        return window;
    }
    app::Point point()
    {
        if (random_.whole(0, 1) == 0)
            return {random_.whole(-6, 6), random_.whole(-6, 6)};
        return {random_.between(-6, 6), random_.between(-6, 6)};
    }
    /// A point that is often on an edge of the window or its line, or a corner.
    app::Point pointNear(const clipping::Window& w)
    {
        app::Point p = point();
        for (glm::length_t k = 0; k < 2; ++k)
            if (const int where = random_.whole(0, 5); where < 2)
                p[k] = (where == 0 ? w.min : w.max)[k];
        return p;
    }

private:
    Random random_;
};

inline constexpr clipping::Window everything{{-8, -8}, {8, 8}};

/// Every form of every row.
inline std::vector<app::Variant> everyForm() { return app::variants(); }
inline std::vector<app::Variant> formsOf(std::initializer_list<std::string_view> abbreviations)
{
    std::vector<app::Variant> forms = everyForm();
    std::erase_if(forms, [&](const app::Variant& c) {
        return c.misprint // whose ends may be no numbers
               || std::ranges::find(abbreviations, c.algorithm->abbreviation)
                      == abbreviations.end();
    });
    return notEmpty(std::move(forms));
}

inline clipping::Trace traceOf(const app::Variant& variant, const clipping::Segment& line,
                               const clipping::Window& window)
{
    return app::functionsOf(variant).trace(line, window);
}

/// All values of that name, in order.
inline std::vector<double> valuesNamed(const clipping::Trace& trace, std::string_view name)
{
    std::vector<double> values;
    for (const clipping::Step& step : trace.steps)
        for (const clipping::NamedValue& value : step.values)
            if (value.name == name)
                values.push_back(value.value);
    return values;
}

/// The areas that the pointer is in, as the overlay says.
inline std::vector<app::OverlayArea> pointed(const app::Overlay& overlay)
{
    std::vector<app::OverlayArea> areas = overlay.areas;
    std::erase_if(areas, [](const app::OverlayArea& area) { return !area.pointed; });
    return areas;
}

/// How deep a point is inside a convex polygon: the least distance to an edge; < 0: outside.
inline double depth(const std::vector<app::Point>& polygon, const app::Point& p)
{
    if (polygon.size() < 3)
        return -1;
    double turn = 0, least = 1e9;
    const auto cross = [](const app::Point& u, const app::Point& v) {
        return u.x * v.y - u.y * v.x;
    };
    for (std::size_t i = 2; i < polygon.size(); ++i)
        turn += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const app::Point a = polygon[i], d = polygon[(i + 1) % polygon.size()] - a;
        const double length = std::hypot(d.x, d.y);
        if (length > 1e-12)
            least = std::min(least, (turn > 0 ? 1 : -1) * cross(d, p - a) / length);
    }
    return least;
}

inline QByteArray said(const app::Variant& variant, const clipping::Window& w,
                       const clipping::Segment& s)
{
    return QStringLiteral("%1, window (%2,%3)-(%4,%5), line (%6,%7)-(%8,%9)")
        .arg(app::keyOf(variant))
        .arg(w.min.x, 0, 'g', 17)
        .arg(w.min.y, 0, 'g', 17)
        .arg(w.max.x, 0, 'g', 17)
        .arg(w.max.y, 0, 'g', 17)
        .arg(s.a.x, 0, 'g', 17)
        .arg(s.a.y, 0, 'g', 17)
        .arg(s.b.x, 0, 'g', 17)
        .arg(s.b.y, 0, 'g', 17)
        .toUtf8();
}
