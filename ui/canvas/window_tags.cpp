// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/window_tags.h"

#include "app/document/window_shape.h"
#include "app/session/window_operations.h"
#include "app/session/window_words.h"
#include "ui/look/look.h"
#include "ui/tools/shape_drawing.h"

#include <QFontMetricsF>

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

QColor colourOf(const app::ClipWindow& window, const Controller& controller)
{
    return window.colour ? shownColour(*window.colour, controller.bench())
                         : controller.paperLook().accent;
}

std::vector<WindowTag> windowTags(const Controller& controller, const QFont& font)
{
    const app::Session& session = controller.session();
    const auto& list = session.windows().list;
    std::vector<WindowTag> tags;
    if (list.size() > most || !controller.toolInfo().showsHandles())
        return tags;
    const QFontMetricsF metrics(captionFont(font));
    const app::Point room = controller.view().size;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!list[i].visible || i == session.windowNumber() || app::isEmpty(list[i].shape))
            continue;
        const QString text = textOf(list[i], metrics);
        const double width = metrics.horizontalAdvance(text) + 2 * besideText;
        const QRectF place = placeOf(list[i], controller.view(), width);
        if (place.intersects({0, 0, room.x, room.y}))
            tags.push_back({place, text, colourOf(list[i], controller), i});
    }
    return tags;
}

void paintTags(QPainter& painter, const Controller& controller)
{
    const auto tags = windowTags(controller, painter.font());
    painter.save();
    painter.setFont(captionFont(painter.font()));
    painter.setBrush(controller.pageColour());
    for (const auto& [place, text, colour, number] : tags) {
        painter.setPen(QPen(colour, 1));
        painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        painter.drawText(place, Qt::AlignCenter, text);
    }
    painter.restore();
}

} // namespace ui
