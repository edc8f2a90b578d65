// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/node_chain.h"

#include "ui/look/text.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace ui {
namespace {

constexpr double closingMark = 5.5; // pixels

} // namespace

void ChainTool::press(const Pointer& pointer, Workbench& bench)
{
    const bool corrected = corrects();
    if (corrected)
        cancel(bench); // a click ends the correction
    const app::Point next = corrected ? pointer.steered : pointer.position;
    if (closesAt(next, bench))
        finish(bench, true);
    else if (nodes_.empty() || next != nodes_.back().at)
        add(next);
    else
        emit bench.session.refused(
            Text::tr("The last point is already here. Click another place, or press Enter."));
    to_ = next;
}

/// Before the command Delete, which is for the selection.
bool ChainTool::wants(const QKeyEvent& event, const Workbench&) const
{
    return !nodes_.empty() && (event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Delete);
}

bool ChainTool::key(QKeyEvent& event, Workbench& bench)
{
    if (nodes_.empty())
        return false;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        complete(bench);
    else if (event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Delete)
        takeBack(bench);
    else
        return false;
    return true;
}

void ChainTool::complete(Workbench& bench)
{
    if (nodes_.size() == 1 && !corrects())
        emit bench.session.refused(
            Text::tr("One point is not a path, so nothing was drawn. Click two places or more."));
    end(bench);
}

void ChainTool::cancel(Workbench& bench)
{
    nodes_.clear();
    takenBack_.clear();
    last_.restore(bench);
}

void ChainTool::takeBack(Workbench& bench)
{
    takenBack_.push_back(nodes_.back());
    nodes_.pop_back();
    stepsBefore_ = bench.session.history.stepsDone();
}

// When all nodes are removed, Undo goes on with the history; those steps must be redone before the
// nodes return.
bool ChainTool::canPutBack(const Workbench& bench) const
{
    return !takenBack_.empty()
           && (!nodes_.empty() || bench.session.history.stepsDone() == stepsBefore_);
}

void ChainTool::putBack(Workbench&)
{
    nodes_.push_back(takenBack_.back());
    takenBack_.pop_back();
}

std::optional<app::Gauge> ChainTool::gauge(const Workbench& bench) const
{
    if (nodes_.empty())
        return gaugeOfStart(bench);
    app::Gauge gauge = gaugeFrom(nodes_.back().at, app::lengthAndAngle(), bench);
    if (corrects()) {
        const app::Point& was = done_.back().at;
        gauge.aim = app::GestureEnd{was, gauge.measure->values(gauge.start, was)};
    }
    return gauge;
}

void ChainTool::accept(const app::GestureEnd& end, Workbench& bench)
{
    if (corrects()) {
        nodes_ = corrected(end.point);
        last_.discard();
        finish(bench, false);
    } else if (nodes_.empty() || end.point != nodes_.back().at) {
        add(end.point);
    }
}

/// Without its last node, which numbers then put elsewhere.
void ChainTool::reopen(Workbench& bench)
{
    if (!last_.reopen(bench))
        return;
    nodes_ = done_;
    nodes_.pop_back();
}

/// The nodes of the last path, with the last one and its handles moved.
std::vector<ChainTool::Node> ChainTool::corrected(const app::Point& to) const
{
    std::vector<Node> nodes = done_;
    const Node last = nodes.back();
    const auto moved = [&](const app::Point& handle) {
        return handle == last.at ? to : to + (handle - last.at); // none stays none
    };
    nodes.back() = {to, moved(last.in), moved(last.out)};
    return nodes;
}

std::optional<app::ObjectInHand> ChainTool::unfinished(const Workbench& bench) const
{
    if (nodes_.size() < 2 || corrects())
        return std::nullopt;
    return inHand(bench, pathOf(nodes_, false));
}

QString ChainTool::hint(const Workbench& bench) const
{
    return to_ && !corrects() && closesAt(*to_, bench) ? Text::tr("Click to close the path.")
                                                       : QString();
}

void ChainTool::paint(QPainter& painter, const Workbench& bench) const
{
    if (nodes_.empty())
        return;
    app::Subpath path =
        corrects() && to_ ? pathOf(corrected(*to_), false) : pathOf(nodes_, closes(bench));
    if (to_ && showsNext() && !corrects()) {
        const Node& last = nodes_.back();
        path.segments.push_back(last.out == last.at ? app::PathSegment{*to_}
                                                    : app::PathSegment{*to_, last.out, *to_, true});
    }
    paintPath(painter, bench, path);
    std::vector<app::Point> places;
    for (const Node& node : nodes_)
        places.push_back(node.at);
    markPoints(painter, bench, places);
    if (to_ && !corrects() && closesAt(*to_, bench))
        painter.drawEllipse(bench.onScreen(nodes_.front().at), closingMark, closingMark);
}

void ChainTool::paintPath(QPainter& painter, const Workbench& bench, const app::Subpath& path) const
{
    preview(painter, bench, path);
}

void ChainTool::keep(app::Subpath path, Workbench& bench)
{
    draw(bench, {std::move(path)}, undoText());
}

void ChainTool::add(const app::Point& at)
{
    nodes_.push_back({at, at, at});
    takenBack_.clear();
    last_.forget();
}

bool ChainTool::closesAt(const app::Point& point, const Workbench& bench) const
{
    return nodes_.size() >= (isCurved() ? 2U : 3U)
           && glm::distance(point, nodes_.front().at) <= bench.inDrawing(reach);
}

bool ChainTool::isCurved() const
{
    return std::ranges::any_of(nodes_, [](const Node& n) { return n.in != n.at || n.out != n.at; });
}

app::Subpath ChainTool::pathOf(std::span<const Node> nodes, bool closed)
{
    app::Subpath path{nodes.front().at, {}, closed};
    const auto join = [&path](const Node& from, const Node& to) {
        const bool straight = from.out == from.at && to.in == to.at;
        path.segments.push_back(straight ? app::PathSegment{to.at}
                                         : app::PathSegment{to.at, from.out, to.in, true});
    };
    for (std::size_t i = 1; i < nodes.size(); ++i)
        join(nodes[i - 1], nodes[i]);
    const bool curved = nodes.back().out != nodes.back().at || nodes.front().in != nodes.front().at;
    if (closed && curved) // otherwise the line back needs no segment
        join(nodes.back(), nodes.front());
    return path;
}

void ChainTool::finish(Workbench& bench, bool closed)
{
    std::vector<Node> nodes = std::move(nodes_);
    cancel(bench);
    if (nodes.size() < 2)
        return;
    keep(pathOf(nodes, closed), bench);
    if (closed)
        return; // its last segment leads to a node that is there already
    done_ = std::move(nodes);
    last_.remember(bench);
}

} // namespace ui
