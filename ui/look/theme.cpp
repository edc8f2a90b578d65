// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look.h"
#include "ui/look/look_style.h"

namespace ui {
namespace {

QPalette paletteOf(const Look& look)
{
    QPalette palette;
    const auto set = [&](QPalette::ColorRole role, const QColor& colour) {
        palette.setColor(role, colour);
    };
    set(QPalette::Window, look.window);
    set(QPalette::WindowText, look.text);
    set(QPalette::Base, look.base);
    set(QPalette::AlternateBase, look.panel);
    set(QPalette::Text, look.text);
    set(QPalette::PlaceholderText, look.muted);
    set(QPalette::Button, look.panel);
    set(QPalette::ButtonText, look.text);
    set(QPalette::BrightText, look.differs);
    set(QPalette::Highlight, look.selection);
    set(QPalette::HighlightedText, look.onSelection);
    set(QPalette::Link, look.selection);
    set(QPalette::LinkVisited, look.selection);
    set(QPalette::ToolTipBase, look.base);
    set(QPalette::ToolTipText, look.text);
    set(QPalette::Light, look.panel);
    set(QPalette::Midlight, look.hover);
    set(QPalette::Mid, look.rule);
    set(QPalette::Dark, look.border);
    set(QPalette::Shadow, look.control);
    QColor faint = look.text;
    faint.setAlphaF(0.45F);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, faint);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, look.border);
    return palette;
}

QString styleSheet(const Look& look)
{
    return QStringLiteral(R"(
        QMenuBar { background: %1; padding: 2px 4px; }
        QMenuBar::item { padding: 3px 8px; border-radius: 3px; }
        QMenuBar::item:selected { background: %2; color: %3; }
        QToolTip { background: %4; color: %3; border: 1px solid %5; padding: 3px; }
        QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
        QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
        QScrollBar::handle { background: %6; border-radius: 3px; margin: 2px; }
        QScrollBar::handle:vertical { min-height: 24px; }
        QScrollBar::handle:horizontal { min-width: 24px; }
        QScrollBar::handle:hover { background: %7; }
        QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
        QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
    )")
        .arg(look.window.name(), look.tint.name(), look.text.name(), look.base.name(),
             look.border.name(), look.control.name(), look.muted.name());
}

} // namespace

void applyTheme(QApplication& application, Theme theme)
{
    if (!qobject_cast<LookStyle*>(application.style()))
        QApplication::setStyle(new LookStyle); // the application takes ownership
    QApplication::setPalette(QPalette());      // back to the desktop's palette, to query it
    const Look& look = lookOf(theme);
    QApplication::setPalette(paletteOf(look));
    application.setStyleSheet(styleSheet(look));
}

} // namespace ui
