// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace ui {

/// Fusion without gradients, bevels and frames inside frames: flat fields and buttons, tabs with a
/// line in the selection colour, tool bars and status bar separated by one rule.
class LookStyle : public QProxyStyle {
    Q_OBJECT

public:
    LookStyle();

    /// The wheel changes no field, list or tab that it only passes: what is around them scrolls.
    void polish(QWidget* widget) override;
    void unpolish(QWidget* widget) override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                            QPainter* painter, const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option,
                    const QWidget* widget) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                           const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* answer) const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void drawMenuButton(const QStyleOptionToolButton& button, QPainter& painter,
                        const QWidget* widget) const;
};

} // namespace ui
