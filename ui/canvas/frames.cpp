// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/frames.h"

#include "app/view/picture.h"
#include "ui/canvas/window_overlay.h"
#include "ui/tools/selection_marks.h"
#include "ui/widgets/swatch.h"

#include <algorithm>
#include <utility>

namespace ui {

using namespace std::chrono_literals;

// With what else is painted, a turn of the event loop stays below 8 ms.
constexpr auto mostWaiting = 5ms;

double Frames::ghostOpacity() const
{
    return session().display().presenting ? 1 : bench_.look.ghost;
}

std::shared_ptr<const app::Differences> Frames::differing(const Pane& pane) const
{
    const auto window = session().comparedAt();
    return pane.fromExact && window ? pane.fromExact->at(*window) : nullptr;
}

void Frames::addDifferences(app::FrameWish& wish, const Pane& pane) const
{
    auto differences = differing(pane);
    if (!differences && pane.among == 1)
        differences = session().differences.at(session().window());
    if (differences)
        wish.differing = app::SharedPieces(differences, &differences->pieces);
}

/// Colours lines by their error class; wrong lines are marked like differing ones.
void Frames::addErrors(app::FrameWish& wish) const
{
    const auto pieces = session().exactness.piecesAt(session().window());
    if (pieces.empty())
        return;
    const app::Ground ground = bench_.look.dark ? app::Ground::Dark : app::Ground::Light;
    for (std::size_t row = 0; row + 1 < pieces.size(); ++row)
        wish.graded.push_back(
            {pieces[row], plainColour(app::errorColour(row, ground, bench_.look.differs))});
    if (!wish.differing || wish.differing->empty())
        wish.differing = pieces.back();
}

app::PictureOptions Frames::pictureOptions(double pixelRatio) const
{
    const app::Display& display = session().display();
    app::PictureOptions options;
    options.removed = display.removed;
    options.closesAreas = display.cutting.closeAreas;
    options.leastLength = exportOptions(display.cutting, session().now().page()).leastLength;
    if (bench_.look.dark)
        options.page = plainColour(bench_.look.paper);
    options.leastWidth = pixelRatio < 1.5 ? 0.75 : 0.5;
    if (display.presenting) {
        options.strokes = 2;
        options.ghosting = app::Ghosting{plainColour(bench_.look.paper), bench_.look.ghost};
    }
    options.light = plainColour(bench_.look.selection);
    options.paper = plainColour(bench_.look.paper);
    options.marked = plainColour(bench_.look.differs);
    if (bench_.look.dark) // magenta is close to the selection's blue in the dark look
        options.ticks = app::PictureOptions::Ticks::Everywhere;
    return options;
}

const Frames::Images& Frames::images() const
{
    if (const app::Document& now = session().now(); !sameAddress(now, images_.of)) {
        images_.of = now;
        images_.seen = seenUnderlays(now);
        images_.revision = images_.count.follow(images_.seen);
    }
    return images_;
}

app::FrameWish Frames::wish(const Pane& pane, double pixelRatio, const QSize& pixels) const
{
    const app::SceneLines& lines = session().scene.lines();
    app::FrameWish wish{.key = {.lines = lines.revision(),
                                .images = images().revision,
                                .look = revision_ + pane.revision,
                                .view = bench_.view,
                                .region = pane.region.value_or(session().region()),
                                .variant = pane.choice,
                                .pixels = pixels,
                                .pixelRatio = pixelRatio,
                                .borders = longBorders(bench_, pane)},
                        .document = session().now(),
                        .lines = lines,
                        .options = pictureOptions(pixelRatio),
                        .underlays = images().seen,
                        .ghost = ghostOpacity(),
                        .drawings = drawings_};
    if (app::outlines(lines, session().selection().ranges())
        && !SelectionMarks::isQuiet(session())) // lines around letters hide them
        wish.selection = session().selection();
    addDifferences(wish, pane);
    if (pane.among == 1)
        addErrors(wish);
    return wish;
}

void Frames::followPage()
{
    const double size = session().now().page().millimetresPerUnit();
    if (std::exchange(unitSize_, size) != size)
        renew();
}

std::chrono::microseconds Frames::patience()
{
    using namespace std::chrono;
    const auto now = steady_clock::now();
    if (!turnEnds_) {
        turnEnds_ = now + mostWaiting;
        QTimer::singleShot(0, this, [this] { turnEnds_.reset(); });
    }
    return std::max(0us, duration_cast<microseconds>(*turnEnds_ - now));
}

} // namespace ui

#include "moc_frames.cpp"
