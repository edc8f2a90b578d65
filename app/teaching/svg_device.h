// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QPaintDevice>
#include <QSizeF>

#include <memory>

namespace app {

class SvgEngine;

/// Collects what is painted as elements of SVG with classes in place of colours (figure_svg.h).
/// Only lines, areas and texts: pictures, gradients and clips are left out.
class SvgDevice : public QPaintDevice {
public:
    using NameOfColour = QByteArray (*)(const QColor& colour);

    SvgDevice(const QSizeF& size, NameOfColour nameOfColour);
    ~SvgDevice() override;

    const QByteArray& elements() const; ///< so far
    QPaintEngine* paintEngine() const override;

protected:
    int metric(PaintDeviceMetric metric) const override;

private:
    QSizeF size_;
    std::unique_ptr<SvgEngine> engine_;
};

} // namespace app
