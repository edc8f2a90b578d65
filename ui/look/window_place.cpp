// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/window_place.h"

#include "app/settings/window_place.h"

#include <QGuiApplication>
#include <QScreen>
#include <QSettings>
#include <QWidget>

#include <vector>

namespace ui {
namespace {

/// The available area of each screen, the window's screen first.
std::vector<QRect> screensFor(const QWidget& window)
{
    std::vector<QRect> all{window.screen()->availableGeometry()};
    for (const QScreen* screen : QGuiApplication::screens())
        all.push_back(screen->availableGeometry());
    return all;
}

} // namespace

void restorePlace(QWidget& window, const QString& key, const QSize& usual, const QSize& smallest)
{
    window.setMinimumSize(smallest.boundedTo(app::roomOn(screensFor(window).front())));
    window.resize(usual);
    if (const auto place = app::placeFrom(QSettings().value(key).toString())) {
        window.resize(place->rect.size());
        window.move(place->rect.topLeft());
        fitToScreens(window);
        if (place->maximized)
            window.setWindowState(window.windowState() | Qt::WindowMaximized);
    } else
        window.resize(usual.boundedTo(app::roomOn(screensFor(window).front())));
}

void fitToScreens(QWidget& window)
{
    const QRect now(window.pos(), window.size()), place = app::fitted(now, screensFor(window));
    window.resize(place.size());
    if (place.topLeft() != now.topLeft())
        window.move(place.topLeft());
}

void rememberPlace(const QWidget& window, const QString& key)
{
    const bool filling = window.isMaximized() || window.isFullScreen();
    const QRect rect = filling ? window.normalGeometry() : QRect(window.pos(), window.size());
    QSettings().setValue(key, app::placeText({rect, window.isMaximized()}));
}

} // namespace ui
