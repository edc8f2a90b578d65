// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/window_place.h"

#include <QRegularExpression>

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace app {
namespace {

constexpr QSize frame(8, 40); // of a common desktop
constexpr int most = 100'000; // pixels

} // namespace

QString placeText(const WindowPlace& place)
{
    return QStringLiteral("%1,%2 %3x%4%5")
        .arg(place.rect.x())
        .arg(place.rect.y())
        .arg(place.rect.width())
        .arg(place.rect.height())
        .arg(place.maximized ? QStringLiteral(" maximized") : QString());
}

std::optional<WindowPlace> placeFrom(const QString& text)
{
    static const QRegularExpression form(
        QStringLiteral("^(-?\\d{1,6}),(-?\\d{1,6}) (\\d{1,6})x(\\d{1,6})( maximized)?$"));
    const auto match = form.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    const auto number = [&](int part) { return match.captured(part).toInt(); };
    const int x = number(1), y = number(2), width = number(3), height = number(4);
    if (std::max(std::abs(x), std::abs(y)) > most || std::min(width, height) < 1
        || std::max(width, height) > most)
        return std::nullopt;
    return WindowPlace{{x, y, width, height}, match.hasCaptured(5)};
}

QSize roomOn(const QRect& screen) { return (screen.size() - frame).expandedTo({1, 1}); }

QRect fitted(const QRect& wanted, std::span<const QRect> screens)
{
    assert(!screens.empty());
    const auto under = std::ranges::find_if(
        screens, [&](const QRect& screen) { return screen.contains(wanted.center()); });
    const QRect screen = under == screens.end() ? screens.front() : *under;
    const QSize size = wanted.size().boundedTo(roomOn(screen));
    const QPoint last = screen.topLeft()
                        + QPoint(screen.width() - size.width() - frame.width(),
                                 screen.height() - size.height() - frame.height());
    return {{std::max(screen.x(), std::min(wanted.x(), last.x())),
             std::max(screen.y(), std::min(wanted.y(), last.y()))},
            size};
}

} // namespace app
