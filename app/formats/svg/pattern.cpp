// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern becomes the mean colour of its tile.
#include "app/formats/paint_drawing.h"
#include "app/formats/svg/colour_sum.h"
#include "app/formats/svg/page.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/tree_drawer.h"

#include <QImage>

#include <algorithm>

namespace app::svg {
namespace {

constexpr int tilePixels = 64;       // of each side
constexpr int mostPatternLinks = 50; // a pattern may refer to another one
constexpr std::size_t mostPatternsInPatterns = 4;
constexpr std::size_t mostTiles = 1'000; // that are painted; further ones of a pattern look alike

/// The attributes of a pattern; what it does not say, those that it refers to do.
class PatternAttributes {
public:
    PatternAttributes(const Tree& tree, Node node) : tree_(tree)
    {
        while (node != noNode && tree.name(node) == "pattern"
               && std::ranges::count(chain_, node) == 0 && chain_.size() < mostPatternLinks) {
            chain_.push_back(node);
            node = tree.findReference(hrefOf(tree, node));
        }
    }
    std::string_view text(std::string_view name) const
    {
        for (const Node node : chain_)
            if (tree_.hasAttribute(node, name))
                return trimmed(tree_.attribute(node, name));
        return {};
    }
    /// The first of them that has content; noNode: none has.
    Node content() const
    {
        for (const Node node : chain_)
            if (tree_.end(node) > node + 1)
                return node;
        return noNode;
    }

private:
    const Tree& tree_;
    std::vector<Node> chain_;
};

Page pageOfTile()
{
    Page page;
    page.size = Point(tilePixels);
    page.width = page.height = {tilePixels, Unit::Px};
    return page;
}

std::optional<Colour> meanOf(const Document& tile)
{
    QImage image(tilePixels, tilePixels, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    paintOn(image, tile, 1);
    image = image.convertToFormat(QImage::Format_ARGB32);
    ColourSum sum;
    for (int y = 0; y < tilePixels; ++y)
        for (int x = 0; x < tilePixels; ++x) {
            const QRgb c = image.pixel(x, y);
            sum.add({qRed(c) / 255.0, qGreen(c) / 255.0, qBlue(c) / 255.0, qAlpha(c) / 255.0}, 1);
        }
    const Colour mean = sum.mean();
    return mean.alpha > 0 ? std::optional(mean) : std::nullopt;
}

} // namespace

// `box` is that of the painted shape, in its own coordinates, in which `lengths` are, too.
std::optional<Colour> TreeDrawer::patternColour(Node pattern, const Box& box,
                                                const Lengths& lengths)
{
    const PatternAttributes a(tree_, pattern);
    const Node content = a.content();
    const bool ofUser = a.text("patternUnits") == "userSpaceOnUse";
    Lengths units = lengths;
    if (!ofUser)
        units.viewport = {1, 1};
    const Point scale = ofUser ? Point(1) : box.size;
    Box tile{{units.x(a.text("x")).value_or(0), units.y(a.text("y")).value_or(0)},
             {units.x(a.text("width")).value_or(0), units.y(a.text("height")).value_or(0)}};
    tile = {(ofUser ? Point() : box.min) + tile.min * scale, tile.size * scale};
    if (content == noNode || !(tile.size.x > 0 && tile.size.y > 0)
        || std::ranges::count(patterns_, content) > 0 || patterns_.size() >= mostPatternsInPatterns)
        return std::nullopt;
    const auto known = tiles_.find({pattern, tile.size.x, tile.size.y});
    if (known != tiles_.end())
        return known->second;
    const auto like = tiles_.lower_bound({pattern, 0, 0});
    if (tiles_.size() >= mostTiles && like != tiles_.end() && std::get<0>(like->first) == pattern)
        return like->second;

    const Point pixels = Point(tilePixels) / tile.size;
    // All programs draw the content from the corner of the tile.
    Matrix matrix = Matrix{pixels.x, 0, 0, pixels.y, 0, 0};
    if (const auto viewBox = parseViewBox(a.text("viewBox")))
        matrix =
            matrix * viewBoxTransform(*viewBox, {{}, tile.size}, a.text("preserveAspectRatio"));
    else if (a.text("patternContentUnits") == "objectBoundingBox")
        matrix = matrix * Matrix{box.size.x, 0, 0, box.size.y, 0, 0};
    const auto mean = tileColour(content, matrix, lengths);
    tiles_.emplace(TileKey{pattern, tile.size.x, tile.size.y}, mean);
    return mean;
}

std::optional<Colour> TreeDrawer::tileColour(Node pattern, const Matrix& matrix,
                                             const Lengths& lengths)
{
    const Report::Silence silence(report_);
    const auto line = report_.line();
    const Page page = pageOfTile();
    TreeDrawer drawer(tree_, styles_, report_, page, imageSource_.again());
    drawer.patterns_ = patterns_;
    drawer.patterns_.push_back(pattern);
    drawer.repeated_ = repeated_;
    drawer.letters_ = letters_;
    Place place;
    place.properties = inheritedBy(pattern);
    place.lengths = lengths;
    place.repeated = true;
    place.depth = int(patterns_.size());
    place = drawer.styled(pattern, place);
    place.matrix = matrix;
    drawer.drawChildren(pattern, place);
    repeated_ = drawer.repeated_;
    letters_ = drawer.letters_;
    report_.turnTo(line);
    return meanOf(drawer.content_.take({}));
}

} // namespace app::svg
