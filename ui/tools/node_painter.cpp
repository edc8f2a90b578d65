// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/node_painter.h"

#include "app/document/flatten.h"
#include "app/nodes/node_types.h"
#include "ui/tools/line_on_screen.h"

#include <QSet>

#include <cmath>

namespace ui {
namespace {

constexpr double nodeSize = 9, handleSize = 7, growth = 2, margin = 1.75; // pixels
constexpr double arrowLength = 14, arrowHead = 4, arrowOffset = 13;
constexpr std::size_t mostShapes = 2000, mostArrows = 200, mostSegments = 4000;
constexpr int cell = 6;            // pixels: of very many nodes, one in each cell
constexpr double beyond = 64;      // pixels around the canvas that are painted too
constexpr double chordError = 0.2; // pixels

class NodePainter {
public:
    NodePainter(QPainter& painter, const Workbench& bench) : painter_(painter), bench_(bench) {}

    void nodes(const app::NodePath& path, const HoveredNode& hovered)
    {
        std::vector<app::NodeAddress> visible;
        for (std::size_t s = 0; s < path.size(); ++s)
            for (std::size_t i = 0; i < path[s].nodes.size(); ++i)
                if (seen(bench_.onScreen(path[s].nodes[i].at)))
                    visible.push_back({s, i});
        if (visible.size() > mostShapes)
            return dots(path, visible);
        for (const bool selected : {false, true}) // selected ones above the others
            for (const app::NodeAddress& address : visible)
                if (path[address.subpath].nodes[address.node].selected == selected)
                    node(path[address.subpath].nodes[address.node], hovered.node == address);
    }
    void handles(const app::NodePath& path, const HoveredNode& hovered)
    {
        for (const app::ShownHandle& handle : handlesOf(path, bench_)) {
            const app::Point& from = path[handle.node.subpath].nodes[handle.node.node].at;
            painter_.setPen(QPen(blue(), 1));
            if (const auto line = lineOnScreen({from, handle.at}, bench_))
                painter_.drawLine(*line);
            const QPointF at = bench_.onScreen(handle.at);
            if (!seen(at))
                continue;
            const bool under = hovered.handle && hovered.handle->node == handle.node
                               && hovered.handle->side == handle.side;
            const double radius = handleSize / 2 + (under ? growth / 2 : 0);
            painter_.setPen(QPen(blue(), 1.25));
            painter_.setBrush(handle.neighbours ? bench_.look.paper : blue());
            painter_.drawEllipse(at, radius, radius);
        }
    }
    void arrows(const app::NodePath& path)
    {
        for (std::size_t s = 0; s < std::min(path.size(), mostArrows); ++s)
            if (path[s].segmentCount() > 0)
                arrow(path[s]);
    }
    void segments(const app::NodePath& path, const std::optional<app::NodeAddress>& dragged)
    {
        painter_.setPen(QPen(blue(), 1.5));
        std::size_t count = 0;
        for (std::size_t s = 0; s < path.size(); ++s)
            for (std::size_t i = 0; i < path[s].segmentCount() && count < mostSegments; ++i) {
                const std::size_t end = (i + 1) % path[s].nodes.size();
                const bool beside =
                    dragged == app::NodeAddress{s, i} || dragged == app::NodeAddress{s, end};
                if (!beside && !path[s].nodes[i].selected && !path[s].nodes[end].selected)
                    continue;
                segment(path[s], i);
                ++count;
            }
    }

private:
    QColor blue() const { return bench_.look.selection; }
    bool seen(const QPointF& at) const
    {
        const app::Point size = bench_.view.size;
        return at.x() >= -beyond && at.y() >= -beyond && at.x() <= size.x + beyond
               && at.y() <= size.y + beyond;
    }
    static quint64 cellOf(const QPointF& at)
    {
        const auto part = [](double v) { return quint64(std::floor(v / cell) + 1e6); };
        return part(at.x()) << 32 | part(at.y());
    }
    /// With a margin of paper, which sets it off from the line.
    void node(const app::Node& node, bool hovered)
    {
        const QPointF at = bench_.onScreen(node.at);
        const double half = (nodeSize + (hovered || node.selected ? growth : 0)) / 2;
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(bench_.look.paper);
        shape(node.type, at, half + margin);
        painter_.setPen(QPen(blue(), 1.5));
        painter_.setBrush(node.selected ? blue() : bench_.look.paper);
        shape(node.type, at, half);
    }
    void shape(app::NodeType type, const QPointF& at, double half)
    {
        if (type == app::NodeType::Smooth)
            return painter_.drawEllipse(at, half, half);
        if (type == app::NodeType::Symmetric)
            half += 1.5; // a diamond as large as the others
        const QPointF right(half, 0), down(0, half);
        if (type == app::NodeType::Symmetric)
            painter_.drawPolygon(QPolygonF{at - down, at + right, at + down, at - right});
        else
            painter_.drawPolygon(QPolygonF{at - right - down, at + right - down, at + right + down,
                                           at - right + down});
    }
    void dots(const app::NodePath& path, const std::vector<app::NodeAddress>& visible)
    {
        QSet<quint64> used;
        QList<QPointF> usual, selected;
        for (const app::NodeAddress& address : visible) {
            const app::Node& node = path[address.subpath].nodes[address.node];
            const QPointF at = bench_.onScreen(node.at);
            const quint64 place = cellOf(at);
            if (!node.selected && used.contains(place))
                continue;
            if (node.selected && std::size_t(selected.size()) < mostShapes)
                selected << at;
            else if (!node.selected)
                usual << at;
            used.insert(place);
        }
        painter_.setPen(QPen(blue(), 3, Qt::SolidLine, Qt::SquareCap));
        painter_.drawPoints(usual.data(), int(usual.size()));
        painter_.setPen(QPen(blue(), 7, Qt::SolidLine, Qt::SquareCap));
        painter_.drawPoints(selected.data(), int(selected.size()));
    }
    void arrow(const app::NodeSubpath& subpath)
    {
        const app::Bezier c = subpath.segment(0);
        const QPointF at = bench_.onScreen(c.from);
        app::Point along = c.to - c.from;
        for (const app::Point& p : {c.control2, c.control1})
            if (p != c.from)
                along = p - c.from;
        along = app::withLength(along, 1);
        if (!seen(at) || along == app::Point(0))
            return;
        const QPointF way(along.x, along.y), side(along.y, -along.x);
        const QPointF from = at + side * arrowOffset - way * arrowLength / 2;
        const QPointF to = from + way * arrowLength;
        painter_.setPen(QPen(blue(), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawLine(from, to);
        painter_.drawPolyline(QPolygonF{to - way * arrowHead + side * arrowHead, to,
                                        to - way * arrowHead - side * arrowHead});
    }
    void segment(const app::NodeSubpath& subpath, std::size_t i)
    {
        const app::Bezier c = subpath.segment(i);
        std::vector<app::Chord> chords;
        app::flatten(c.from, {c.to, c.control1, c.control2, subpath.nodes[i].curved}, 0,
                     chordError / bench_.view.zoom, chords);
        QList<QLineF> lines;
        for (const app::Chord& chord : chords)
            if (const auto line = lineOnScreen(chord.segment, bench_))
                lines << *line;
        painter_.drawLines(lines);
    }

    QPainter& painter_;
    const Workbench& bench_;
};

} // namespace

std::vector<app::ShownHandle> handlesOf(const app::NodePath& path, const Workbench& bench)
{
    return bench.session.nodes.summary().selected > 0 ? app::shownHandles(path)
                                                      : std::vector<app::ShownHandle>{};
}

void paintNodes(QPainter& painter, const Workbench& bench, const app::NodePath& path,
                const HoveredNode& hovered)
{
    NodePainter paint(painter, bench);
    paint.arrows(path);
    paint.handles(path, hovered);
    paint.nodes(path, hovered);
}

void paintChangedSegments(QPainter& painter, const Workbench& bench, const app::NodePath& path,
                          const std::optional<app::NodeAddress>& dragged)
{
    NodePainter(painter, bench).segments(path, dragged);
}

} // namespace ui
