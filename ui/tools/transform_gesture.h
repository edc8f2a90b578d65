// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/drawing/transformation.h"
#include "ui/tools/drag.h"

#include <QKeyEvent>

namespace ui {

/// Moves, rotates, scales or skews the selection, or copies of it, by a drag or from a key. Typed
/// numbers hold, and change what was just done.
class TransformGesture final : public Drag {
public:
    /// `pointer`: where the pointer is, in the drawing. `grabbed`: the point that it moves, if the
    /// pivot stays.
    void start(const app::Transformation& kind, const app::Point& pivot, const app::Point& pointer,
               const app::Point& grabbed, const Workbench& bench);
    /// The point that a gesture from a key moves: what the pointer snaps to, unless it is the
    /// pivot.
    static app::Point grabbedAt(const app::Point& pointer, const app::Point& pivot,
                                const Workbench& bench);
    bool going() const override { return now_.has_value(); }
    bool moves() const { return now_ && now_->kind->movesPivot; } ///< and goes on
    void proceed(const Pointer& pointer, Workbench& bench) override;
    bool finish(const Pointer& pointer, Workbench& bench) override;
    void finish(Workbench& bench); ///< where the pointer was last
    void cancel(Workbench& bench) override;
    void paint(QPainter& painter, const Workbench& bench) const override;
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void reopen(Workbench& bench) override;
    /// What the selection, or the point that is grabbed, snaps to.
    const app::MovedSnap* snapped() const override
    {
        return now_ && now_->snap ? &*now_->snap : nullptr;
    }
    /// X and Y hold an axis, C makes copies; a second press takes it back. P puts the pivot under
    /// the pointer.
    bool key(const QKeyEvent& event, const Workbench& bench);
    bool wants(const QKeyEvent& event) const;
    QString hint(const Workbench& bench) const; ///< empty: nothing to say

private:
    struct State {
        const app::Transformation* kind;
        app::GestureStart start;
        app::Point shift; ///< from the pointer to the point that it moves
        app::ObjectRanges objects;
        app::GestureEnd end;
        app::Along axis = app::Along::Both;
        bool copies = false;
        app::Point pressed{}, last{}; ///< where the pointer was at first, and is
        app::OwnPoints own{};         ///< of the selection, or the point that is grabbed
        std::optional<app::MovedSnap> snap{};
    };
    static std::vector<app::AffineMap> maps(const State& state);
    static bool isNothing(const State& state); ///< nothing would move
    static app::GestureEnd atRest(const State& state);
    /// A key of the gesture.
    struct Letter {
        int key;
        void (*press)(TransformGesture& gesture, const Workbench& bench);
    };
    static const Letter* letterOf(const QKeyEvent& event); ///< null: it is another key
    void hold(app::Along axis);
    void putPivot(const Workbench& bench);
    void snap(const Pointer& pointer, const Workbench& bench);
    bool push(const State& state, Workbench& bench) const;

    std::optional<State> now_;
    State done_{}; ///< the gesture of the last step
};

/// For what only points to a place: it need not be in line with anything there.
app::SnapTo placesOnly();

constexpr std::size_t mostPreviewed = 4000; // lines

/// Paints lines of the selection as the map would make them, at most so many, and of long ones
/// fewer.
void paintMapped(QPainter& painter, const Workbench& bench, const app::AffineMap& map,
                 std::size_t most = mostPreviewed);
/// The same for several maps, which share the lines; a copy has at least one.
void paintCopies(QPainter& painter, const Workbench& bench, std::span<const app::AffineMap> copies);

} // namespace ui
