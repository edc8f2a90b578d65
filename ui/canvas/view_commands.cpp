// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/view_commands.h"

#include "app/scene/bounds.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace ui {

void fitDrawing(const app::Session& session, Navigation& view)
{
    const auto lines = app::boundsOf(session.scene.lines());
    lines ? view.show(*lines) : fitPage(session, view);
}

void fitPage(const app::Session& session, Navigation& view)
{
    clipping::Window all = session.now().page().rectangle();
    if (const auto lines = app::boundsOf(session.scene.lines()))
        all = {glm::min(all.min, lines->min), glm::max(all.max, lines->max)};
    view.show(all);
}

void fitSelection(const app::Session& session, Navigation& view)
{
    const auto& bounds = session.selectionBounds();
    bounds ? view.show(*bounds) : fitDrawing(session, view);
}

void fitWindow(const app::Session& session, Navigation& view)
{
    view.show(session.clipWindow().value_or(session.window()));
}

void zoomBy(double factor, Navigation& view)
{
    const app::Point size = view.view().size;
    view.zoomAt({size.x / 2, size.y / 2}, factor);
}

double zoomOf(const app::Session& session, const Navigation& view)
{
    const double pixel = app::infoOf(app::Unit::Px).millimetres;
    return view.view().zoom / (session.now().page().millimetresPerUnit() / pixel);
}

void setZoom(double zoom, const app::Session& session, Navigation& view)
{
    zoomBy(zoom / zoomOf(session, view), view);
}

namespace {

constexpr double zoomStep = 1.25;

/// A key and what it does to the view.
struct ViewKey {
    Qt::KeyboardModifiers with; ///< at least
    std::array<int, 4> keys;    ///< the key with Shift depends on the keyboard layout
    void (*change)(const app::Session& session, Navigation& view);
};

const std::array viewKeys{
    ViewKey{Qt::ControlModifier,
            {Qt::Key_Plus, Qt::Key_Equal},
            [](const app::Session&, Navigation& view) { zoomBy(zoomStep, view); }},
    ViewKey{Qt::ControlModifier,
            {Qt::Key_Minus, Qt::Key_Underscore},
            [](const app::Session&, Navigation& view) { zoomBy(1 / zoomStep, view); }},
    ViewKey{Qt::ControlModifier,
            {Qt::Key_0},
            [](const app::Session& session, Navigation& view) { setZoom(1, session, view); }},
    ViewKey{Qt::ShiftModifier, {Qt::Key_1, Qt::Key_Exclam}, fitDrawing},
    ViewKey{Qt::ShiftModifier, {Qt::Key_2, Qt::Key_At, Qt::Key_QuoteDbl}, fitSelection},
    ViewKey{Qt::ShiftModifier,
            {Qt::Key_3, Qt::Key_NumberSign, Qt::Key_sterling, Qt::Key_section},
            fitWindow},
    ViewKey{Qt::ShiftModifier, {Qt::Key_4, Qt::Key_Dollar, Qt::Key_currency}, fitPage},
    ViewKey{{}, {Qt::Key_QuoteLeft}, [](const app::Session&, Navigation& view) { view.back(); }},
    ViewKey{{}, {Qt::Key_AsciiTilde}, [](const app::Session&, Navigation& view) { view.forth(); }},
};

} // namespace

bool keyOfView(const QKeyEvent& event, const app::Session& session, Navigation& view)
{
    if (event.key() == 0) // of an input method
        return false;
    const auto found = std::ranges::find_if(viewKeys, [&](const ViewKey& row) {
        return (event.modifiers() & row.with) == row.with
               && std::ranges::find(row.keys, event.key()) != row.keys.end();
    });
    if (found == viewKeys.end() || (found->change == fitWindow && !session.clipWindow()))
        return false;
    found->change(session, view);
    return true;
}

} // namespace ui
