// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/controller.h"

// The content of a frame.

namespace ui {

static app::Colour colourOf(const QColor& c)
{
    return {std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue())};
}

QColor Controller::pageColour() const { return paperLook_.paper; }

double Controller::ghostOpacity() const
{
    return session_.display().presenting ? 1 : paperLook_.ghost;
}

const app::Differences* Controller::differing(const Pane& pane) const
{
    const auto window = session_.comparedAt();
    return pane.fromExact && window ? pane.fromExact->at(*window) : nullptr;
}

/// Colours lines by their error class; wrong lines are marked like differing ones.
void Controller::addErrors(app::PictureOptions& options) const
{
    const auto pieces = session_.exactness.piecesAt(window());
    if (pieces.empty())
        return;
    const app::Ground ground = paperLook_.dark ? app::Ground::Dark : app::Ground::Light;
    for (std::size_t row = 0; row + 1 < pieces.size(); ++row)
        options.graded.push_back(
            {pieces[row], colourOf(app::errorColour(row, ground, paperLook_.differs))});
    if (options.differing.empty())
        options.differing = pieces.back();
}

app::Picture Controller::picture(const app::SceneFrame& frame, const Pane& pane,
                                 double pixelRatio) const
{
    const app::Display& display = session_.display();
    app::PictureOptions options;
    options.view = view();
    options.removed = display.removed;
    options.region = &session_.region();
    options.closesAreas = display.cutting.closeAreas;
    options.leastLength = exportOptions(display.cutting, session_.now().page()).leastLength;
    if (paperLook_.dark)
        options.page = colourOf(paperLook_.paper);
    options.leastWidth = pixelRatio < 1.5 ? 0.75 : 0.5;
    if (display.presenting) {
        options.strokes = 2;
        options.ghosting = app::Ghosting{colourOf(pageColour()), paperLook_.ghost};
    }
    options.selection = session_.selection().ranges();
    options.light = colourOf(paperLook_.selection);
    options.paper = colourOf(pageColour());
    if (const app::Differences* differences = differing(pane))
        options.differing = differences->pieces;
    else if (pane.among == 1)
        options.differing = session_.differences.piecesAt(window());
    if (pane.among == 1)
        addErrors(options);
    options.marked = colourOf(paperLook_.differs);
    if (paperLook_.dark) // magenta is close to the selection's blue in the dark look
        options.ticks = app::PictureOptions::Ticks::Everywhere;
    return app::picture(session_.now().styles(), session_.scene.lines(), frame, options);
}

} // namespace ui
