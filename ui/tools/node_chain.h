// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/last_step.h"
#include "ui/tools/shape_drawing.h"

namespace ui {

/// Draws a path node by node. A click on the first node closes it; Enter, Esc or another tool end
/// and keep it. Undo removes the last node. Numbers typed afterwards change the last segment of an
/// open path, until something else happens; a typed point begins the next path.
class ChainTool : public Tool,
                  public TakesKeys,
                  public HasSteps,
                  public HasUnfinished,
                  public TypesNumbers {
public:
    void press(const Pointer& pointer, Workbench& bench) override;
    void move(const Pointer& pointer, Workbench&) override { to_ = pointer.position; }
    void leave(Workbench&) override { to_.reset(); }
    void doubleClick(const Pointer&, Workbench& bench) override { complete(bench); }
    bool key(QKeyEvent& event, Workbench& bench) override;
    bool wants(const QKeyEvent& event, const Workbench&) const override;
    void cancel(Workbench& bench) override;
    void end(Workbench& bench) override { corrects() ? cancel(bench) : finish(bench, false); }
    bool busy() const override { return !nodes_.empty(); }

    bool canTakeBack() const override { return !nodes_.empty() && !corrects(); }
    void takeBack(Workbench& bench) override;
    bool canPutBack(const Workbench& bench) const override;
    void putBack(Workbench& bench) override;
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void reopen(Workbench& bench) override;
    bool corrects() const override { return last_.isOpen(); }
    bool pointBegins() const override { return true; }
    std::optional<app::ObjectInHand> unfinished(const Workbench& bench) const override;
    std::size_t unfinishedPoints() const override { return corrects() ? 0 : nodes_.size(); }
    QString hint(const Workbench& bench) const override;
    void paint(QPainter& painter, const Workbench& bench) const override;

protected:
    /// The handles are `at` where there are none.
    struct Node {
        app::Point at, in, out;
    };

    virtual QString undoText() const { return {}; } ///< of the object that `keep` draws
    /// Makes something of the finished path.
    virtual void keep(app::Subpath path, Workbench& bench);
    virtual void paintPath(QPainter& painter, const Workbench& bench,
                           const app::Subpath& path) const;
    virtual bool showsNext() const { return true; } ///< where the path would go on
    /// Whether the path that is shown is closed.
    virtual bool closes(const Workbench&) const { return false; }
    void add(const app::Point& at);
    /// A click there closes the path.
    bool closesAt(const app::Point& point, const Workbench& bench) const;
    void finish(Workbench& bench, bool closed);
    static app::Subpath pathOf(std::span<const Node> nodes, bool closed);

    std::vector<Node> nodes_;
    std::optional<app::Point> to_; ///< the node that a click would add; empty: none

private:
    bool isCurved() const;
    std::vector<Node> corrected(const app::Point& to) const;
    void complete(Workbench& bench); ///< the person says that the path is finished

    std::vector<Node> takenBack_; ///< removed nodes; the last one returns first
    int stepsBefore_ = 0;         ///< number of history steps done when a node was removed
    std::vector<Node> done_;      ///< the nodes of the last path
    LastStep last_;
};

} // namespace ui
