// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/page_steps.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/commands/set_page_parts.h"
#include "app/commands/set_style.h"
#include "app/document/paper.h"
#include "app/document/window_frame.h"
#include "app/document/window_shape.h"
#include "app/formats/svg/style_text.h"
#include "app/scene/bounds.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

Result<Page> refusedSize()
{
    return Result<Page>::failure(
        Text::tr("A page is between 1 mm and 100 m wide and high. Type another size."));
}

bool isPaper(double millimetres) { return millimetres >= leastPaper && millimetres <= mostPaper; }

/// In the unit of the page's width, which files and fields use.
Length paperLength(double millimetres, Unit unit)
{
    const double size = infoOf(unit).millimetres;
    return size > 0 ? Length{millimetres / size, unit} : Length{millimetres, Unit::Mm};
}

void setSize(Page& page, const Point& millimetres)
{
    const double unit = page.millimetresPerUnit();
    page.width = paperLength(millimetres.x, page.width.unit);
    page.height = paperLength(millimetres.y, page.height.unit);
    page.size = millimetres / unit;
}

/// Layers keep the style of their new objects as text.
Containers restyled(Containers tree, double factor)
{
    for (const ContainerId id : tree.inOrder()) {
        Container layer = tree[id];
        auto style = layer.newStyle.isEmpty() ? std::nullopt : svg::styleOf(layer.newStyle);
        if (!style)
            continue;
        scaleStroke(*style, factor);
        layer.newStyle = svg::declarations(*style);
        tree = tree.with(layer);
    }
    return tree;
}

} // namespace

Result<Page> withPaper(Page page, const Point& millimetres)
{
    if (!isPaper(millimetres.x) || !isPaper(millimetres.y))
        return refusedSize();
    setSize(page, millimetres);
    return Result<Page>::of(std::move(page));
}

Result<Page> withEdges(Page page, const clipping::Window& edges)
{
    const Point millimetres = (edges.max - edges.min) * page.millimetresPerUnit();
    if (!isPaper(millimetres.x) || !isPaper(millimetres.y))
        return refusedSize();
    setSize(page, millimetres);
    page.min = edges.min;
    return Result<Page>::of(std::move(page));
}

Page turnedPage(Page page)
{
    std::swap(page.width, page.height);
    std::swap(page.size.x, page.size.y);
    return page;
}

Result<Page> withScale(Page page, double ratio)
{
    if (!(ratio >= DrawingScale::least && ratio <= DrawingScale::most))
        return Result<Page>::failure(
            Text::tr("A scale is between 1 : 0.001 and 1 : 10,000,000. Type another number."));
    if (ratio == page.scale.ratio)
        return Result<Page>::of(std::move(page));
    const auto hasSize = [](const Length& side) { return infoOf(side.unit).millimetres > 0; };
    if (!hasSize(page.width) || !hasSize(page.height)) // else the paper would grow with it
        setSize(page, millimetresOf(page));
    page.size = page.size * ratio / page.scale.ratio;
    page.scale.ratio = ratio;
    return Result<Page>::of(std::move(page));
}

Result<Page> withMargins(Page page, const PaperMargins& margins)
{
    const Point size = millimetresOf(page);
    for (const double side : {margins.left, margins.top, margins.right, margins.bottom})
        if (!(side >= 0 && side <= mostPaper))
            return Result<Page>::failure(Text::tr("A margin is at least 0. Type another number."));
    if (!(margins.left + margins.right < size.x && margins.top + margins.bottom < size.y))
        return Result<Page>::failure(
            Text::tr("The margins leave nothing of the page. Type smaller ones."));
    page.margins = margins;
    return Result<Page>::of(std::move(page));
}

Result<Page> fittedPage(Page page, const std::optional<clipping::Window>& box)
{
    if (!box)
        return Result<Page>::failure(Text::tr("There is nothing to fit the page around."));
    const double unit = page.millimetresPerUnit();
    const PaperMargins& margins = page.margins;
    const Point topLeft(margins.left, margins.top), bottomRight(margins.right, margins.bottom);
    const Point millimetres = (box->max - box->min) * unit + topLeft + bottomRight;
    if (!isPaper(millimetres.x) || !isPaper(millimetres.y))
        return refusedSize();
    setSize(page, millimetres);
    page.min = box->min - topLeft / unit;
    return Result<Page>::of(std::move(page));
}

std::optional<clipping::Window> drawingBox(const Session& session)
{
    return boundsOf(session.scene.lines());
}

std::optional<clipping::Window> windowsBox(const Session& session)
{
    std::optional<clipping::Window> all;
    for (const ClipWindow& window : session.now().windows().list) {
        if (!window.visible || isEmpty(window.shape))
            continue;
        const clipping::Window box = boxOf(frameOf(window.shape));
        all =
            all ? clipping::Window{glm::min(all->min, box.min), glm::max(all->max, box.max)} : box;
    }
    return all;
}

clipping::Window insideOf(const Page& page)
{
    clipping::Window inside = page.rectangle();
    if (page.margins.shown) {
        const double unit = page.millimetresPerUnit();
        inside.min += Point(page.margins.left, page.margins.top) / unit;
        inside.max -= Point(page.margins.right, page.margins.bottom) / unit;
    }
    return inside;
}

/// Adds objects in ascending order, neighbours at once: there may be a million.
class AscendingObjects {
public:
    void add(std::size_t object)
    {
        if (object == last_.end) {
            ++last_.end;
        } else if (object > last_.end || last_.first == last_.end) {
            finish();
            last_ = {object, object + 1};
        }
    }
    ObjectRanges taken()
    {
        finish();
        return std::move(all_);
    }

private:
    void finish()
    {
        if (last_.first < last_.end)
            all_.insert(last_);
    }

    ObjectRanges all_;
    ObjectRange last_{0, 0};
};

static ObjectRanges objectsOutside(const SceneLines& lines, const clipping::Window& inside)
{
    const double slack = 1e-9 * std::max(inside.max.x - inside.min.x, inside.max.y - inside.min.y);
    const auto isOutside = [&](const Point& p) {
        return !(p.x >= inside.min.x - slack && p.y >= inside.min.y - slack
                 && p.x <= inside.max.x + slack && p.y <= inside.max.y + slack);
    };
    AscendingObjects outside;
    for (std::size_t run = 0; run < lines.runs().size(); ++run) {
        const SceneLines::Run& part = lines.runs()[run];
        const bool lineEach = lines.blocks()[run]->firstOfObject.empty();
        for (std::size_t i = 0; i < part.segments.size(); ++i)
            if (const auto& [a, b] = part.segments[i]; isOutside(a) || isOutside(b))
                outside.add(lineEach ? part.firstObject + i : lines.objectOf(part.firstLine + i));
    }
    return outside.taken();
}

static QString checkText(std::size_t all, std::size_t outside, bool margins)
{
    const QString count = countText(outside == 0 ? all : outside);
    if (outside == 0 && margins)
        return all == 1 ? Text::tr("The object lies inside the margins.")
                        : Text::tr("All %1 objects lie inside the margins.").arg(count);
    if (outside == 0)
        return all == 1 ? Text::tr("The object lies on the page.")
                        : Text::tr("All %1 objects lie on the page.").arg(count);
    if (margins)
        return outside == 1 ? Text::tr("1 object lies outside the margins.")
                            : Text::tr("%1 objects lie outside the margins.").arg(count);
    return outside == 1 ? Text::tr("1 object lies outside the page.")
                        : Text::tr("%1 objects lie outside the page.").arg(count);
}

PageCheck checkedPage(const Session& session)
{
    const SceneLines& lines = session.scene.lines();
    const Page& page = session.now().page();
    const auto drawn = boundsOf(lines);
    if (!drawn)
        return {};
    const clipping::Window inside = insideOf(page);
    const auto& [min, max] = *drawn;
    const bool fits = min.x >= inside.min.x && min.y >= inside.min.y && max.x <= inside.max.x
                      && max.y <= inside.max.y;
    PageCheck check;
    if (!fits)
        check.outside = objectsOutside(lines, inside);
    check.text =
        checkText(session.now().objects().size(), check.outside.size(), page.margins.shown);
    return check;
}

PageEditing::PageEditing(Session& session) : session_(session), before_(session.now().page()) {}

bool PageEditing::isLastStep() const
{
    const History& history = session_.history;
    return step_ && history.canUndo() && history.stepsDone() == stepsDone_
           && &history.command(history.index() - 1) == step_;
}

std::optional<QString> PageEditing::change(const Result<Page>& page)
{
    if (!page)
        return page.error;
    if (*page.value == session_.now().page())
        return std::nullopt;
    if (isLastStep())
        session_.history.undo(); // the new step takes its place
    step_ = nullptr;
    const Document& now = session_.now();
    if (*page.value == now.page())
        return std::nullopt;
    const double factor = now.page().millimetresPerUnit() / page.value->millimetresPerUnit();
    std::optional<Containers> containers;
    if (factor != 1)
        containers = restyled(now.containers(), factor);
    auto* step = new ChangePage(session_.document, *page.value, std::move(containers));
    session_.history.push(step);
    step_ = step;
    stepsDone_ = session_.history.stepsDone();
    return std::nullopt;
}

void PageEditing::cancel()
{
    if (isLastStep())
        return session_.history.undo();
    Page before = before_;
    before.guides = session_.now().page().guides;
    before.sheets = session_.now().page().sheets;
    change(Result<Page>::of(std::move(before)));
}

} // namespace app
