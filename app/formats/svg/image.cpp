// SPDX-License-Identifier: GPL-3.0-or-later
// Images, which become underlays: each lies below the content of a layer, most often of one of its
// own, at its place among the objects.
#include "app/base/text.h"
#include "app/document/window_shape.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/tree_drawer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app::svg {
namespace {

constexpr std::size_t mostCorners = 1000; // of the area that one of our own images has

/// The corners in "x,y x,y"; empty if the text is not understood.
std::vector<Point> cornersIn(std::string_view text)
{
    std::vector<Point> corners;
    Scanner scanner(text);
    for (scanner.skipBlanks(); !scanner.atEnd(); scanner.skipSeparator()) {
        const auto x = scanner.number();
        scanner.skipSeparator();
        const auto y = x ? scanner.number() : std::nullopt;
        if (!y || corners.size() == mostCorners)
            return {};
        corners.push_back({*x, *y});
    }
    return corners;
}

/// The corners of an area that one convex polygon is; empty: it is another.
std::optional<std::vector<Point>> convexCorners(const ClipWindows& windows)
{
    if (windows.list.size() != 1)
        return std::nullopt;
    const Path path = pathOf(windows.list.front().shape).path;
    if (path.subpathCount() != 1 || !path.straight())
        return std::nullopt;
    const Subpath outline = path.subpaths().front();
    std::vector<Point> corners{outline.start};
    for (const PathSegment& segment : outline.segments)
        if (segment.to != corners.back())
            corners.push_back(segment.to);
    if (corners.size() > 1 && corners.back() == corners.front())
        corners.pop_back();
    double least = 0, most = 0, turned = 0;
    for (std::size_t i = 0, n = corners.size(); i < n; ++i) {
        const Point a = corners[(i + 1) % n] - corners[i];
        const Point b = corners[(i + 2) % n] - corners[(i + 1) % n];
        const double cross = a.x * b.y - a.y * b.x;
        least = std::min(least, cross);
        most = std::max(most, cross);
        turned += std::atan2(cross, a.x * b.x + a.y * b.y);
    }
    constexpr double once = 7; // a little more than 2 pi: a star that winds twice is not convex
    if (corners.size() < 3 || (least < 0 && most > 0) || std::abs(turned) > once)
        return std::nullopt;
    return corners;
}

std::vector<Point> mapped(std::vector<Point> points, const Matrix& matrix)
{
    for (Point& point : points)
        point = matrix(point);
    return points;
}

/// What counts where no size is given; empty: it is lost.
std::optional<Point> sizeOfImage(const ImageSource::Found& found)
{
    constexpr Point usual{300, 150};
    if (const auto* const file = std::get_if<std::shared_ptr<const ImageFile>>(&found))
        return Point((*file)->width, (*file)->height);
    if (const auto* const drawing = std::get_if<std::shared_ptr<const SvgImage>>(&found))
        return (*drawing)->size.x > 0 ? (*drawing)->size : usual;
    return std::nullopt;
}

} // namespace

/// Marks the elements with an image inside, also one that a <use> draws.
void TreeDrawer::findImages()
{
    bool any = false;
    for (std::uint32_t name = 0; name < tree_.nameCount(); ++name)
        any = any || tree_.nameOf(name) == "image";
    if (!any)
        return;
    holdsImage_.resize(tree_.size());
    const auto mark = [&](Node node) {
        for (; node != noNode && !holdsImage_[node]; node = tree_.parent(node))
            holdsImage_[node] = true;
    };
    for (Node node = 0; node < tree_.size(); ++node)
        if (tree_.name(node) == "image")
            mark(node);
    for (Node node = 0; node < tree_.size(); ++node)
        if (tree_.name(node) == "use")
            if (const Node target = tree_.findReference(hrefOf(tree_, node));
                target != noNode && holdsImage_[target])
                mark(node);
}

/// The image with which a layer begins, if the layer can have it as its own: one that is shown.
Node TreeDrawer::firstImage(Node layer) const
{
    for (const Node child : Children(tree_, layer))
        if (isDrawn(tree_.name(child)))
            return tree_.name(child) == "image" ? child : noNode;
    return noNode;
}

void TreeDrawer::drawImage(Node node, const Place& around)
{
    if (node == ownImage_)
        return;
    if (const SvgImage* const drawing = svgImageOf(node))
        return drawSvgImage(node, *drawing, around);
    auto image = imageOf(node, around);
    if (!image)
        return;
    const auto label = tree_.attribute(node, "inkscape:label");
    const Node named = around.repeated ? around.use : node;
    Particulars particulars = named == noNode ? Particulars() : particularsOf(named);
    image->underlay.svgId = particulars.id;
    countImage();
    content_.open(
        {.kind = Container::Kind::Layer,
         .name = label.empty() ? Text::tr("Image %1").arg(images_) : QString::fromUtf8(label),
         .title = std::move(particulars.title),
         .description = std::move(particulars.description),
         .visible = image->shown,
         .locked = true,
         .underlay = std::move(image->underlay)});
    content_.close();
}

/// Takes the first image of a layer as its underlay, so that it is not drawn again.
SharedUnderlay TreeDrawer::takeFirstImage(Node layer, const Place& place)
{
    const Node node = firstImage(layer);
    if (node == noNode || !isWanted(node) || svgImageOf(node))
        return {};
    {
        const Report::Silence silence(report_);
        const Place own = styled(node, place);
        if (own.hidden || !own.properties.visible) // the layer may be shown
            return {};
    }
    const Node before = std::exchange(node_, node);
    report_.turnTo(line());
    auto image = imageOf(node, place);
    node_ = before;
    ownImage_ = node;
    if (!image)
        return {};
    countImage();
    image->underlay.svgId = idOf(node);
    return std::move(image->underlay);
}

const ImageSource::Found& TreeDrawer::findImage(Node node)
{
    return imageSource_.find(hrefOf(tree_, node), report_);
}

/// For the numbers in their names, and the limit.
void TreeDrawer::countImage()
{
    ++images_;
    imageSource_.countDrawn();
}

/// Empty: it cannot be kept, which is told, or nothing of it is seen.
std::optional<TreeDrawer::Image> TreeDrawer::imageOf(Node node, const Place& around)
{
    const auto ownClip = tree_.attribute(node, "clearcut:clip");
    Place place = ownClip.empty() ? inside(node, around) : styled(node, around);
    if (imageSource_.drawn() >= mostImages) {
        report_.add(losses::imageBeyond);
        return std::nullopt;
    }
    const auto& found = findImage(node);
    if (const auto* const lost = std::get_if<const LossKind*>(&found)) {
        report_.add(**lost);
        return std::nullopt;
    }
    const auto& file = std::get<std::shared_ptr<const ImageFile>>(found);
    const Box pixels{{}, {double(file->width), double(file->height)}};
    const auto viewport = imageBox(node, place);
    if (!viewport || place.matrix.determinant() == 0) {
        report_.add(losses::sizeless);
        return std::nullopt;
    }
    reportEffects(place.properties, false);
    report_.add(losses::sharpPixels, place.properties.sharpPixels);
    const auto aspect = tree_.attribute(node, "preserveAspectRatio");
    Image image{{.file = file,
                 .place = mapOf(place.matrix * viewBoxTransform(pixels, *viewport, aspect)),
                 .opacity = place.opacity},
                !place.hidden && place.properties.visible};
    if (!ownClip.empty())
        image.underlay.clip = mapped(cornersIn(ownClip), around.matrix);
    if (parseAspectRatio(aspect).fit == AspectRatio::Fit::Slice)
        cut(image.underlay,
            mapped(cornersOfBox({viewport->min, viewport->min + viewport->size}), place.matrix));
    if (!clipImage(image.underlay, place.clips))
        return std::nullopt;
    if (!std::ranges::all_of(app::outlineOf(image.underlay), [](const Point& p) {
            return std::abs(p.x) < largestCoordinate && std::abs(p.y) < largestCoordinate;
        })) {
        report_.add(losses::sizeless);
        return std::nullopt;
    }
    return image;
}

/// Where an image is drawn, in its own coordinates; empty: it has no size, or cannot be kept.
std::optional<Box> TreeDrawer::imageBox(Node node, const Place& place)
{
    const auto natural = sizeOfImage(findImage(node));
    if (!natural)
        return std::nullopt;
    const Point pixels = *natural;
    const auto size = [&](std::string_view name, double whole) {
        const auto text = lengthText(tree_, node, place.properties, name);
        return trimmed(text) == "auto" ? std::nullopt : place.lengths.parse(text, whole);
    };
    const auto width = size("width", place.lengths.viewport.x);
    const auto height = size("height", place.lengths.viewport.y);
    const Box box{shiftOf(node, place),
                  {width    ? *width
                   : height ? *height * pixels.x / pixels.y
                            : pixels.x,
                   height  ? *height
                   : width ? *width * pixels.y / pixels.x
                           : pixels.y}};
    return box.size.x > 0 && box.size.y > 0 ? std::optional(box) : std::nullopt;
}

bool TreeDrawer::clipImage(Underlay& image, const ClipAreas& areas)
{
    return std::ranges::all_of(areas,
                               [&](const auto& area) { return clipImage(image, area->windows); });
}

/// False: nothing of the image is left. An area that is no convex polygon is told.
bool TreeDrawer::clipImage(Underlay& image, const ClipWindows& windows)
{
    if (windows.list.empty())
        return false;
    const auto corners = convexCorners(windows);
    if (!corners) {
        report_.add(losses::imageUncut);
        return true;
    }
    return cut(image, *corners);
}

} // namespace app::svg
