// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/svg_device.h"

#include <QPaintEngine>

namespace app {

/// Writes an element for each call of the painter.
class SvgEngine : public QPaintEngine {
public:
    explicit SvgEngine(SvgDevice::NameOfColour nameOfColour)
        : QPaintEngine(AllFeatures), nameOfColour_(nameOfColour)
    {
    }

    const QByteArray& elements() const { return elements_; }

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState& state) override;
    void drawLines(const QLineF* lines, int count) override;
    void drawRects(const QRectF* rects, int count) override;
    void drawEllipse(const QRectF& box) override;
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override;
    void drawPath(const QPainterPath& path) override;
    void drawTextItem(const QPointF& at, const QTextItem& item) override;
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}

private:
    void write(const QByteArray& name, const QByteArray& with, const QByteArray& text = {});
    QByteArray place() const;
    QByteArray stroke() const;
    QByteArray area() const;
    QByteArray strokeClass() const;
    QByteArray strokeStyle() const;

    SvgDevice::NameOfColour nameOfColour_;
    QByteArray elements_;
    QPen pen_;
    QBrush brush_;
    QTransform transform_;
};

} // namespace app
