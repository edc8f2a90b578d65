// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/svg_device.h"

#include "app/teaching/svg_engine.h"

#include <cmath>

namespace app {

SvgDevice::SvgDevice(const QSizeF& size, NameOfColour nameOfColour)
    : size_(size), engine_(std::make_unique<SvgEngine>(nameOfColour))
{
}
SvgDevice::~SvgDevice() = default;

const QByteArray& SvgDevice::elements() const { return engine_->elements(); }
QPaintEngine* SvgDevice::paintEngine() const { return engine_.get(); }

int SvgDevice::metric(PaintDeviceMetric metric) const
{
    constexpr double dotsPerInch = 96, millimetresPerInch = 25.4;
    switch (metric) {
    case PdmWidth:
        return int(std::ceil(size_.width()));
    case PdmHeight:
        return int(std::ceil(size_.height()));
    case PdmWidthMM:
        return int(size_.width() * millimetresPerInch / dotsPerInch);
    case PdmHeightMM:
        return int(size_.height() * millimetresPerInch / dotsPerInch);
    case PdmDpiX:
    case PdmDpiY:
    case PdmPhysicalDpiX:
    case PdmPhysicalDpiY:
        return int(dotsPerInch);
    case PdmDevicePixelRatio:
        return 1;
    default:
        return QPaintDevice::metric(metric);
    }
}

} // namespace app
