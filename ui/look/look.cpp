// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look.h"

#include "ui/look/look_style.h"

namespace ui {

namespace {

const Look light{.dark = false,
                 .window = 0xEFF0F2,
                 .panel = 0xF8F9FA,
                 .base = 0xFFFFFF,
                 .canvas = 0xDEE1E5,
                 .paper = 0xFFFFFF,
                 .rule = 0xD0D4DA,
                 .border = 0xAEB5BF,
                 .control = 0x858C96,
                 .text = 0x1B1E23,
                 .muted = 0x565D67,
                 .accent = 0xC2410C,
                 .onAccent = 0xFFFFFF,
                 .selection = 0x1D63C9,
                 .onSelection = 0xFFFFFF,
                 .tint = 0xDCE8FA,
                 .hover = 0xE4E7EB,
                 .differs = 0xA80F86,
                 .warning = 0x6E4600,
                 .warningGround = 0xFFF1CC,
                 .good = 0x1B6A3F,
                 .ghost = 0.32};

const Look dark{.dark = true,
                .window = 0x26282C,
                .panel = 0x2B2D32,
                .base = 0x1E2024,
                .canvas = 0x141517,
                .paper = 0x1E2023,
                .rule = 0x3A3D44,
                .border = 0x5C626C,
                .control = 0x858C97,
                .text = 0xE7E9EC,
                .muted = 0xA6ACB6,
                .accent = 0xFF8F52,
                .onAccent = 0x1B1E23,
                .selection = 0x5B9BFF,
                .onSelection = 0x10131A,
                .tint = 0x2C3F60,
                .hover = 0x35383E,
                .differs = 0xFF85E4,
                .warning = 0xFFD479,
                .warningGround = 0x3A3118,
                .good = 0x7BD3A0,
                .ghost = 0.34};

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
        QScrollBar::handle { background: %5; border-radius: 3px; margin: 2px; }
        QScrollBar::handle:vertical { min-height: 24px; }
        QScrollBar::handle:horizontal { min-width: 24px; }
        QScrollBar::handle:hover { background: %6; }
        QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
        QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
    )")
        .arg(look.window.name(), look.tint.name(), look.text.name(), look.base.name(),
             look.border.name(), look.control.name());
}

} // namespace

const Look& lookOf(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < 128 ? dark : light;
}

void applyTheme(QApplication& application, Theme theme)
{
    if (!qobject_cast<LookStyle*>(application.style()))
        QApplication::setStyle(new LookStyle); // the application takes ownership
    QApplication::setPalette(QPalette());      // back to the desktop's palette, to query it
    const bool wantsDark =
        theme == Theme::Dark || (theme == Theme::System && lookOf(QApplication::palette()).dark);
    const Look& look = wantsDark ? dark : light;
    QApplication::setPalette(paletteOf(look));
    application.setStyleSheet(styleSheet(look));
}

QFont captionFont(const QFont& body)
{
    QFont font = body;
    if (body.pixelSize() > 0)
        font.setPixelSize(qRound(body.pixelSize() * 0.92));
    else
        font.setPointSizeF(body.pointSizeF() * 0.92);
    return font;
}

QFont semiBold(QFont font)
{
    font.setWeight(QFont::DemiBold);
    return font;
}

} // namespace ui
