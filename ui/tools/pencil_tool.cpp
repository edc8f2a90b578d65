// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/drawing/freehand.h"
#include "ui/look/text.h"
#include "ui/tools/last_step.h"
#include "ui/tools/shape_drawing.h"

namespace ui {
namespace {

constexpr std::string_view keptTolerance = "pencil"; // in the drawing; 0: none was typed
constexpr double usualTolerance = 2;                 // pixels, until a tolerance is typed
constexpr std::size_t mostCorrected = 100'000; // points that another tolerance may take 1 s for

/// The tolerance is typed: on paper, or in the drawing's unit.
const app::GestureMeasure& toleranceMeasure()
{
    using Measure = app::GestureMeasure;
    static const Measure measure{
        {{Text::tr("Tolerance"), app::Quantity::Length, HUGE_VAL, true}},
        [](const app::GestureStart&, const app::Point&) { return app::Numbers{}; },
        [](const app::GestureStart&, const app::Point& pointer, const app::Held&) {
            return pointer;
        },
        Measure::Points::Refused,
        nullptr,
        false,
        [](const app::GestureStart&, const app::Held& held) {
            return held[0] && *held[0] <= 0 ? Text::tr("The tolerance must be more than 0.")
                                            : QString();
        }};
    return measure;
}

/// Draws a freehand line, smoothed to curves that lie within the tolerance of the pointer's path.
/// Only its places count, not the pressure of a pen. A tolerance typed afterwards changes the line.
class PencilTool final : public Tool, public HasUnfinished, public TypesNumbers, public Snaps {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        cancel(bench); // a press ends the correction
        last_.forget();
        isLastTooLong_ = false;
        points_ = {pointer.raw};
        begin(toleranceIn(bench));
    }
    void move(const Pointer& pointer, Workbench&) override
    {
        if (last_.isOpen()) {
            if (pointer.held && pointer.numbers[0] > 0 && pointer.numbers[0] != fitted_)
                smooth_ = smoothed(pointer.numbers[0]);
        } else if (!points_.empty() && pointer.raw != points_.back()) {
            points_.push_back(pointer.raw);
            freehand_->add(pointer.raw);
        }
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        if (last_.isOpen())
            return;
        move(pointer, bench);
        finish(bench);
    }
    void cancel(Workbench& bench) override
    {
        points_.clear();
        last_.restore(bench);
    }
    bool busy() const override { return !points_.empty(); }
    std::optional<app::ObjectInHand> unfinished(const Workbench& bench) const override
    {
        if (points_.size() < 2 || last_.isOpen())
            return std::nullopt;
        return inHand(bench, freehand_->draft());
    }
    std::size_t unfinishedPoints() const override { return last_.isOpen() ? 0 : points_.size(); }

    std::optional<app::Gauge> gauge(const Workbench& bench) const override
    {
        app::Gauge gauge = gaugeFrom({}, toleranceMeasure(), bench);
        gauge.kept = {toleranceIn(bench)};
        return gauge;
    }
    void accept(const app::GestureEnd& end, Workbench& bench) override
    {
        bench.kept[keptTolerance] = {end.numbers[0]};
        if (last_.isOpen())
            finish(bench);
        else if (isLastTooLong_)
            emit bench.session.refused(
                Text::tr("A freehand line of more than %1 points cannot be smoothed again. The "
                         "next line gets this tolerance.")
                    .arg(app::countText(mostCorrected)));
    }
    void reopen(Workbench& bench) override
    {
        if (!last_.reopen(bench))
            return;
        points_ = done_;
        smooth_ = smoothed(toleranceIn(bench));
    }
    bool corrects() const override { return last_.isOpen(); }

    void limit(app::SnapQuery& query) const override { query.to = app::SnapTo::Nothing; }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (points_.size() >= 2)
            preview(painter, bench, last_.isOpen() ? smooth_ : freehand_->draft());
    }

private:
    static double toleranceIn(const Workbench& bench)
    {
        const double kept = keptBy(keptTolerance, bench, {})[0];
        return kept > 0 ? kept : bench.inDrawing(usualTolerance);
    }
    void begin(double tolerance)
    {
        freehand_.emplace(points_.front(), tolerance);
        fitted_ = tolerance;
    }
    /// Of at least two points.
    app::Subpath smoothed(double tolerance)
    {
        if (tolerance != fitted_) {
            begin(tolerance);
            for (const app::Point& point : std::span(points_).subspan(1))
                freehand_->add(point);
        }
        return freehand_->path();
    }
    void finish(Workbench& bench)
    {
        if (points_.size() < 2) {
            if (!points_.empty())
                emit bench.session.refused(Text::tr("A click draws nothing. Drag to draw a line."));
            return points_.clear();
        }
        last_.discard();
        const double tolerance = points_.size() <= mostCorrected ? toleranceIn(bench) : fitted_;
        draw(bench, {smoothed(tolerance)}, Text::tr("Draw freehand"));
        done_ = std::exchange(points_, {});
        isLastTooLong_ = done_.size() > mostCorrected;
        if (!isLastTooLong_)
            last_.remember(bench);
    }

    std::vector<app::Point> points_;
    std::optional<app::Freehand> freehand_; ///< of these points
    double fitted_ = 0;                     ///< the tolerance of that
    std::vector<app::Point> done_;          ///< of the last line
    app::Subpath smooth_{};                 ///< during a correction
    bool isLastTooLong_ = false;            ///< too long to be smoothed again
    LastStep last_;
};

} // namespace

std::unique_ptr<Tool> makePencilTool() { return std::make_unique<PencilTool>(); }

} // namespace ui
