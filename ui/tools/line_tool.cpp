// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "ui/look/text.h"
#include "ui/tools/kept_choices.h"
#include "ui/tools/two_points.h"

#include <glm/geometric.hpp>

namespace ui {
namespace {

/// Draws a line by a drag, or lines from click to click: each begins where the last one ends, until
/// Enter, Esc, a double click or a click where the first one began. A person may choose that each
/// line stands alone. With Alt a line extends from its middle to both sides.
class LineTool final : public TwoPointTool, public TakesKeys, public HasSteps {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        chained_ = chained_ && busy();
        Pointer at = pointer;
        if (mayClose(bench) && !pointer.held
            && glm::distance(at.position, starts_.front()) <= bench.inDrawing(reach))
            at.position = at.steered = starts_.front();
        TwoPointTool::press(at, bench);
    }
    void doubleClick(const Pointer& pointer, Workbench& bench) override
    {
        starts_.empty() ? press(pointer, bench) : cancel(bench);
    }
    bool key(QKeyEvent& event, Workbench& bench) override
    {
        const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
        if (!busy() || !enter)
            return false;
        cancel(bench);
        return true;
    }
    void cancel(Workbench& bench) override
    {
        TwoPointTool::cancel(bench);
        starts_.clear();
        bench.session.setPreview({});
    }

    bool canTakeBack() const override { return busy() && !starts_.empty(); }
    void takeBack(Workbench& bench) override
    {
        bench.session.history.undo();
        const app::Point start = starts_.back();
        starts_.pop_back();
        begin(start, bench);
    }
    QString stepText() const override { return undoText(); }
    bool pointBegins() const override { return chained_; }

protected:
    const app::GestureMeasure& measure(Qt::KeyboardModifiers modifiers) const override
    {
        return app::lengthAndAngle(anchorOf(modifiers));
    }
    app::Subpath path(const Gesture& gesture) const override
    {
        const clipping::Segment line = lineOf(gesture);
        return {line.a, {app::PathSegment{line.b}}, false};
    }
    QString undoText() const override { return Text::tr("Draw line"); }
    QString historyText(const Workbench& bench) const override
    {
        const clipping::Segment line = lineOf(*gesture_);
        return Text::tr("Draw line, %1")
            .arg(app::lengthText(glm::distance(line.a, line.b), bench.session.display().unit,
                                 bench.session.now().page().realMillimetresPerUnit()));
    }
    void follow(const Gesture& gesture, Workbench& bench) override
    {
        bench.session.setPreview({.line = lineOf(gesture)});
    }
    void finishByClick(Workbench& bench) override
    {
        if (refusesEmpty(bench))
            return;
        const bool closed = mayClose(bench) && gesture_->to == starts_.front();
        add(bench);
        if (closed || !kept(0, bench))
            return cancel(bench);
        chained_ = true;
        starts_.push_back(gesture_->from);
        begin(gesture_->to, bench);
    }

private:
    static bool kept(std::size_t choice, const Workbench& bench)
    {
        return keptBy(keptLine, bench, usualLine)[choice] != 0;
    }
    /// A third line may end where the first one began.
    bool mayClose(const Workbench& bench) const
    {
        return starts_.size() > 1 && kept(0, bench) && kept(1, bench);
    }
    static clipping::Segment lineOf(const Gesture& gesture)
    {
        const bool centre = anchorOf(gesture.modifiers) == app::Anchor::Centre;
        return {centre ? 2.0 * gesture.from - gesture.to : gesture.from, gesture.to};
    }

    std::vector<app::Point> starts_; ///< of the chain's lines
    bool chained_ = false;           ///< the last line belongs to a chain
};

} // namespace

std::unique_ptr<Tool> makeLineTool() { return std::make_unique<LineTool>(); }

} // namespace ui
