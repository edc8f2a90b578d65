// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/presenting_mode.h"

#include <QApplication>
#include <QWidget>

#include <utility>

namespace ui {

namespace {

constexpr double larger = 1.5; // factor of the font size

QFont enlarged(QFont font)
{
    if (font.pixelSize() > 0)
        font.setPixelSize(qRound(font.pixelSize() * larger));
    else
        font.setPointSizeF(font.pointSizeF() * larger);
    return font;
}

/// Existing widgets adopt a new font only with a new style sheet.
void setFontOfAll(const QFont& font)
{
    QApplication::setFont(font);
    qApp->setStyleSheet(qApp->styleSheet());
}

} // namespace

PresentingMode::~PresentingMode()
{
    if (fontBefore_)
        QApplication::setFont(*fontBefore_);
}

void PresentingMode::enter()
{
    fontBefore_ = QApplication::font();
    statesBefore_ = window_.window()->windowState();
    setFontOfAll(enlarged(*fontBefore_));
    window_.window()->setWindowState(statesBefore_ | Qt::WindowFullScreen);
}

void PresentingMode::leave()
{
    setFontOfAll(*std::exchange(fontBefore_, std::nullopt));
    window_.window()->setWindowState(statesBefore_);
}

} // namespace ui
