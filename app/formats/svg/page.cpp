// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/page.h"

#include "app/formats/number.h"
#include "app/formats/svg/length.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"

#include <array>
#include <cmath>

namespace app::svg {
namespace {

constexpr Length everything{100, Unit::Percent}; // what SVG takes where there is no size

Length readSize(std::string_view text)
{
    const auto length = parseLength(text);
    if (length && length->value > 0)
        return length->unit == Unit::User ? Length{length->value, Unit::Px} : *length;
    const auto pixels = Lengths{}.parse(text, 0); // "30em"
    return pixels && *pixels > 0 ? Length{*pixels, Unit::Px} : everything;
}

// How the viewport stretches the view box, beyond what a page can say: y against x.
double unevenness(const RootPage& root, const Point& pixels, std::string_view aspect)
{
    if (root.unsized || !trimmed(aspect).starts_with("none") || pixels.x <= 0 || pixels.y <= 0)
        return 1;
    const Point scale = pixels / root.page.size;
    return scale.y / scale.x;
}

} // namespace

RootPage readPage(const Tree& tree)
{
    RootPage root;
    root.page.width = readSize(tree.attribute(0, "width"));
    root.page.height = readSize(tree.attribute(0, "height"));
    const Point pixels{toUserUnits(root.page.width, pixel), toUserUnits(root.page.height, pixel)};
    const auto box = parseViewBox(tree.attribute(0, "viewBox"));
    root.unsized = !box && (pixels.x <= 0 || pixels.y <= 0);
    root.page.min = box ? box->min : Point{};
    root.page.size = box ? box->size : root.unsized ? Point{300, 150} : pixels;
    const double stretch = unevenness(root, pixels, tree.attribute(0, "preserveAspectRatio"));
    if (stretch != 1) {
        root.matrix.d = stretch;
        root.page.min.y *= stretch;
        root.page.size.y *= stretch;
    }
    return root;
}

std::optional<clipping::Window> readWindow(const Tree& tree)
{
    for (const Node metadata : Children(tree, 0)) {
        if (tree.name(metadata) != "metadata")
            continue;
        for (const Node node : Children(tree, metadata)) {
            if (tree.name(node) != "clearcut:window")
                continue;
            const auto number = [&](std::string_view name) {
                const auto read = parseNumber(tree.attribute(node, name));
                return read && std::abs(*read) <= largestCoordinate ? read : std::nullopt;
            };
            const std::array v{number("xmin"), number("ymin"), number("xmax"), number("ymax")};
            if (v[0] && v[1] && v[2] && v[3] && *v[0] <= *v[2] && *v[1] <= *v[3])
                return clipping::Window{{*v[0], *v[1]}, {*v[2], *v[3]}};
        }
    }
    return std::nullopt;
}

} // namespace app::svg
