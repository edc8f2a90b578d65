// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/random.h"
#include "app/experiment/draw_target.h"

#include <QImage>
#include <QPainter>

namespace app {
namespace {

class RasterTarget final : public DrawTarget {
public:
    explicit RasterTarget(const Field& field)
        : corner_(field.space.min), scale_(fitOf(field).scale),
          image_(fitOf(field).size, QImage::Format_RGB32)
    {
        wipe();
    }

    QString name() const override
    {
        return QStringLiteral("raster, Qt %1").arg(QLatin1StringView(qVersion()));
    }
    bool drawsElsewhere() const override { return false; }
    void wipe() override { image_.fill(Qt::black); }
    void draw(std::span<const clipping::Clipped> lines) override
    {
        QPainter painter(&image_);
        painter.setPen(QPen(Qt::white, 0)); // one pixel
        constexpr std::size_t most = 1024;  // fits the first-level cache
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
        const auto* pixels = reinterpret_cast<const std::uint32_t*>(image_.constBits());
        return checksumOf({pixels, std::size_t(image_.width()) * std::size_t(image_.height())});
    }

private:
    QPointF shown(const glm::dvec2& p) const
    {
        return {(p.x - corner_.x) * scale_, (p.y - corner_.y) * scale_};
    }

    glm::dvec2 corner_;
    double scale_;
    QImage image_;
};

} // namespace

std::unique_ptr<DrawTarget> rasterTarget(const Field& field)
{
    return std::make_unique<RasterTarget>(field);
}

} // namespace app
