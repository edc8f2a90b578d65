// SPDX-License-Identifier: GPL-3.0-or-later
// Clip paths, and viewports that hide everything outside them: the content of both is really cut.
#include "app/formats/svg/css_shape.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/tree_drawer.h"
#include "app/lettering/outline_fonts.h"

#include <algorithm>

namespace app::svg {
PathShape rectangleShape(const Box& box, const Matrix& matrix)
{
    const Point max = box.min + box.size;
    Subpath path{box.min, {{{max.x, box.min.y}}, {max}, {{box.min.x, max.y}}}, true};
    svg::transform(path, matrix);
    return {Path({&path, 1}), FillRule::NonZero};
}

void TreeDrawer::addClipPath(std::string_view value, const Boxed& boxed, Place& place)
{
    const auto line = report_.line();
    const Node node = node_;
    const bool refers = equalsIgnoringCase(value.substr(0, 4), "url(");
    if (refers ? addClipReference(value, boxed, place) : addCssClip(value, boxed, place))
        report_.add(content_.keepsClips() ? losses::keptClipPath : losses::cutClipPath);
    report_.turnTo(line);
    node_ = node;
}

// False: there is nothing to cut at, or it was told why it is not cut.
bool TreeDrawer::addClipReference(std::string_view reference, const Boxed& boxed, Place& place)
{
    const Node clip = tree_.findReference(reference);
    const bool isClip = clip != noNode && tree_.name(clip) == "clipPath";
    if (isElsewhere(reference))
        report_.add(losses::otherFile);
    else if (!isClip)
        report_.add(losses::missingClipPath);
    else if (std::ranges::find(clipping_, clip) != clipping_.end())
        report_.add(losses::selfClip);
    else
        return addClipArea(clip, boxed, place);
    return false;
}

bool TreeDrawer::addCssClip(std::string_view value, const Boxed& boxed, Place& place)
{
    const auto clip = parseCssClip(value);
    const auto box = clip ? cssBox(clip->box, boxed) : std::nullopt;
    report_.add(losses::clipPathUnits, clip && !box);
    auto shape = box ? cssShape(*clip, *box, place.lengths) : std::nullopt;
    if (!shape) {
        if (!clip || box)
            report_.add(losses::value, "clip-path: " + std::string(value));
        return false;
    }
    std::vector<Subpath> paths = placed({shape->path.subpaths()}, boxed.place.matrix);
    ClipWindows windows;
    if (!paths.empty())
        windows.list.push_back({.shape = PathShape{Path(paths), shape->rule}});
    return addWindows(std::move(windows), place);
}

// The box that a shape of CSS refers to, in the element's own coordinates.
std::optional<Box> TreeDrawer::cssBox(std::string_view name, const Boxed& boxed)
{
    const auto is = [&](auto... names) { return (equalsIgnoringCase(name, names) || ...); };
    if (is("view-box"))
        return Box{{}, boxed.place.lengths.viewport};
    const bool filled = is("fill-box", "content-box", "padding-box");
    return boundsOf(boxed.node, boxed.place, filled ? BoxOf::Fill : BoxOf::Stroke);
}

bool TreeDrawer::addClipArea(Node clip, const Boxed& boxed, Place& place)
{
    Place base = place;
    refuseTooDeep(base);
    base.clips.clear();
    base.properties = inheritedBy(clip);
    base = styled(clip, base);
    clipping_.push_back(clip);
    if (const auto own = base.properties.clipPath; !own.empty())
        addClipPath(own, boxed, base);
    const auto around = std::exchange(base.clips, {});
    std::optional<std::vector<PathShape>> shapes;
    if (turnToBox(tree_.attribute(clip, "clipPathUnits"), boxed, base))
        shapes = clipShapes(clip, base);
    clipping_.pop_back();
    if (!shapes || !addWindows(unitedWindows(std::move(*shapes)), place))
        return false;
    nameClipPath(clip, *place.clips.back(), around);
    place.clips.insert(place.clips.end() - 1, around.begin(), around.end());
    return true;
}

// Keeps the area under the clip path's id.
void TreeDrawer::nameClipPath(Node clip, const ClipArea& area, const ClipAreas& around)
{
    if (!named_.insert(clip).second || tree_.find(tree_.attribute(clip, "id")) != clip)
        return;
    NamedArea named{QString::fromUtf8(tree_.attribute(clip, "id")), {}};
    for (const ClipWindow& window : area.windows.list) {
        std::vector<PathShape> left;
        addCut(std::get<PathShape>(window.shape), around, left);
        for (PathShape& one : left)
            named.windows.push_back({.name = named.id, .shape = std::move(one)});
    }
    clipPaths_.push_back(std::move(named));
}

// If these units are those of the element's box, turns to them. False: the box is not known.
bool TreeDrawer::turnToBox(std::string_view units, const Boxed& boxed, Place& base)
{
    if (units != "objectBoundingBox")
        return true;
    const auto box = boundsOf(boxed.node, boxed.place);
    if (!box) {
        report_.add(losses::clipPathUnits);
        return false;
    }
    base.matrix =
        base.matrix * translation(box->min) * Matrix{box->size.x, 0, 0, box->size.y, 0, 0};
    base.lengths.viewport = {1, 1};
    return true;
}

// The shapes that a clip path unites. Empty: not all of them are known, as it was told.
std::optional<std::vector<PathShape>> TreeDrawer::clipShapes(Node clip, const Place& base)
{
    std::vector<PathShape> shapes;
    if (base.matrix.determinant() == 0)
        return shapes; // in a box without an area
    for (const Node child : Children(tree_, clip)) {
        if (!isDrawn(tree_.name(child)) || !isWanted(child))
            continue;
        report_.turnTo(tree_.line(child));
        if (!addClipShape(child, base, shapes))
            return std::nullopt;
    }
    return shapes;
}

bool TreeDrawer::addClipShape(Node node, const Place& base, std::vector<PathShape>& shapes)
{
    content_.addWork(workOfClipElement);
    Place place = styled(node, base);
    if (tree_.name(node) == "use") {
        const Node target = tree_.findReference(hrefOf(tree_, node));
        report_.add(losses::selfUse, target != noNode && containsItself(node, target));
        if (target == noNode || target == node || !place.properties.displayed)
            return true;
        if (const auto clip = place.properties.clipPath; !clip.empty())
            addClipPath(clip, {node, place}, place);
        place.matrix = place.matrix * translation(shiftOf(node, place));
        place = styled(node = target, place);
    }
    const OutlineKind* kind = findOutlineKind(tree_.name(node));
    const bool shown = place.properties.displayed && place.properties.visible;
    const bool isText = tree_.name(node) == "text";
    if (isText && shown && outlineFonts().isEmpty()) {
        report_.add(losses::clipPathContent, tree_.name(node));
        return false;
    }
    report_.add(losses::notInClipPath, !kind && !isText);
    if (!(kind || isText) || !shown)
        return true;
    if (const auto clip = place.properties.clipPath; !clip.empty())
        addClipPath(clip, {node, place}, place);
    if (isText)
        return addCut({Path(letterPaths(node, place)), FillRule::NonZero}, place.clips, shapes);
    const auto paths = placed(outlineOf(*kind, node, place), place.matrix);
    return addCut({Path(paths), place.properties.clipRule}, place.clips, shapes);
}

// Adds what is left of a shape inside these areas. False: this is not known, as it was told.
bool TreeDrawer::addCut(PathShape shape, const ClipAreas& areas, std::vector<PathShape>& shapes)
{
    auto left = clipped(std::move(shape), areas, page_, content_.work());
    content_.addWork(0);
    report_.add(losses::crossedClipPath, !left);
    if (left && left->path.hasArea())
        shapes.push_back(std::move(*left));
    return left.has_value();
}

bool TreeDrawer::addWindows(ClipWindows windows, Place& place)
{
    const bool fits = windows.list.size() <= ClipWindows::most;
    report_.add(losses::manyClipShapes, !fits);
    if (fits)
        place.clips.push_back(
            std::make_shared<const ClipArea>(ClipArea{std::move(windows), tree_.line(node_)}));
    return fits;
}

// Keeps the areas of clip paths that nothing uses, as they are in the root.
void TreeDrawer::nameOtherClipPaths(const Place& root)
{
    const Report::Silence silence(report_);
    std::size_t count = 0;
    for (Node node = 0; node < tree_.size() && count < mostUnusedClipPaths; ++node)
        if (tree_.name(node) == "clipPath" && !named_.contains(node)
            && !tree_.attribute(node, "id").empty()
            && tree_.attribute(node, "clipPathUnits") != "objectBoundingBox") {
            Place place = root;
            addClipArea(node, {0, root}, place);
            ++count;
        }
}

// What the children of the elements around a clip path inherit.
const Properties& TreeDrawer::inheritedBy(Node node)
{
    const Node parent = tree_.parent(node);
    if (inherited_.first == parent)
        return inherited_.second;
    const Report::Silence silence(report_);
    std::vector<Node> around;
    for (Node each = parent; each != noNode; each = tree_.parent(each))
        around.push_back(each);
    Properties properties;
    Lengths lengths;
    for (auto each = around.rbegin(); each != around.rend(); ++each) {
        properties = styles_.of(*each, properties, lengths);
        lengths.fontSize = properties.fontSize;
    }
    inherited_ = {parent, std::move(properties)};
    return inherited_.second;
}

void TreeDrawer::addViewportClip(const Box& viewport, Place& place)
{
    addWindows({{{.shape = rectangleShape(viewport, place.matrix)}}}, place);
}

} // namespace app::svg
