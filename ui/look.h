// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QPalette>

namespace ui {

/// Every colour of the program, light or dark; nothing outside look.cpp spells one. The accent
/// means the clip window and nothing else, the selection what is chosen, lit or focused.
struct Look {
    bool dark;
    QColor window, panel, base, canvas, paper;
    QColor rule, border, control; ///< dividers; fields; check and radio outlines
    QColor text, muted;
    QColor accent, onAccent;
    QColor selection, onSelection, tint; ///< tint: the ground of a chosen row
    QColor hover;
    QColor differs; ///< what differs, always thicker and counted in words too
    QColor warning, warningGround, good;
    double ghost; ///< opacity of the removed part
};

/// The look that belongs to a palette: the light or the dark one.
const Look& lookOf(const QPalette& palette);

enum class Theme : std::uint8_t { System, Light, Dark };

/// Sets style, palette and style sheet of the whole program.
void applyTheme(QApplication& application, Theme theme);

/// Distances in logical pixels.
namespace space {
constexpr int dockMargin = 12, labelToField = 8, betweenGroups = 16;
constexpr int optionsHeight = 40, dockTitleHeight = 28, rowHeight = 26, denseRowHeight = 22,
              fieldHeight = 26, statusHeight = 26, toolButton = 30, toolBarWidth = 44, radius = 3;
} // namespace space

/// The body font times look.md's factors: tables, status and captions are 0.92 of it.
QFont captionFont(const QFont& body);
QFont semiBold(QFont font);

} // namespace ui
