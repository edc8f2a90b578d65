// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/outline.h"

#include "app/document/arc_curves.h"
#include "app/formats/svg/arc.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

// The lengths of one element. One that is not valid marks the outline as damaged.
class ShapeLengths {
public:
    ShapeLengths(const Tree& tree, Node node, const Properties& properties, const Lengths& lengths)
        : tree_(tree), node_(node), properties_(properties), lengths_(lengths)
    {
    }
    std::optional<double> x(std::string_view name) { return get(name, lengths_.viewport.x); }
    std::optional<double> y(std::string_view name) { return get(name, lengths_.viewport.y); }
    std::optional<double> other(std::string_view name) { return get(name, lengths_.diagonal()); }
    /// The radius of corners or of an ellipse. A negative one counts as missing.
    std::optional<double> radius(std::string_view name, double of)
    {
        const auto given = get(name, of);
        damaged_ = damaged_ || (given && *given < 0);
        return given && *given < 0 ? std::nullopt : given;
    }
    double width() const { return lengths_.viewport.x; }
    double height() const { return lengths_.viewport.y; }
    Outline outline(Subpath path, Recipe recipe = {}) const
    {
        Outline made{{std::move(path)}, damaged_};
        made.recipe = std::move(recipe);
        const Subpath& only = made.paths.front();
        if (only.closed && only.segments.back().to == only.start) // it is closed by this segment
            made.joints.push_back({0, only.segments.size() - 1});
        return made;
    }
    Outline nothing() const { return {{}, damaged_, !damaged_}; }

private:
    std::optional<double> get(std::string_view name, double of)
    {
        const auto text = trimmed(lengthText(tree_, node_, properties_, name));
        if (text.empty() || text == "auto")
            return std::nullopt;
        const auto length = lengths_.parse(text, of);
        damaged_ = damaged_ || !length;
        return length;
    }
    const Tree& tree_;
    Node node_;
    const Properties& properties_;
    const Lengths& lengths_;
    bool damaged_ = false;
};

Subpath ellipsePath(const Point& centre, const Point& radii)
{
    const Point right{centre.x + radii.x, centre.y}, bottom{centre.x, centre.y + radii.y};
    const Point left{centre.x - radii.x, centre.y}, top{centre.x, centre.y - radii.y};
    Subpath path{right, {}, true};
    Point from = right;
    for (const Point& to : {bottom, left, top, right}) {
        appendArc(path.segments, {from, to, radii, 0, false, true});
        from = to;
    }
    return path;
}

Outline rectangleOutline(const Tree& tree, Node node, const Properties& p, const Lengths& lengths)
{
    ShapeLengths a(tree, node, p, lengths);
    const Point min{a.x("x").value_or(0), a.y("y").value_or(0)};
    const Point size{a.x("width").value_or(0), a.y("height").value_or(0)};
    const auto rx = a.radius("rx", a.width()), ry = a.radius("ry", a.height());
    const Point radii{std::clamp(rx ? *rx : ry.value_or(0), 0.0, std::max(size.x / 2, 0.0)),
                      std::clamp(ry ? *ry : rx.value_or(0), 0.0, std::max(size.y / 2, 0.0))};
    if (!(size.x > 0 && size.y > 0))
        return a.nothing();
    const Point max = min + size;
    if (radii.x > 0 && radii.y > 0)
        return a.outline(roundedRectangle(min, max, radii),
                         radii.x == radii.y ? RectangleRecipe{min, size, radii.x} : Recipe());
    return a.outline({min, {{{max.x, min.y}}, {max}, {{min.x, max.y}}}, true},
                     RectangleRecipe{min, size});
}

Outline round(ShapeLengths& a, const Point& radii)
{
    const Point centre{a.x("cx").value_or(0), a.y("cy").value_or(0)};
    if (!(radii.x > 0 && radii.y > 0))
        return a.nothing();
    return a.outline(ellipsePath(centre, radii), EllipseRecipe{centre, radii});
}

Outline circleElement(const Tree& tree, Node node, const Properties& p, const Lengths& lengths)
{
    ShapeLengths a(tree, node, p, lengths);
    return round(a, Point(a.other("r").value_or(0)));
}

Outline ellipseElement(const Tree& tree, Node node, const Properties& p, const Lengths& lengths)
{
    ShapeLengths a(tree, node, p, lengths);
    const auto rx = a.radius("rx", a.width()), ry = a.radius("ry", a.height());
    return round(a, {rx ? *rx : ry.value_or(0), ry ? *ry : rx.value_or(0)});
}

Outline line(const Tree& tree, Node node, const Properties& p, const Lengths& lengths)
{
    ShapeLengths a(tree, node, p, lengths);
    const Point from{a.x("x1").value_or(0), a.y("y1").value_or(0)};
    const Point to{a.x("x2").value_or(0), a.y("y2").value_or(0)};
    return a.outline(lineBetween(from, to));
}

Outline polyline(const Tree& tree, Node node, const Properties&, const Lengths&)
{
    return parsePoints(tree.attribute(node, "points"), Ending::Open);
}

Outline polygon(const Tree& tree, Node node, const Properties&, const Lengths&)
{
    return parsePoints(tree.attribute(node, "points"), Ending::Closed);
}

Outline path(const Tree& tree, Node node, const Properties& p, const Lengths&)
{
    return parsePathData(lengthText(tree, node, p, "d"));
}

} // namespace

const OutlineKind* findOutlineKind(std::string_view element)
{
    static constexpr std::array all{
        OutlineKind{"path", path},
        OutlineKind{"line", line},
        OutlineKind{"polyline", polyline},
        OutlineKind{"polygon", polygon},
        OutlineKind{"rect", rectangleOutline},
        OutlineKind{"circle", circleElement},
        OutlineKind{"ellipse", ellipseElement},
    };
    const auto found = std::ranges::find(all, element, &OutlineKind::element);
    return found == all.end() ? nullptr : &*found;
}

} // namespace app::svg
