// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look.h"

#include <QApplication>
#include <QEvent>
#include <QWidget>

#include <functional>

namespace ui {

namespace {

const Look light{.dark = false,
                 .window = 0xEFF0F2,
                 .panel = 0xF8F9FA,
                 .base = 0xFFFFFF,
                 .paper = 0xFFFFFF,
                 .canvas = 0xDEE1E5,
                 .rule = 0xD0D4DA,
                 .border = 0xAEB5BF,
                 .control = 0x777F89,
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
                 .guide = 0x086661,
                 .guideGround = 0xDDF1EF,
                 .grid = 0xEDEFF2,
                 .gridMajor = 0xDDE1E6,
                 .ghost = 0.3};

const Look dark{.dark = true,
                .window = 0x26282C,
                .panel = 0x2B2D32,
                .base = 0x1E2024,
                .paper = 0x1E2023,
                .canvas = 0x141517,
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
                .guide = 0x4CC9BF,
                .guideGround = 0x1F3B3A,
                .grid = 0x26282C,
                .gridMajor = 0x303338,
                .ghost = 0.42};

} // namespace

const Look& lookOf(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < 128 ? dark : light;
}

const Look& lookOf(Theme theme)
{
    if (theme == Theme::System)
        return lookOf(QApplication::palette());
    return theme == Theme::Dark ? dark : light;
}

const Look& lookOnPaper(bool dark) { return lookOf(dark ? Theme::Dark : Theme::Light); }

QColor errorColour(const Look& look) { return look.dark ? 0xFF9A9A : 0xA3161B; }

QFont scaledFont(QFont font, double factor, QFont::Weight weight)
{
    if (font.pixelSize() > 0)
        font.setPixelSize(qRound(font.pixelSize() * factor));
    else
        font.setPointSizeF(font.pointSizeF() * factor);
    font.setWeight(weight);
    return font;
}

QFont captionFont(const QFont& body)
{
    constexpr double smaller = 0.92;
    return scaledFont(body, smaller, body.weight());
}

namespace {

class WornFont : public QObject {
public:
    WornFont(QWidget& widget, std::function<QFont(const QFont&)> of)
        : QObject(&widget), widget_(widget), of_(std::move(of))
    {
        widget.installEventFilter(this);
        wear();
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
            wear();
        return false;
    }

private:
    void wear()
    {
        if (const QFont font = of_(QApplication::font()); widget_.font() != font)
            widget_.setFont(font);
    }

    QWidget& widget_;
    std::function<QFont(const QFont&)> of_;
};

} // namespace

void wearFont(QWidget& widget, double factor, QFont::Weight weight)
{
    new WornFont(widget, [=](const QFont& body) { return scaledFont(body, factor, weight); });
}

void wearCaption(QWidget& widget) { new WornFont(widget, captionFont); }

QFont semiBold(QFont font)
{
    font.setWeight(QFont::DemiBold);
    return font;
}

} // namespace ui
