// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings/remembered.h"

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QPalette>

namespace ui {

/// Every colour of the program, light or dark; only look.cpp contains colour values. The accent is
/// used for the clip window alone, the selection colour for selected, hovered and focused items.
/// The theme decides about panels, bars and rulers; the paper decides about everything that lies on
/// the drawing (lookOnPaper).
struct Look {
    bool dark;
    QColor window, panel, base, paper;
    QColor canvas; ///< around the page
    /// Dividers; outlines of what only shows, and of what is disabled; borders of fields, buttons
    /// and all that can be clicked, which everyone must see (3:1).
    QColor rule, border, control;
    QColor text, muted;
    QColor accent, onAccent;
    QColor selection, onSelection, tint; ///< tint: the background of a selected row
    QColor hover;
    QColor differs; ///< differing lines, which are always also thicker and counted in words
    QColor warning, warningGround, good;
    QColor guide, guideGround; ///< snapping, smart guides and distances; the ground of their words
    QColor grid, gridMajor;
    double ghost; ///< opacity of the removed part, 0 to 1
};

/// The light or the dark look, whichever matches the palette.
const Look& lookOf(const QPalette& palette);

enum class Theme : std::uint8_t { System, Light, Dark };

/// The look of a theme. System: the one that matches the application's palette.
const Look& lookOf(Theme theme);

/// The look of what lies on the drawing's paper: handles, windows, marks, labels, grid, ghosts. The
/// light one on white paper and the dark one on dark paper, in both themes.
const Look& lookOnPaper(bool dark);

/// Sets style, palette and style sheet of the whole program (theme.cpp).
void applyTheme(QApplication& application, Theme theme);

/// Distances in logical pixels.
namespace space {
constexpr int dockMargin = 12, labelToField = 8, betweenGroups = 16;
constexpr int optionsHeight = 40, dockTitleHeight = 28, rowHeight = 26, denseRowHeight = 22,
              fieldHeight = 26, statusHeight = 26, toolButton = 30, toolBarWidth = 44, radius = 3;
} // namespace space

/// The font in another size and weight.
QFont scaledFont(QFont font, double factor, QFont::Weight weight = QFont::Normal);
/// Table, status and caption text is 0.92 times the body font's size.
QFont captionFont(const QFont& body);
/// Gives the widget that font of the program's font, and keeps it so: a font that is only set is
/// lost when a widget without a parent gets one, or the style sheet changes (Qt 6.4).
void wearFont(QWidget& widget, double factor, QFont::Weight weight = QFont::Normal);
void wearCaption(QWidget& widget);
QFont semiBold(QFont font);

/// The border and the sentence of a field whose value was refused.
QColor errorColour(const Look& look);

/// The theme stored in the settings; by default the desktop's.
inline Theme savedTheme()
{
    return Theme(app::rememberedNumber(QStringLiteral("theme"), int(Theme::System),
                                       int(Theme::Dark), int(Theme::System)));
}

} // namespace ui
