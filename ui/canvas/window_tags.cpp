// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/window_tags.h"

#include "app/document/window_operations.h"
#include "app/document/window_shape.h"
#include "app/session/window_words.h"
#include "app/view/area_at.h"
#include "ui/look/look.h"
#include "ui/tools/picking_marks.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/window_gesture.h"

#include <QFontMetricsF>
#include <QGuiApplication>

namespace ui {
namespace {

constexpr double tagHeight = 18, belowFrame = 6, besideText = 6; // pixels
constexpr int widest = 160;
constexpr std::size_t most = 30;

QString textOf(const app::ClipWindow& window, const QFontMetricsF& metrics)
{
    const QString name = app::nameOf(window);
    const QString text = window.operation == app::WindowOperation::Add
                             ? name
                             : app::infoOf(window.operation).sign + u' ' + name;
    return metrics.elidedText(text, Qt::ElideRight, widest);
}

// In the middle of a window that is cut out, where nothing is kept; below any other one.
QRectF placeOf(const app::ClipWindow& window, const app::View& view, double width)
{
    const clipping::Window box = app::boxOf(window.shape);
    const app::Point min = view.toScreen(box.min), max = view.toScreen(box.max);
    QRectF place(min.x, max.y + belowFrame, width, tagHeight);
    const bool roomy =
        max.x - min.x > width + 2 * belowFrame && max.y - min.y > tagHeight + 2 * belowFrame;
    if (window.operation == app::WindowOperation::CutOut && roomy)
        place.moveCenter({(min.x + max.x) / 2, (min.y + max.y) / 2});
    return place;
}

} // namespace

QColor colourOf(const app::ClipWindow& window, const Workbench& bench)
{
    return window.colour ? shownColour(*window.colour, bench) : bench.look.accent;
}

std::vector<WindowTag> windowTags(const HeldTool& held, const QFont& font)
{
    const app::Session& session = held.session();
    const auto& list = session.windows().list;
    std::vector<WindowTag> tags;
    if (list.size() > most || !held.info().showsHandles())
        return tags;
    const QFontMetricsF metrics(captionFont(font));
    const app::Point room = held.view().size;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!list[i].visible || i == session.windowNumber() || app::isEmpty(list[i].shape))
            continue;
        const QString text = textOf(list[i], metrics);
        const double width = metrics.horizontalAdvance(text) + 2 * besideText;
        const QRectF place = placeOf(list[i], held.view(), width);
        if (place.intersects({0, 0, room.x, room.y}))
            tags.push_back({place, text,
                            app::replacing(session.windows(), i) ? held.bench().look.muted
                                                                 : colourOf(list[i], held.bench()),
                            i});
    }
    return tags;
}

void paintTags(QPainter& painter, const HeldTool& held)
{
    const auto tags = windowTags(held, painter.font());
    painter.save();
    painter.setFont(captionFont(painter.font()));
    painter.setBrush(held.bench().look.paper);
    for (const auto& [place, text, colour, number] : tags) {
        painter.setPen(QPen(colour, 1));
        painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        painter.drawText(place, Qt::AlignCenter, text);
    }
    painter.restore();
}

std::optional<std::size_t> nameAt(const QPointF& screen, const HeldTool& held)
{
    if (held.busy() || !held.session().clipWindow())
        return std::nullopt;
    std::optional<std::size_t> uppermost;
    for (const WindowTag& tag : windowTags(held, QGuiApplication::font()))
        if (tag.place.contains(screen))
            uppermost = tag.number;
    return uppermost;
}

std::optional<std::size_t> tagAt(const QPointF& screen, const HeldTool& held)
{
    const bool selects = held.info().key == "select"; // others begin something there
    return selects && !windowHandleAt({screen.x(), screen.y()}, held.bench()) ? nameAt(screen, held)
                                                                              : std::nullopt;
}

bool chooseWindowAt(const QPointF& screen, HeldTool& held)
{
    constexpr double outlineReach = 4; // pixels
    app::Session& session = held.session();
    const Workbench& bench = held.bench();
    const app::Point at{screen.x(), screen.y()}, there = held.view().toDrawing(at);
    const auto object = pickedAt(there, bench).object;
    if (object && session.selection().contains(*object))
        return false;
    if (held.info().showsHandles() && windowHandleAt(at, bench))
        return true; // of the one that tools act on
    auto number = nameAt(screen, held);
    if (!number && !object)
        number = app::windowBorderAt(session.windows(), there, bench.inDrawing(outlineReach));
    if (number)
        session.chooseWindow(*number);
    return number.has_value();
}

} // namespace ui
