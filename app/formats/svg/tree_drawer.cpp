// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/tree_drawer.h"

#include "app/document/flatten.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/recipe_text.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"

#include <array>
#include <cmath>

namespace app::svg {
namespace {

// Elements that other programs draw and Clearcut cannot keep. All elements not listed draw nothing
// themselves.
struct Foreign {
    std::string_view element;
    const LossKind* loss;
};
constexpr std::array foreigners{
    Foreign{"text", &losses::text},
    Foreign{"flowRoot", &losses::text},
    Foreign{"image", &losses::image},
    Foreign{"foreignObject", &losses::foreignObject},
    Foreign{"animate", &losses::animation},
    Foreign{"animateTransform", &losses::animation},
    Foreign{"animateMotion", &losses::animation},
    Foreign{"animateColor", &losses::animation},
    Foreign{"set", &losses::animation},
    Foreign{"script", &losses::script},
};

const Foreign* findForeign(std::string_view element)
{
    const auto found = std::ranges::find(foreigners, element, &Foreign::element);
    return found == foreigners.end() ? nullptr : &*found;
}

bool finite(const Subpath& path)
{
    const auto small = [](const Point& p) {
        return std::abs(p.x) <= largestCoordinate && std::abs(p.y) <= largestCoordinate;
    };
    return small(path.start) && std::ranges::all_of(path.segments, [&](const PathSegment& segment) {
               return small(segment.to) && small(segment.control1) && small(segment.control2);
           });
}

bool hasArea(const std::vector<Subpath>& paths)
{
    return std::ranges::any_of(paths, [](const Subpath& path) {
        return path.segments.size() > 1
               || (path.segments.size() == 1 && path.segments.front().curved);
    });
}

} // namespace

const TreeDrawer::Row* TreeDrawer::find(std::string_view element)
{
    static constexpr std::array all{
        Row{"g", &TreeDrawer::drawGroup},         Row{"a", &TreeDrawer::drawGroup},
        Row{"svg", &TreeDrawer::drawNestedSvg},   Row{"use", &TreeDrawer::drawUse},
        Row{"switch", &TreeDrawer::drawSwitch},   Row{"path", &TreeDrawer::drawOutline},
        Row{"line", &TreeDrawer::drawOutline},    Row{"polyline", &TreeDrawer::drawOutline},
        Row{"polygon", &TreeDrawer::drawOutline}, Row{"rect", &TreeDrawer::drawOutline},
        Row{"circle", &TreeDrawer::drawOutline},  Row{"ellipse", &TreeDrawer::drawOutline},
    };
    const auto found = std::ranges::find(all, element, &Row::element);
    return found == all.end() ? nullptr : &*found;
}

TreeDrawer::TreeDrawer(const Tree& tree, Report& report, double tolerance)
    : tree_(tree), report_(report), styles_(tree), paints_(tree, styles_, report),
      tolerance_(tolerance), idIsTaken_(tree.size())
{
}

Document TreeDrawer::drawAll(const Page& page, const Matrix& rootMatrix, const Point& viewport)
{
    idOf(0); // reserves the root's id
    Place place;
    place.matrix = rootMatrix;
    place.lengths.viewport = viewport;
    drawChildren(0, inside(0, place));
    report_.add(losses::styleRule, styles_.ignoredRules());
    report_.add(losses::metadata, tree_.saysTooMuch() ? 1 : 0);
    report_.add(losses::elementNote, tree_.notesOfElements() - notesKept_);
    return containers_.take(page, tree_.about(), report_);
}

void TreeDrawer::draw(Node node, const Place& around)
{
    node_ = node;
    if (around.depth > deepestNesting)
        throw Refused{
            Text::tr("nests elements deeper than %1; ungroup some of them.").arg(deepestNesting)};
    if (around.repeated && ++repeated_ > mostRepeated)
        throw Refused{
            Text::tr("exceeds the limit of %1 elements repeated by <use>.").arg(mostRepeated)};
    const auto name = tree_.name(node);
    if (const Row* row = find(name)) {
        (this->*row->draw)(node, around);
        return;
    }
    if (const Foreign* foreign = findForeign(name))
        report_.add(*foreign->loss);
}

void TreeDrawer::drawChildren(Node node, const Place& place)
{
    for (const Node child : Children(tree_, node))
        draw(child, place);
}

Place TreeDrawer::inside(Node node, const Place& around)
{
    Place place = around;
    place.properties = styles_.of(node, around.properties, around.lengths);
    place.lengths.fontSize = place.properties.fontSize;
    place.opacity *= place.properties.opacity;
    place.hidden = place.hidden || !place.properties.displayed;
    place.use = noNode;
    ++place.depth;
    if (const auto matrix = parseTransform(place.properties.transform))
        place.matrix = place.matrix * *matrix;
    else
        report_.add(losses::transform);
    if (!place.properties.clipPath.empty())
        addClipPath(node, place);
    return place;
}

void TreeDrawer::reportEffects(const Properties& properties, bool group)
{
    if (!properties.mask.empty())
        report_.add(losses::mask);
    if (!properties.filter.empty())
        report_.add(losses::filter);
    if (!properties.blending.empty())
        report_.add(losses::blending);
    if (group && properties.opacity < 1)
        report_.add(losses::groupOpacity);
}

void TreeDrawer::drawGroup(Node node, const Place& around)
{
    const Place place = inside(node, around);
    reportEffects(place.properties, true);
    const bool isLayer = tree_.attribute(node, "inkscape:groupmode") == "layer";
    if (around.repeated || !(isLayer || isGroup(node)))
        drawChildren(node, place);
    else
        drawContainer(node, isLayer ? Container::Kind::Layer : Container::Kind::Group, place,
                      around);
}

// Whether a <g> becomes a group. Anonymous ones dissolve: they only style or move their content.
bool TreeDrawer::isGroup(Node node) const
{
    return tree_.name(node) == "g"
           && (!tree_.attribute(node, "id").empty()
               || !tree_.attribute(node, "inkscape:label").empty()
               || tree_.hasAttribute(node, "clearcut:group") || tree_.notesOf(node).count > 0);
}

void TreeDrawer::drawContainer(Node node, Container::Kind kind, Place place, const Place& around)
{
    auto name = tree_.attribute(node, "inkscape:label");
    if (name.empty() && kind == Container::Kind::Layer)
        name = tree_.attribute(node, "id");
    Particulars particulars = particularsOf(node);
    place.hidden = around.hidden; // the objects of a hidden container need not be hidden themselves
    containers_.open({.kind = kind,
                      .name = QString::fromUtf8(name),
                      .svgId = std::move(particulars.id),
                      .title = std::move(particulars.title),
                      .description = std::move(particulars.description),
                      .newStyle = QString::fromUtf8(tree_.attribute(node, "clearcut:new-objects")),
                      .visible = place.properties.displayed,
                      .locked = tree_.attribute(node, "sodipodi:insensitive") == "true"});
    drawChildren(node, place);
    containers_.close();
}

// The element's own properties; called once for each element.
Particulars TreeDrawer::particularsOf(Node node)
{
    const Notes& notes = tree_.notesOf(node);
    notesKept_ += notes.count;
    return {.id = idOf(node), .title = notes.title, .description = notes.description};
}

// The element's id; only the first drawn element with an id keeps it.
QString TreeDrawer::idOf(Node node)
{
    const auto id = tree_.attribute(node, "id");
    if (id.empty())
        return {};
    auto taken = idIsTaken_[tree_.find(id)];
    if (taken) {
        report_.add(losses::doubleId);
        return {};
    }
    taken = true;
    return QString::fromUtf8(id);
}

// Draws the first child that draws something and requires no extension or language.
void TreeDrawer::drawSwitch(Node node, const Place& around)
{
    const Place place = inside(node, around);
    reportEffects(place.properties, true);
    for (const Node child : Children(tree_, node)) {
        const bool asksForMore = !tree_.attribute(child, "requiredExtensions").empty()
                                 || !tree_.attribute(child, "systemLanguage").empty();
        const auto name = tree_.name(child);
        if (!asksForMore && (find(name) || findForeign(name))) {
            draw(child, place);
            return;
        }
    }
}

void TreeDrawer::drawOutline(Node node, const Place& around)
{
    Place place = inside(node, around);
    Properties& properties = place.properties;
    const OutlineKind* kind = findOutlineKind(tree_.name(node));
    Drawn drawn;
    drawn.paths = placed(kind->outline(tree_, node, place.lengths), place.matrix);
    if (drawn.paths.empty() || place.matrix.determinant() == 0)
        return;
    if (!hasArea(drawn.paths))
        properties.fill = {}; // the writer leaves out such a fill, too
    reportEffects(properties, false);
    drawn.style =
        paints_.style(properties, place.opacity, properties.fixedWidth ? 1 : place.matrix.scale());
    if (properties.longDashes)
        report_.add(losses::longDashes);
    if (kind->takesMarkers)
        report_.add(losses::marker, !properties.markerStart.empty() + !properties.markerMid.empty()
                                        + !properties.markerEnd.empty());
    if (drawn.style.stroke && !properties.fixedWidth && !place.matrix.keepsShapes())
        report_.add(losses::unevenStroke);
    drawn.hidden = place.hidden || !properties.visible;
    const Node named = place.repeated ? around.use : node;
    if (named != noNode)
        drawn.particulars = particularsOf(named);
    drawn.particulars.recipe = readRecipe(tree_.attribute(node, "clearcut:recipe"), drawn.paths);
    addClipped(std::move(drawn), place);
}

std::vector<Subpath> TreeDrawer::placed(Outline outline, const Matrix& matrix)
{
    if (outline.damaged)
        report_.add(losses::damaged);
    for (Subpath& path : outline.paths) {
        transform(path, matrix);
        if (!finite(path))
            throw Refused{Text::tr("has a coordinate that is too large to be drawn.")};
    }
    return std::move(outline.paths);
}

void TreeDrawer::countParts(const Drawn& drawn)
{
    const Style& style = drawn.style;
    if (!(style.width <= largestCoordinate && std::abs(style.dashOffset) <= largestCoordinate))
        throw Refused{Text::tr("has a stroke that is too large to be drawn.")};
    parts_ += 1 + style.dashes.size();
    for (const Subpath& path : drawn.paths)
        parts_ += 1 + chordCount(path, tolerance_);
    if (parts_ > mostParts)
        throw Refused{Text::tr("exceeds the limit of %1 points in a drawing.").arg(mostParts)};
}

} // namespace app::svg
