// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/drag.h"
#include "ui/tools/picking_marks.h"

#include <utility>

namespace ui {

/// Drags a box around what it selects.
class BoxDrag final : public Drag {
public:
    using Select = void (*)(const Pointer& from, const Pointer& to, Workbench& bench);
    /// `backwards`: the edge of a box that is dragged to the left.
    explicit BoxDrag(Select select, Qt::PenStyle backwards = Qt::SolidLine)
        : select_(select), backwards_(backwards)
    {
    }
    void start(const Pointer& pressed) { from_ = to_ = pressed; }
    bool going() const override { return from_.has_value(); }
    void proceed(const Pointer& pointer, Workbench&) override { to_ = pointer; }
    bool finish(const Pointer& pointer, Workbench& bench) override
    {
        select_(*std::exchange(from_, std::nullopt), pointer, bench);
        return true;
    }
    void cancel(Workbench&) override { from_.reset(); }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (from_)
            paintSelectionBox(painter, bench, from_->raw, to_.raw,
                              to_.screen.x < from_->screen.x ? backwards_ : Qt::SolidLine);
    }

private:
    Select select_;
    Qt::PenStyle backwards_;
    std::optional<Pointer> from_;
    Pointer to_{};
};

} // namespace ui
