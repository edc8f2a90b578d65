// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/last_step.h"

namespace ui {

/// One gesture of a tool that has several. Between a start of its own and finish() it follows the
/// pointer; then it has made one step, which typed numbers may change as long as nothing else
/// happens.
class Drag {
public:
    virtual ~Drag() = default;
    virtual bool going() const = 0;
    virtual void proceed(const Pointer&, Workbench&) = 0;
    virtual bool finish(const Pointer&, Workbench&) = 0; ///< one step; false: it was a click
    virtual void cancel(Workbench&) = 0;
    virtual void paint(QPainter&, const Workbench&) const {}

    /// The numbers of the gesture, or of the step that it can open again; empty: none.
    virtual std::optional<app::Gauge> gauge(const Workbench&) const { return std::nullopt; }
    virtual void accept(const app::GestureEnd&, Workbench&) {} ///< ends with typed numbers
    virtual void reopen(Workbench&) {}                         ///< goes on with the last step
    bool corrects() const { return last_.isOpen(); }           ///< the last step is open again
    bool canReopen(const Workbench& bench) const { return last_.canReopen(bench); }
    void end(Workbench& bench) ///< cancels, and forgets the last step
    {
        cancel(bench);
        last_.forget();
    }

    /// Takes out of the query what the pointer does not snap to: what is dragged, or everything.
    virtual void limit(app::SnapQuery& query) const { query.to = app::SnapTo::Nothing; }
    /// Where the thing that is moved snaps by itself; null: it does not.
    virtual const app::MovedSnap* snapped() const { return nullptr; }

protected:
    LastStep last_;
};

} // namespace ui
