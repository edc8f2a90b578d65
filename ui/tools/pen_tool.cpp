// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/tools/node_chain.h"

#include <glm/geometric.hpp>

#include <utility>

namespace ui {
namespace {

/// Draws a path of Bézier curves: a click places a corner, a drag a symmetric node with its
/// handles; Alt drags the handle after the node alone, S keeps the length of the one before. A
/// click on the first node, or a drag from it, closes the path; one on the last node makes it a
/// corner.
class PenTool final : public ChainTool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        if (corrects())
            cancel(bench); // a click ends the correction
        closing_ = closesAt(pointer.position, bench);
        alone_ = !closing_ && onLast(pointer.position, bench);
        if (alone_)
            nodes_.back().out = nodes_.back().at;
        else if (!closing_)
            ChainTool::press(pointer, bench);
        pressed_ = pointer.screen;
        keptLength_.reset();
    }
    void move(const Pointer& pointer, Workbench& bench) override
    {
        ChainTool::move(pointer, bench);
        if (!pressed_ || nodes_.empty())
            return;
        dragged_ = dragged_ || dragged(*pressed_, pointer);
        if (dragged_)
            pull(pointer.position, pointer.modifiers);
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        move(pointer, bench);
        letGo(bench);
    }
    void doubleClick(const Pointer& pointer, Workbench& bench) override
    {
        if (closesAt(pointer.position, bench))
            return press(pointer, bench);
        ChainTool::doubleClick(pointer, bench);
    }
    /// S while dragging a node: smooth, and symmetric again.
    bool wants(const QKeyEvent& event, const Workbench& bench) const override
    {
        return isSmooth(event) || ChainTool::wants(event, bench);
    }
    bool key(QKeyEvent& event, Workbench& bench) override
    {
        if (!isSmooth(event))
            return ChainTool::key(event, bench);
        if (keptLength_)
            keptLength_.reset();
        else
            keptLength_ = glm::distance(pulled().at, other());
        return true;
    }
    void cancel(Workbench& bench) override
    {
        forgetButton();
        ChainTool::cancel(bench);
    }
    void takeBack(Workbench& bench) override
    {
        forgetButton();
        ChainTool::takeBack(bench);
    }
    std::optional<app::Gauge> gauge(const Workbench& bench) const override
    {
        return dragged_ ? gaugeFrom(pulled().at, app::lengthAndAngle(), bench)
                        : ChainTool::gauge(bench);
    }
    void accept(const app::GestureEnd& end, Workbench& bench) override
    {
        if (!dragged_)
            return ChainTool::accept(end, bench);
        pull(end.point, {});
        letGo(bench);
    }
    /// The journal follows the handles, too.
    std::size_t unfinishedPoints() const override
    {
        return 2 * ChainTool::unfinishedPoints() - (pressed_ ? 1 : 0);
    }
    QString stepText() const override { return Text::tr("Place node"); }
    QString hint(const Workbench& bench) const override
    {
        if (!dragged_)
            return ChainTool::hint(bench);
        return keptLength_
                   ? Text::tr("Smooth: the other handle keeps its length. S: symmetric, Alt: cusp.")
                   : Text::tr("Symmetric: both handles are equally long. S: only in line "
                              "(smooth), Alt: cusp.");
    }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (nodes_.empty())
            return;
        paintHandles(painter, bench);
        ChainTool::paint(painter, bench);
    }

protected:
    QString undoText() const override { return Text::tr("Draw curve"); }
    bool showsNext() const override { return !dragged_; }
    bool closes(const Workbench&) const override { return closing_ && dragged_; }

private:
    Node& pulled() { return closing_ ? nodes_.front() : nodes_.back(); }
    const Node& pulled() const { return closing_ ? nodes_.front() : nodes_.back(); }

    bool isSmooth(const QKeyEvent& event) const
    {
        return dragged_ && event.key() == Qt::Key_S && !event.modifiers();
    }
    /// The handle that follows the one that is pulled. At the closing node the pointer is where the
    /// path leads on, and the handle before the node is pulled.
    app::Point& other() { return closing_ ? pulled().out : pulled().in; }

    /// The handles of the node whose button is down. At the closing node the drag leads on along
    /// the path, so the handle before the node is opposite.
    void pull(const app::Point& to, Qt::KeyboardModifiers modifiers)
    {
        Node& node = pulled();
        const bool alone = alone_ || modifiers & Qt::AltModifier;
        if (closing_) {
            node.in = 2.0 * node.at - to;
            if (!alone && node.out != node.at)
                node.out = inLine(node.at, to);
            return;
        }
        node.out = to;
        if (!alone)
            node.in = inLine(node.at, 2.0 * node.at - to);
    }
    /// The handle in the direction of `to`, with the length that it keeps.
    app::Point inLine(const app::Point& at, const app::Point& to) const
    {
        return keptLength_ && to != at ? at + glm::normalize(to - at) * *keptLength_ : to;
    }
    void letGo(Workbench& bench)
    {
        const bool closes = std::exchange(closing_, false) && pressed_;
        pressed_.reset();
        dragged_ = false;
        if (closes)
            finish(bench, true);
    }
    void forgetButton()
    {
        pressed_.reset();
        closing_ = dragged_ = false;
    }
    bool onLast(const app::Point& point, const Workbench& bench) const
    {
        return !nodes_.empty() && glm::distance(point, nodes_.back().at) <= bench.inDrawing(reach);
    }
    void paintHandles(QPainter& painter, const Workbench& bench) const
    {
        for (const Node* node : {&nodes_.back(), &pulled()}) {
            const bool both = node == &pulled() && dragged_;
            painter.setPen(QPen(bench.look.selection, 1));
            painter.setBrush(bench.look.selection);
            for (const app::Point& handle : {node->in, node->out}) {
                if (handle == node->at || (!both && handle == node->in))
                    continue;
                painter.drawLine(bench.onScreen(node->at), bench.onScreen(handle));
                painter.drawEllipse(bench.onScreen(handle), 2.5, 2.5);
            }
        }
    }

    std::optional<app::Point> pressed_; ///< on the screen; empty: the button is up
    bool dragged_ = false;              ///< handles follow the pointer
    bool closing_ = false;              ///< the button is down on the first node
    bool alone_ = false;                ///< on the last one: its handle before it stays
    std::optional<double> keptLength_;  ///< of the other handle; empty: both are equally long
};

} // namespace

std::unique_ptr<Tool> makePenTool() { return std::make_unique<PenTool>(); }

} // namespace ui
