// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_places.h"

#include "app/base/text.h"
#include "app/scene/bounds.h"
#include "app/session/units.h"
#include "app/session/window_steps.h"

#include <QCoreApplication>

#include <array>

namespace app {
namespace {

std::optional<clipping::Window> page(const Session& session)
{
    return session.now().page().rectangle();
}

std::optional<clipping::Window> selection(const Session& session)
{
    return session.selectionBounds();
}

std::optional<clipping::Window> layer(const Session& session)
{
    const ObjectRange range = session.now().containers().rangeOf(layerForNew(session));
    return range.first == range.end ? std::nullopt
                                    : boundsOf(session.scene.lines(), ObjectRanges(range));
}

QString noName(const Session&) { return {}; }
QString layerName(const Session& session)
{
    return session.now().containers()[layerForNew(session)].name;
}

constexpr std::array places{
    LayingPlace{"window-on-page", QT_TRANSLATE_NOOP("Text", "&Lay window on page"),
                QT_TRANSLATE_NOOP("Text", "Lay clip window on page"), "", page, noName},
    LayingPlace{"window-on-selection", QT_TRANSLATE_NOOP("Text", "Lay window o&n selection"),
                QT_TRANSLATE_NOOP("Text", "Lay clip window on selection"),
                QT_TRANSLATE_NOOP("Text", "Nothing is selected. Select objects first."), selection,
                noName},
    LayingPlace{"window-on-layer", QT_TRANSLATE_NOOP("Text", "Lay window on la&yer"),
                QT_TRANSLATE_NOOP("Text", "Lay clip window on layer"),
                QT_TRANSLATE_NOOP("Text",
                                  "The current layer is empty. Select another one in the panel "
                                  "Layers."),
                layer, layerName},
};

void lay(Session& session, const clipping::Window& box, const QString& name, const QString& text)
{
    const auto& list = session.now().windows().list;
    const RectangleShape shape{box};
    if (list.size() == 1 && session.windowNumber() && axisAlignedBox(list.front().shape))
        setWindowShape(session, shape, text);
    else
        addWindows(session, {{.name = name, .shape = shape}}, text);
}

} // namespace

std::span<const LayingPlace> windowPlaces() { return places; }

void layWindow(Session& session, const LayingPlace& place)
{
    if (const auto box = place.box(session))
        lay(session, *box, place.name(session), Text::tr(place.step.data()));
}

std::optional<QString> layWindowInside(Session& session, const PageMargins& margins)
{
    const clipping::Window page = session.now().page().rectangle();
    const clipping::Window inside{page.min + Point(margins.left, margins.top),
                                  page.max - Point(margins.right, margins.bottom)};
    if (!(inside.min.x < inside.max.x && inside.min.y < inside.max.y))
        return Text::tr("The margins leave nothing of the page. Type smaller ones.");
    lay(session, inside, {}, Text::tr("Lay clip window inside the margin"));
    return std::nullopt;
}

} // namespace app
