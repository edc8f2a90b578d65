// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>

#include <functional>
#include <vector>

// The texts that something paints, and where, instead of its pixels.

struct PaintedText {
    QString text;
    QRectF place; ///< in pixels
    QColor colour;
    QFont font;
};

/// Records texts, and paints nothing.
class TextRecorder : public QPaintEngine {
public:
    TextRecorder() : QPaintEngine(AllFeatures) {}

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState& next) override
    {
        if (next.state() & DirtyTransform)
            transform_ = next.transform();
        if (next.state() & DirtyPen)
            pen_ = next.pen();
    }
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawPath(const QPainterPath&) override {}
    void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
    void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override
    {
    }
    /// A text comes in parts where the writing system or the font changes.
    void drawTextItem(const QPointF& at, const QTextItem& item) override
    {
        const QRectF place = transform_.mapRect(
            QRectF(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent()));
        constexpr double gap = 1; // pixel
        if (!texts.empty()) {
            PaintedText& last = texts.back();
            if (std::abs(last.place.right() - place.left()) < gap
                && std::abs(last.place.center().y() - place.center().y()) < gap) {
                last.text += item.text();
                last.place |= place;
                return;
            }
        }
        texts.push_back({item.text(), place, pen_.color(), item.font()});
    }

    std::vector<PaintedText> texts;

private:
    QTransform transform_;
    QPen pen_;
};

class TextDevice : public QPaintDevice {
public:
    explicit TextDevice(const QSize& size) : size_(size) {}
    QPaintEngine* paintEngine() const override { return &recorder_; }
    std::vector<PaintedText> texts() const { return recorder_.texts; }

protected:
    int metric(PaintDeviceMetric which) const override
    {
        constexpr int dotsPerInch = 96;
        switch (which) {
        case PdmWidth:
            return size_.width();
        case PdmHeight:
            return size_.height();
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return dotsPerInch;
        case PdmDepth:
            return 32;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return int(devicePixelRatioFScale());
        default:
            return 0;
        }
    }

private:
    QSize size_;
    mutable TextRecorder recorder_;
};

inline std::vector<PaintedText> textsPainted(const QSize& size,
                                             const std::function<void(QPainter&)>& paint)
{
    TextDevice device(size);
    QPainter painter(&device);
    paint(painter);
    painter.end();
    return device.texts();
}

inline QStringList wordsOf(const std::vector<PaintedText>& texts)
{
    QStringList words;
    for (const PaintedText& text : texts)
        words << text.text;
    return words;
}
