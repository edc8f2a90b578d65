// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/tree_drawer.h"

#include "app/base/text.h"
#include "app/document/recipe_outline.h"
#include "app/formats/svg/element_transform.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/path_length.h"
#include "app/formats/svg/recipe_text.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/undrawn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace app::svg {
namespace {

// Elements that other programs draw and Clearcut cannot keep.
struct Foreign {
    std::string_view element;
    const LossKind* loss;
};
constexpr std::array foreigners{
    Foreign{"flowRoot", &losses::text},
    Foreign{"foreignObject", &losses::foreignObject},
    Foreign{"html:video", &losses::foreignObject},
    Foreign{"html:iframe", &losses::foreignObject},
    Foreign{"html:canvas", &losses::foreignObject},
    Foreign{"animate", &losses::animation},
    Foreign{"animateTransform", &losses::animation},
    Foreign{"animateMotion", &losses::animation},
    Foreign{"animateColor", &losses::animation},
    Foreign{"set", &losses::animation},
    Foreign{"script", &losses::script},
    Foreign{"html:script", &losses::script},
};

const Foreign* findForeign(std::string_view element)
{
    const auto found = std::ranges::find(foreigners, element, &Foreign::element);
    return found == foreigners.end() ? nullptr : &*found;
}

bool isFinitePath(const Subpath& path)
{
    const auto small = [](const Point& p) {
        return std::abs(p.x) <= largestCoordinate && std::abs(p.y) <= largestCoordinate;
    };
    return small(path.start) && std::ranges::all_of(path.segments, [&](const PathSegment& segment) {
               return small(segment.to) && small(segment.control1) && small(segment.control2);
           });
}

constexpr std::string_view extensionAttribute = "requiredExtensions",
                           languageAttribute = "systemLanguage";

// Whether "de, en-GB" names English.
bool namesEnglish(std::string_view languages)
{
    for (languages = trimmed(languages); !languages.empty(); languages = trimmed(languages)) {
        const auto one = trimmed(languages.substr(0, languages.find(',')));
        if (equalsIgnoringCase(one, "en") || equalsIgnoringCase(one.substr(0, 3), "en-"))
            return true;
        languages.remove_prefix(std::min(languages.find(','), languages.size() - 1) + 1);
    }
    return false;
}

bool enclosesArea(const std::vector<Subpath>& paths)
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
        Row{"text", &TreeDrawer::drawText},       Row{"image", &TreeDrawer::drawImage},
    };
    const auto found = std::ranges::find(all, element, &Row::element);
    return found == all.end() ? nullptr : &*found;
}

bool TreeDrawer::isDrawn(std::string_view element) { return find(element) || findForeign(element); }

TreeDrawer::TreeDrawer(const Tree& tree, Styles& styles, Report& report, const Page& page,
                       ImageSource images)
    : tree_(tree), report_(report), styles_(styles),
      paints_(tree, styles, report,
              [this](Node pattern, const Box& box, const Lengths& lengths) {
                  return patternColour(pattern, box, lengths);
              }),
      page_(page), content_(page, usualTolerance(page), tree.textSize(), report),
      imageSource_(std::move(images)), idIsTaken_(tree.size())
{
    for (std::uint32_t name = 0; name < tree.nameCount(); ++name)
        hasConditions_ = hasConditions_ || tree.nameOf(name) == extensionAttribute
                         || tree.nameOf(name) == languageAttribute;
    findImages();
}

Document TreeDrawer::drawAll(const Matrix& rootMatrix, const Point& viewport)
{
    Place place;
    place.matrix = rootMatrix;
    place.lengths.viewport = viewport;
    place.lengths.screen = {toUserUnits(page_.width, pixel), toUserUnits(page_.height, pixel)};
    return drawRoot(std::move(place));
}

Document TreeDrawer::drawRoot(Place place)
{
    report_.turnTo(line());
    reportRootConditions();
    idOf(0); // reserves the root's id
    place = inside(0, place);
    place.lengths.rootFontSize = place.properties.fontSize;
    drawChildren(0, place);
    if (imageSource_.depth() == 0)
        nameOtherClipPaths(place);
    report_.turnTo(0);
    report_.add(losses::metadata, tree_.saysTooMuch() ? 1 : 0);
    report_.add(losses::elementNote, tree_.notesOfElements() - notesKept_);
    return content_.take(tree_.about());
}

void TreeDrawer::refuseTooDeep(const Place& around)
{
    if (around.depth > deepestNesting)
        throw Refused{
            Text::tr("nests elements deeper than %1; ungroup some of them.").arg(deepestNesting)};
}

void TreeDrawer::draw(Node node, const Place& around)
{
    node_ = node;
    report_.turnTo(line());
    refuseTooDeep(around);
    if ((around.repeated || imageSource_.depth() > 0) && ++repeated_ > mostRepeated)
        throw Refused{
            Text::tr("exceeds the limit of %1 elements repeated by <use>.").arg(mostRepeated)};
    const auto name = tree_.name(node);
    if (!isDrawn(name) && !isUndrawn(name))
        report_.add(losses::unknownElement, name);
    if (!isDrawn(name) || !isWanted(node))
        return;
    if (const Row* row = find(name))
        (this->*row->draw)(node, around);
    else
        report_.add(*findForeign(name)->loss);
}

// Whether an element's conditions hold: it is for English, and needs no extension.
bool TreeDrawer::isWanted(Node node)
{
    if (!hasConditions_)
        return true;
    const bool isExtended = !trimmed(tree_.attribute(node, extensionAttribute)).empty();
    const bool isForeign = tree_.hasAttribute(node, languageAttribute)
                           && !namesEnglish(tree_.attribute(node, languageAttribute));
    report_.add(losses::extension, isExtended);
    report_.add(losses::language, isForeign && !isExtended);
    return !isExtended && !isForeign;
}

// Those of the whole drawing do not keep it from being read.
void TreeDrawer::reportRootConditions()
{
    const bool wanted = [&] {
        const Report::Silence silence(report_);
        return isWanted(0);
    }();
    report_.add(losses::rootCondition, !wanted);
}

void TreeDrawer::drawChildren(Node node, const Place& place)
{
    for (const Node child : Children(tree_, node))
        draw(child, place);
}

Place TreeDrawer::inside(Node node, const Place& around)
{
    Place place = styled(node, around);
    if (!place.properties.clipPath.empty())
        addClipPath(place.properties.clipPath, {node, place}, place);
    if (!place.properties.mask.empty())
        addMask({node, place}, place);
    return place;
}

Place TreeDrawer::styled(Node node, const Place& around)
{
    Place place = around;
    place.properties = styles_.of(node, around.properties, around.lengths);
    place.lengths.fontSize = place.properties.fontSize;
    place.opacity *= place.properties.opacity;
    place.hidden = place.hidden || !place.properties.displayed;
    place.use = noNode;
    ++place.depth;
    if (!isPlain(place.properties.transform))
        transform(node, place);
    return place;
}

void TreeDrawer::transform(Node node, Place& place)
{
    const TransformTexts& texts = place.properties.transform;
    Box box{{}, place.lengths.viewport};
    if (refersToBounds(texts)) {
        const auto bounds = boundsOf(node, place);
        report_.add(losses::unknownBox, !bounds);
        box = bounds.value_or(box);
    }
    if (const auto matrix = matrixOf(texts, place.lengths, box))
        place.matrix = place.matrix * *matrix;
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
        drawContainer(node,
                      isLayer || holdsImage(node) ? Container::Kind::Layer : Container::Kind::Group,
                      place, around);
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
    SharedUnderlay image;
    if (kind == Container::Kind::Layer && holdsImage(node))
        image = takeFirstImage(node, place);
    content_.open({.kind = kind,
                   .name = QString::fromUtf8(name),
                   .svgId = std::move(particulars.id),
                   .title = std::move(particulars.title),
                   .description = std::move(particulars.description),
                   .newStyle = QString::fromUtf8(tree_.attribute(node, "clearcut:new-objects")),
                   .visible = place.properties.displayed,
                   .locked = tree_.attribute(node, "sodipodi:insensitive") == "true",
                   .underlay = std::move(image)});
    drawChildren(node, place);
    content_.close();
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

// Draws the first child whose conditions hold.
void TreeDrawer::drawSwitch(Node node, const Place& around)
{
    const Place place = inside(node, around);
    reportEffects(place.properties, true);
    if (const Node chosen = chosenOf(node); chosen != noNode)
        draw(chosen, place);
}

// The child of a <switch> that is drawn: the first whose conditions hold; a later one in place of
// one that cannot be kept, such as a foreign object. noNode: none.
Node TreeDrawer::chosenOf(Node node)
{
    Node chosen = noNode;
    bool kept = false;
    for (const Node child : Children(tree_, node)) {
        const auto name = tree_.name(child);
        if (!isDrawn(name))
            continue;
        report_.turnTo(tree_.line(child));
        if (!isWanted(child) || kept)
            continue;
        const bool keeps = find(name) != nullptr;
        report_.add(losses::replacedForeign, chosen != noNode && keeps);
        if (chosen == noNode || keeps)
            chosen = child;
        kept = keeps;
    }
    return chosen;
}

void TreeDrawer::drawOutline(Node node, const Place& around)
{
    Place place = inside(node, around);
    Properties& properties = place.properties;
    const OutlineKind* kind = findOutlineKind(tree_.name(node));
    Outline outline = outlineOf(*kind, node, place);
    scaleDashes(node, outline, properties);
    const bool marked = hasMarkers(properties);
    const auto vertices = marked ? markerVertices(outline) : std::vector<MarkerVertex>();
    const Recipe own = mapped(outline.recipe, mapOf(place.matrix));
    Drawn drawn{placed(std::move(outline), place.matrix)};
    if (!drawn.paths.empty() && place.matrix.determinant() == 0) {
        report_.add(losses::sizeless);
        return;
    }
    if (drawn.paths.empty())
        return;
    reportEffects(properties, false);
    reportMissingMarkers(properties);
    const Node named = place.repeated ? around.use : node;
    Particulars particulars = named == noNode ? Particulars() : particularsOf(named);
    particulars.recipe = readRecipe(tree_.attribute(node, "clearcut:recipe"), drawn.paths);
    if (particulars.recipe.index() == 0 && own.index() != 0 && makes(own, drawn.paths))
        particulars.recipe = own;
    const bool grouped = marked && !place.repeated;
    if (grouped)
        content_.open({.kind = Container::Kind::Group});
    addShape(std::move(drawn), place, std::move(particulars), vertices);
    if (grouped)
        content_.close();
}

void TreeDrawer::reportMissingMarkers(const Properties& p)
{
    for (const auto reference : {p.markerStart, p.markerMid, p.markerEnd})
        report_.add(losses::marker,
                    !reference.empty() && !isMarker(tree_.findReference(reference)));
}

void TreeDrawer::addShape(Drawn drawn, const Place& place, Particulars particulars,
                          const std::vector<MarkerVertex>& markers)
{
    Properties properties = place.properties;
    const std::vector<Subpath>& paths = drawn.paths;
    if (!enclosesArea(paths))
        properties.fill = {}; // the writer leaves out such a fill, too
    const double pixelsPerUnit = pixel / page_.millimetresPerUnit();
    const StrokeScale scale = properties.fixedWidth ? StrokeScale{pixelsPerUnit, pixelsPerUnit}
                                                    : strokeScale(place.matrix, paths);
    Object object{Path(paths), {}};
    object.style =
        paints_.style(properties, place.opacity, scale, {paths, place.matrix, place.lengths});
    if (properties.longDashes)
        report_.add(losses::longDashes);
    report_.add(losses::unevenStroke,
                object.style.stroke
                    && !(scale.even && (scale.round() || object.style.cap == Cap::Butt)));
    object.hidden = place.hidden || !properties.visible;
    object.particulars = std::move(particulars);
    paintInOrder(std::move(object), place, markers);
}

// An object is painted with its stroke over its fill, and without markers. In other orders its
// stroke becomes an object of its own.
void TreeDrawer::paintInOrder(Object object, const Place& place,
                              const std::vector<MarkerVertex>& markers)
{
    const PaintOrder& order = place.properties.paintOrder;
    const auto placeOf = [&](PaintPart part) { return std::ranges::find(order, part); };
    const auto fill = placeOf(PaintPart::Fill), stroke = placeOf(PaintPart::Stroke);
    const bool between = !markers.empty() && placeOf(PaintPart::Markers) == fill + 1;
    const bool apart = object.style.fill && object.style.stroke && (stroke < fill || between);
    report_.add(losses::strokeBelow, apart && stroke < fill);
    report_.add(losses::strokeApart, apart && stroke > fill);
    bool isAdded = false;
    for (const PaintPart part : order) {
        if (part == PaintPart::Markers) {
            drawMarkers(markers, place);
        } else if (apart) {
            Object piece = object;
            (part == PaintPart::Fill ? piece.style.stroke : piece.style.fill).reset();
            if (!isAdded)
                piece.particulars = {};
            content_.add(std::move(piece), place.clips);
            isAdded = true;
        } else if (!isAdded
                   && (part == PaintPart::Stroke || object.style.fill || !object.style.stroke)) {
            content_.add(std::move(object), place.clips);
            isAdded = true;
        }
    }
}

Outline TreeDrawer::outlineOf(const OutlineKind& kind, Node node, const Place& place)
{
    Outline outline = kind.outline(tree_, node, place.properties, place.lengths);
    report_.add(losses::damaged, outline.damaged);
    report_.add(losses::sizeless, outline.sizeless);
    return outline;
}

// The attribute pathLength says how long the path counts for dashes.
void TreeDrawer::scaleDashes(Node node, const Outline& outline, Properties& properties)
{
    const auto text = tree_.attribute(node, "pathLength");
    if (text.empty() || properties.dashes.empty())
        return;
    const auto length = Lengths().parse(text, 0);
    if (!length || *length < 0) {
        report_.add(losses::value, "pathLength: " + std::string(text));
        return;
    }
    const double scale = lengthOf(outline.paths) / *length;
    if (!(scale <= largestCoordinate)) { // of length 0: the first dash never ends
        properties.dashes.clear();
        return;
    }
    properties.dashOffset *= scale;
    for (double& dash : properties.dashes)
        dash *= scale;
}

std::vector<Subpath> TreeDrawer::placed(Outline outline, const Matrix& matrix)
{
    for (Subpath& path : outline.paths) {
        svg::transform(path, matrix);
        if (!isFinitePath(path))
            throw Refused{Text::tr("has a coordinate that is too large to be drawn.")};
    }
    return std::move(outline.paths);
}

} // namespace app::svg
