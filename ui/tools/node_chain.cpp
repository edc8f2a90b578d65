// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/node_chain.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

#include <algorithm>

namespace ui {
namespace {

constexpr double closingMark = 5.5; // pixels

int stepsDone(const Workbench& bench)
{
    return bench.session.history.forgotten() + bench.session.history.index();
}

} // namespace

void ChainTool::press(const Pointer& pointer, Workbench& bench)
{
    const app::Point next = pointer.position;
    if (closesAt(next, bench))
        finish(bench, true);
    else if (nodes_.empty() || next != nodes_.back().at)
        add(next);
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
        end(bench);
    else if (event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Delete)
        takeBack(bench);
    else
        return false;
    return true;
}

void ChainTool::cancel(Workbench&)
{
    nodes_.clear();
    takenBack_.clear();
}

void ChainTool::takeBack(Workbench& bench)
{
    takenBack_.push_back(nodes_.back());
    nodes_.pop_back();
    stepsBefore_ = stepsDone(bench);
}

// When all nodes are removed, Undo goes on with the history; those steps must be redone before the
// nodes return.
bool ChainTool::canPutBack(const Workbench& bench) const
{
    return !takenBack_.empty() && (!nodes_.empty() || stepsDone(bench) == stepsBefore_);
}

void ChainTool::putBack(Workbench&)
{
    nodes_.push_back(takenBack_.back());
    takenBack_.pop_back();
}

std::optional<app::Gauge> ChainTool::gauge(const Workbench& bench) const
{
    return nodes_.empty() ? gaugeOfStart(bench)
                          : gaugeFrom(nodes_.back().at, app::lengthAndAngle(), bench);
}

void ChainTool::accept(const app::GestureEnd& end, Workbench&)
{
    if (nodes_.empty() || end.point != nodes_.back().at)
        add(end.point);
}

std::optional<app::Subpath> ChainTool::pendingPath() const
{
    return nodes_.size() >= 2 ? std::optional(pathOf(false)) : std::nullopt;
}

QString ChainTool::hint(const Workbench& bench) const
{
    return to_ && closesAt(*to_, bench)
               ? QCoreApplication::translate("Tools", "Click to close the path.")
               : QString();
}

void ChainTool::paint(QPainter& painter, const Workbench& bench) const
{
    if (nodes_.empty())
        return;
    app::Subpath path = pathOf(closes());
    if (to_ && showsNext()) {
        const Node& last = nodes_.back();
        path.segments.push_back(last.out == last.at ? app::PathSegment{*to_}
                                                    : app::PathSegment{*to_, last.out, *to_, true});
    }
    paintPath(painter, bench, path);
    std::vector<app::Point> places;
    for (const Node& node : nodes_)
        places.push_back(node.at);
    markPoints(painter, bench, places);
    if (to_ && closesAt(*to_, bench))
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

app::Subpath ChainTool::pathOf(bool closed) const
{
    app::Subpath path{nodes_.front().at, {}, closed};
    const auto join = [&path](const Node& from, const Node& to) {
        const bool straight = from.out == from.at && to.in == to.at;
        path.segments.push_back(straight ? app::PathSegment{to.at}
                                         : app::PathSegment{to.at, from.out, to.in, true});
    };
    for (std::size_t i = 1; i < nodes_.size(); ++i)
        join(nodes_[i - 1], nodes_[i]);
    const bool curved =
        nodes_.back().out != nodes_.back().at || nodes_.front().in != nodes_.front().at;
    if (closed && curved) // otherwise the line back needs no segment
        join(nodes_.back(), nodes_.front());
    return path;
}

void ChainTool::finish(Workbench& bench, bool closed)
{
    std::optional<app::Subpath> drawn;
    if (nodes_.size() >= 2)
        drawn = pathOf(closed);
    cancel(bench);
    if (drawn)
        keep(std::move(*drawn), bench);
}

} // namespace ui
