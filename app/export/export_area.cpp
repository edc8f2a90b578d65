// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_area.h"

#include "app/base/text.h"
#include "app/document/hidden_objects.h"
#include "app/document/window_shape.h"

#include <glm/common.hpp>

#include <array>

namespace app {
namespace {

ClipWindow added(WindowShape shape) { return {.shape = std::move(shape)}; }

bool hasArea(const clipping::Window& box) { return box.min.x < box.max.x && box.min.y < box.max.y; }

QString faultOfWindows(const ExportSource& source, const ExportArea&)
{
    const ClipWindows& windows = source.document.windows();
    if (!cuts(windows))
        return Text::tr("there is no clip window");
    const auto box = boxAround(windows);
    return !box || hasArea(*box) ? QString() : Text::tr("the clip windows keep nothing");
}

QString faultOfPage(const ExportSource&, const ExportArea&) { return {}; }

QString faultOfWindow(const ExportSource& source, const ExportArea& area)
{
    const auto& list = source.document.windows().list;
    if (area.window >= list.size())
        return Text::tr("there is no clip window");
    return hasArea(boxOf(list[area.window].shape)) ? QString() : Text::tr("it has no area");
}

QString faultOfSelection(const ExportSource& source, const ExportArea&)
{
    return source.selection.empty() ? Text::tr("nothing is selected") : QString();
}

QString faultOfLayer(const ExportSource& source, const ExportArea& area)
{
    const Containers& tree = source.document.containers();
    const ContainerId layer = area.layer;
    if (layer == 0 || !tree.contains(layer))
        return Text::tr("there is no such layer");
    if (tree.rangeOf(layer).empty())
        return Text::tr("it is empty");
    return tree.shown(layer) ? QString() : Text::tr("it is hidden");
}

} // namespace

std::optional<clipping::Window> boxAround(const ClipWindows& windows)
{
    const ClipWindows effective = inEffect(windows);
    if (effective.keep == Keep::Outside || effective.list.empty()
        || effective.list.front().operation != WindowOperation::Add)
        return std::nullopt;
    std::optional<clipping::Window> box; // empty: nothing is kept so far
    for (const ClipWindow& window : effective.list) {
        const clipping::Window next = boxOf(window.shape);
        if (window.operation == WindowOperation::Add)
            box = box ? clipping::Window{glm::min(box->min, next.min), glm::max(box->max, next.max)}
                      : next;
        else if (window.operation == WindowOperation::Intersect && box)
            box = clipping::Window{glm::max(box->min, next.min), glm::min(box->max, next.max)};
        if (box && !(box->min.x <= box->max.x && box->min.y <= box->max.y))
            box.reset();
    }
    return box;
}

// THE CATALOGUE of areas.
std::span<const ExportPartInfo> exportParts()
{
    static constexpr std::array all{
        ExportPartInfo{ExportPart::Cut, "cut", QT_TRANSLATE_NOOP("Text", "Cut drawing"),
                       QT_TRANSLATE_NOOP("Text", "What all clip windows together keep"),
                       faultOfWindows},
        ExportPartInfo{ExportPart::Page, "page", QT_TRANSLATE_NOOP("Text", "Page"),
                       QT_TRANSLATE_NOOP("Text", "All that lies on the page, whatever the clip "
                                                 "windows keep"),
                       faultOfPage},
        ExportPartInfo{ExportPart::Window, "window", QT_TRANSLATE_NOOP("Text", "Window"),
                       QT_TRANSLATE_NOOP("Text", "What lies in one clip window"), faultOfWindow},
        ExportPartInfo{ExportPart::Selection, "selection", QT_TRANSLATE_NOOP("Text", "Selection"),
                       QT_TRANSLATE_NOOP("Text", "The selected objects, whole"), faultOfSelection},
        ExportPartInfo{ExportPart::Layer, "layer", QT_TRANSLATE_NOOP("Text", "Layer"),
                       QT_TRANSLATE_NOOP("Text", "The visible objects of a layer, whole"),
                       faultOfLayer},
    };
    return all;
}

QString faultOf(const ExportSource& source, const ExportArea& area)
{
    return exportParts()[std::size_t(area.part)].fault(source, area);
}

ExportArea usableArea(const ExportSource& source, const ExportArea& area)
{
    if (faultOf(source, area).isEmpty())
        return area;
    ExportArea other = area;
    other.part = ExportPart::Cut;
    if (!faultOf(source, other).isEmpty())
        other.part = ExportPart::Page;
    return other;
}

ClipWindows windowsOf(const ExportSource& source, const ExportArea& area)
{
    const ClipWindows& windows = source.document.windows();
    if (area.part == ExportPart::Cut)
        return windows;
    if (area.part == ExportPart::Window)
        return {{added(windows.list.at(area.window).shape)}};
    if (area.part == ExportPart::Page)
        return {{added(RectangleShape{source.document.page().rectangle()})}};
    return {};
}

std::optional<clipping::Window> rectangleOf(const ExportSource& source, const ExportArea& area)
{
    if (area.part == ExportPart::Selection || area.part == ExportPart::Layer)
        return std::nullopt;
    const auto box = boxAround(windowsOf(source, area));
    return box ? box : source.document.page().rectangle();
}

std::optional<ObjectRanges> objectsOf(const ExportSource& source, const ExportArea& area)
{
    const auto seen = [&](const ObjectRanges& objects) {
        return without(objects, hiddenObjects(source.document));
    };
    if (area.part == ExportPart::Selection)
        return seen(source.selection);
    if (area.part == ExportPart::Layer)
        return seen(ObjectRanges(source.document.containers().rangeOf(area.layer)));
    return std::nullopt;
}

} // namespace app
