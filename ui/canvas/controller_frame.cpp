// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picture.h"
#include "ui/canvas/controller.h"
#include "ui/canvas/window_overlay.h"
#include "ui/tools/selection_marks.h"
#include "ui/widgets/swatch.h"

#include <algorithm>

// The content of a frame.

namespace ui {

using namespace std::chrono_literals;

// With what else is painted, a turn of the event loop stays below 8 ms.
constexpr auto mostWaiting = 5ms;

QColor Controller::pageColour() const { return paperLook_.paper; }

double Controller::ghostOpacity() const
{
    return session_.display().presenting ? 1 : paperLook_.ghost;
}

std::shared_ptr<const app::Differences> Controller::differing(const Pane& pane) const
{
    const auto window = session_.comparedAt();
    return pane.fromExact && window ? pane.fromExact->at(*window) : nullptr;
}

void Controller::addDifferences(app::FrameWish& wish, const Pane& pane) const
{
    auto differences = differing(pane);
    if (!differences && pane.among == 1)
        differences = session_.differences.at(window());
    if (differences)
        wish.differing = app::SharedPieces(differences, &differences->pieces);
}

/// Colours lines by their error class; wrong lines are marked like differing ones.
void Controller::addErrors(app::FrameWish& wish) const
{
    const auto pieces = session_.exactness.piecesAt(window());
    if (pieces.empty())
        return;
    const app::Ground ground = paperLook_.dark ? app::Ground::Dark : app::Ground::Light;
    for (std::size_t row = 0; row + 1 < pieces.size(); ++row)
        wish.graded.push_back(
            {pieces[row], plainColour(app::errorColour(row, ground, paperLook_.differs))});
    if (!wish.differing || wish.differing->empty())
        wish.differing = pieces.back();
}

app::PictureOptions Controller::pictureOptions(double pixelRatio) const
{
    const app::Display& display = session_.display();
    app::PictureOptions options;
    options.removed = display.removed;
    options.closesAreas = display.cutting.closeAreas;
    options.leastLength = exportOptions(display.cutting, session_.now().page()).leastLength;
    if (paperLook_.dark)
        options.page = plainColour(paperLook_.paper);
    options.leastWidth = pixelRatio < 1.5 ? 0.75 : 0.5;
    if (display.presenting) {
        options.strokes = 2;
        options.ghosting = app::Ghosting{plainColour(pageColour()), paperLook_.ghost};
    }
    options.light = plainColour(paperLook_.selection);
    options.paper = plainColour(pageColour());
    options.marked = plainColour(paperLook_.differs);
    if (paperLook_.dark) // magenta is close to the selection's blue in the dark look
        options.ticks = app::PictureOptions::Ticks::Everywhere;
    return options;
}

app::FrameWish Controller::wish(const Pane& pane, double pixelRatio, const QSize& pixels) const
{
    const app::SceneLines& lines = session_.scene.lines();
    app::FrameWish wish{.key = {.lines = lines.revision(),
                                .look = revision_ + pane.revision,
                                .view = view(),
                                .region = pane.region.value_or(session_.region()),
                                .variant = pane.choice,
                                .pixels = pixels,
                                .pixelRatio = pixelRatio,
                                .borders = longBorders(*this, pane)},
                        .document = session_.now(),
                        .lines = lines,
                        .options = pictureOptions(pixelRatio),
                        .ghost = ghostOpacity(),
                        .drawings = drawings_};
    if (app::outlines(lines, session_.selection().ranges())
        && !SelectionMarks::isQuiet(session_)) // lines around letters hide them
        wish.selection = session_.selection();
    addDifferences(wish, pane);
    if (pane.among == 1)
        addErrors(wish);
    return wish;
}

std::chrono::microseconds Controller::patience()
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
