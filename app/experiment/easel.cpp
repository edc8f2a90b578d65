// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/easel.h"

#include "app/experiment/checksum.h"

#include <QImage>
#include <QPainter>
#include <QtMath>

namespace app {
namespace {

class RasterEasel : public Easel {
public:
    explicit RasterEasel(const Field& field) : corner_(field.space.min)
    {
        const glm::dvec2 size = field.space.max - field.space.min;
        scale_ = std::min(1920 / size.x, 1440 / size.y);
        image_ = QImage(qCeil(size.x * scale_), qCeil(size.y * scale_), QImage::Format_RGB32);
        wipe();
    }

    QString name() const override
    {
        return QStringLiteral("raster, Qt %1").arg(QLatin1StringView(qVersion()));
    }
    void wipe() override { image_.fill(Qt::black); }
    void draw(std::span<const clipping::Clipped> lines) override
    {
        QPainter painter(&image_);
        painter.setPen(QPen(Qt::white, 0)); // one pixel
        constexpr std::size_t most = 1024;  // fits the first cache
        std::vector<QLineF> some;
        some.reserve(most);
        for (; !lines.empty(); lines = lines.subspan(some.size())) {
            some.clear();
            for (const auto& line : lines.first(std::min(most, lines.size())))
                some.emplace_back(shown(line.segment.a), shown(line.segment.b));
            painter.drawLines(some.data(), int(some.size()));
        }
    }
    std::uint64_t checksum() const override
    {
        std::uint64_t sum = 0;
        for (int y = 0; y < image_.height(); ++y) {
            const auto* row = reinterpret_cast<const QRgb*>(image_.constScanLine(y));
            for (int x = 0; x < image_.width(); ++x)
                sum = (sum ^ row[x]) * 0x100000001b3; // FNV: quick, and the place counts
        }
        return mixed(sum);
    }

private:
    QPointF shown(const glm::dvec2& p) const
    {
        return {(p.x - corner_.x) * scale_, (p.y - corner_.y) * scale_};
    }

    glm::dvec2 corner_;
    double scale_ = 1;
    QImage image_;
};

} // namespace

std::unique_ptr<Easel> rasterEasel(const Field& field)
{
    return std::make_unique<RasterEasel>(field);
}

} // namespace app
