// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/page.h"

#include "app/document/contents.h"
#include "app/formats/svg/length.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"

#include <array>
#include <cmath>

namespace app::svg {
namespace {

constexpr Length wholeWidth{100, Unit::Percent}; // SVG's default for a missing size

Length readSize(std::string_view name, std::string_view text, Report& report)
{
    const auto length = parseLength(text);
    const auto value = length ? std::optional(length->value) : Lengths{}.parse(text, 1);
    report.add(losses::emptyPage, value && *value <= 0);
    if (!value && !trimmed(text).empty() && !equalsIgnoringCase(trimmed(text), "auto"))
        report.add(losses::value, std::string(name) + ": " + std::string(text));
    if (length && length->value > 0 && infoOf(length->unit).inSvg)
        return length->unit == Unit::User ? Length{length->value, Unit::Px} : *length;
    const auto pixels = Lengths{}.parse(text, 0); // other units such as "30em"
    return pixels && *pixels > 0 ? Length{*pixels, Unit::Px} : wholeWidth;
}

// The difference between paper and view box that is ignored: sizes are written with few decimals.
constexpr double slackMillimetres = 0.01;

// The sheet around a view box, in user units. `pixels` is the sheet's size. If the proportions are
// equal, the sheet is the view box itself, bit for bit.
Box sheetAround(const Box& box, const Point& pixels, const AspectRatio& aspect)
{
    const Point scale = pixels / box.size;
    const bool meet = aspect.fit == AspectRatio::Fit::Meet;
    const int free = (scale.x > scale.y) == meet ? 0 : 1; // the axis on which they differ
    const double size = box.size[1 - free] * (pixels[free] / pixels[1 - free]);
    const double more = size - box.size[free];
    if (!(std::abs(size) <= largestCoordinate)
        || std::abs(more) * scale[1 - free] * pixel <= slackMillimetres)
        return box;
    Box sheet = box;
    sheet.min[free] -= more * aspect.alignment[free];
    sheet.size[free] = size;
    return sheet;
}

void layOut(RootPage& root, const Box& box, const Point& pixels, std::string_view text)
{
    const AspectRatio aspect = parseAspectRatio(text);
    Box sheet = box;
    if (aspect.fit != AspectRatio::Fit::Stretch) {
        sheet = sheetAround(box, pixels, aspect);
    } else { // a page has only one scale, so the matrix scales y against x
        const Point scale = pixels / box.size;
        root.matrix.d = scale.y / scale.x;
        sheet.min.y *= root.matrix.d;
        sheet.size.y *= root.matrix.d;
    }
    root.page.min = sheet.min;
    root.page.size = sheet.size;
}

} // namespace

std::optional<Box> readViewBox(const Tree& tree, Node node, Report& report)
{
    const auto text = tree.attribute(node, "viewBox");
    auto box = parseViewBox(text);
    report.turnTo(tree.line(node));
    report.add(losses::emptyViewBox, !box && !trimmed(text).empty());
    return box;
}

RootPage readPage(const Tree& tree, Styles& styles, Report& report)
{
    constexpr Point usual{300, 150};
    RootPage root;
    const Properties style = [&] { // it is told when the root is drawn
        const Report::Silence silence(report);
        return styles.of(0, {}, {});
    }();
    report.turnTo(tree.line(0));
    root.page.width = readSize("width", lengthText(tree, 0, style, "width"), report);
    root.page.height = readSize("height", lengthText(tree, 0, style, "height"), report);
    const Point pixels{toUserUnits(root.page.width, pixel), toUserUnits(root.page.height, pixel)};
    const auto box = readViewBox(tree, 0, report);
    root.openX = !box && pixels.x <= 0;
    root.openY = !box && pixels.y <= 0;
    root.page.min = box ? box->min : Point{};
    root.page.size =
        box ? box->size : Point{root.openX ? usual.x : pixels.x, root.openY ? usual.y : pixels.y};
    root.viewport = root.page.size;
    if (box && pixels.x > 0 && pixels.y > 0)
        layOut(root, *box, pixels, tree.attribute(0, "preserveAspectRatio"));
    return root;
}

Page closed(const RootPage& root, const Objects& objects)
{
    if (!root.openX && !root.openY)
        return root.page;
    if (objects.empty() && root.openX && root.openY)
        return {};
    Page page = root.page;
    const Point end = pageAround(objects).rectangle().max;
    const auto close = [](double& size, Length& length, double drawn) {
        if (drawn > 0)
            size = drawn;
        length = {size, Unit::Px};
    };
    if (root.openX)
        close(page.size.x, page.width, end.x);
    if (root.openY)
        close(page.size.y, page.height, end.y);
    return page;
}

} // namespace app::svg
