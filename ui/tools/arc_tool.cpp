// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/direction.h"
#include "app/drawing/circle_arc.h"
#include "ui/look/text.h"
#include "ui/tools/last_step.h"
#include "ui/tools/shape_drawing.h"

#include <cmath>

namespace ui {
namespace {

constexpr std::string_view keptArc = "arc";

/// Draws an arc by its start, its end and a point on it; or by its centre, its start and its end.
/// Numbers typed afterwards change it, until something else happens.
class ArcTool final : public Tool,
                      public TakenUp,
                      public TakesKeys,
                      public HasSteps,
                      public TypesNumbers {
public:
    void takeUp(Workbench& bench) override { arc_.byCentre = keptBy(keptArc, bench, {})[0] != 0; }
    void press(const Pointer& pointer, Workbench& bench) override
    {
        const bool corrects = last_.isOpen();
        if (corrects)
            cancel(bench); // a click ends the correction
        if (arc_.points.size() == 2) {
            move(pointer, bench);
            return finish(bench);
        }
        last_.forget();
        if (arc_.points.empty())
            arc_.byCentre =
                keptBy(keptArc, bench, {})[0] != 0 || (pointer.modifiers & Qt::AltModifier);
        pressed_ = pointer.screen;
        place(corrects ? pointer.steered : pointer.position, bench);
    }
    void move(const Pointer& pointer, Workbench&) override
    {
        arc_.to = pointer.position;
        if (arc_.points.size() < 2)
            return;
        if (arc_.byCentre && !pointer.held)
            followWayAround();
        arc_.degrees = pointer.held ? pointer.numbers[0] : sweep().values(start(), arc_.to)[0];
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        const auto pressed = std::exchange(pressed_, std::nullopt);
        if (pressed && arc_.points.size() == 1 && dragged(*pressed, pointer))
            place(pointer.position, bench);
    }
    bool key(QKeyEvent& event, Workbench& bench) override
    {
        if (event.key() == Qt::Key_C && !event.modifiers() && arc_.points.size() < 2) {
            arc_.byCentre = !isByCentre(bench);
            bench.kept[keptArc] = {arc_.byCentre ? 1.0 : 0.0};
        } else if (takesBack(event.key()) && canTakeBack()) {
            takeBack(bench);
        } else {
            return false;
        }
        return true;
    }
    bool wants(const QKeyEvent& event, const Workbench&) const override
    {
        return takesBack(event.key()) && canTakeBack();
    }
    void cancel(Workbench& bench) override
    {
        arc_.points.clear();
        arc_.byCentre = keptBy(keptArc, bench, {})[0] != 0;
        pressed_.reset();
        last_.restore(bench);
    }
    bool busy() const override { return !arc_.points.empty(); }

    bool canTakeBack() const override { return busy() && !last_.isOpen(); }
    void takeBack(Workbench&) override { arc_.points.pop_back(); }
    QString stepText() const override { return Text::tr("Place point"); }

    std::optional<app::Gauge> gauge(const Workbench& bench) const override
    {
        if (!busy())
            return gaugeOfStart(bench);
        const app::Point& first = arc_.points.front();
        if (arc_.points.size() == 1)
            return gaugeFrom(first, arc_.byCentre ? app::radiusAndAngle() : app::lengthAndAngle(),
                             bench);
        app::Gauge gauge = gaugeFrom(first, arc_.byCentre ? sweep() : app::arcMeasure(), bench);
        gauge.start = start();
        gauge.relativeTo = arc_.byCentre ? first : arc_.points.back();
        if (last_.isOpen())
            gauge.aim =
                app::GestureEnd{done_.to, arc_.byCentre ? app::Numbers{done_.degrees}
                                                        : gauge.measure->values(start(), done_.to)};
        return gauge;
    }
    void accept(const app::GestureEnd& end, Workbench& bench) override
    {
        if (arc_.points.empty())
            arc_.byCentre = isByCentre(bench);
        if (arc_.points.size() < 2)
            return place(end.point, bench);
        arc_.to = end.point;
        arc_.degrees = end.numbers[0];
        finish(bench);
    }
    void reopen(Workbench& bench) override
    {
        if (last_.reopen(bench))
            arc_ = done_;
    }
    bool corrects() const override { return last_.isOpen(); }

    QString hint(const Workbench& bench) const override
    {
        return isByCentre(bench) ? Text::tr(
                   "Click the centre, the start and the end of the arc. C: through three "
                   "points.")
                                 : QString();
    }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (!busy())
            return;
        const auto arc = made();
        preview(painter, bench,
                arc ? app::pathOf(*arc) : app::Subpath{arc_.points.back(), {{arc_.to}}, false});
        markPoints(painter, bench, arc_.points);
    }

private:
    /// What is being drawn.
    struct Drawn {
        bool byCentre = false;
        std::vector<app::Point> points{}; ///< that are placed: at most two
        app::Point to{};                  ///< the next one
        double degrees = 0;               ///< by its centre: of the arc
        app::Turn turn = app::Turn::Counterclockwise;
    };

    static bool takesBack(int key) { return key == Qt::Key_Backspace || key == Qt::Key_Delete; }
    /// The arc that is being drawn, or the next one.
    bool isByCentre(const Workbench& bench) const
    {
        return busy() ? arc_.byCentre : keptBy(keptArc, bench, {})[0] != 0;
    }
    app::GestureStart start() const { return {arc_.points[0], arc_.points[1]}; }
    const app::GestureMeasure& sweep() const { return app::sweepMeasure(arc_.turn); }

    /// The pointer changes the way around where it passes the start.
    void followWayAround()
    {
        const double before = std::exchange(aside_, std::remainder(turned(), 360));
        if (std::abs(before) < 90 && std::abs(aside_) < 90 && aside_ != 0)
            arc_.turn = aside_ < 0 ? app::Turn::Clockwise : app::Turn::Counterclockwise;
    }
    double turned() const
    {
        const auto [centre, from] = start();
        return app::degreesOf(arc_.to - centre) - app::degreesOf(from - centre);
    }

    void place(const app::Point& point, const Workbench& bench)
    {
        if (!arc_.points.empty() && point == arc_.points.back()) {
            emit bench.session.refused(
                Text::tr("The last point is already here. Click another place."));
            return;
        }
        arc_.points.push_back(point);
        arc_.to = point;
        arc_.degrees = 0;
        aside_ = 0;
    }
    /// Empty: it is not an arc yet.
    std::optional<app::CircleArc> made() const
    {
        if (arc_.points.size() < 2)
            return std::nullopt;
        const app::Point &a = arc_.points[0], &b = arc_.points[1];
        if (!arc_.byCentre)
            return app::arcThrough(a, b, arc_.to);
        return arc_.degrees == 0 ? std::nullopt : std::optional(app::arcAround(a, b, arc_.degrees));
    }
    void finish(Workbench& bench)
    {
        const auto arc = made();
        if (!arc) { // the gesture goes on
            emit bench.session.refused(
                arc_.byCentre ? Text::tr("The arc would have no length. Click another place.")
                              : Text::tr("These three points lie on a straight line. Click a "
                                         "place beside it."));
            return;
        }
        last_.discard();
        draw(bench, {app::pathOf(*arc)}, Text::tr("Draw arc"));
        done_ = arc_;
        cancel(bench);
        last_.remember(bench);
    }

    Drawn arc_, done_;
    double aside_ = 0;                  ///< degrees from the start to the pointer, in [−180, 180]
    std::optional<app::Point> pressed_; ///< on the screen; empty: the button is up
    LastStep last_;
};

} // namespace

std::unique_ptr<Tool> makeArcTool() { return std::make_unique<ArcTool>(); }

} // namespace ui
