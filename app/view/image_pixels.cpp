// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/image_pixels.h"

#include <QBuffer>
#include <QImageReader>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <list>
#include <mutex>
#include <optional>

namespace app {
namespace {

constexpr qsizetype mostKept = 256'000'000;
constexpr int mostMegabytes = 512; // of one image while it is decoded, at up to 8 bytes a pixel
constexpr int lastLevel = 15;

QImage decoded(const ImageFile& file)
{
    QByteArray bytes = file.bytes; // shares them
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer, nameOf(file.kind));
    QImageReader::setAllocationLimit(mostMegabytes);
    reader.setAutoTransform(true);
    return reader.read();
}

/// Pixels that are kept, the latest ones first.
class KeptPixels {
public:
    /// One image after the other: several large ones would not fit into memory.
    QImage find(const std::shared_ptr<const ImageFile>& file, int level)
    {
        const std::scoped_lock lock(lock_);
        const auto found = std::ranges::find_if(kept_, [&](const Kept& kept) {
            return kept.level == level && kept.file.lock() == file;
        });
        if (found != kept_.end()) {
            kept_.splice(kept_.begin(), kept_, found);
            return found->image;
        }
        const QImage image = reduced(decoded(*file), level);
        kept_.push_front({file, level, image});
        forgetSome();
        return image;
    }
    bool isReadable(const ImageFile& file)
    {
        const std::scoped_lock lock(lock_);
        return !decoded(file).isNull();
    }

private:
    struct Kept {
        std::weak_ptr<const ImageFile> file;
        int level;
        QImage image;
    };

    static QImage reduced(QImage image, int level)
    {
        if (level > 0 && !image.isNull())
            image = image.scaled(std::max(1, image.width() >> level),
                                 std::max(1, image.height() >> level), Qt::IgnoreAspectRatio,
                                 Qt::SmoothTransformation);
        image.convertTo(image.hasAlphaChannel() ? QImage::Format_ARGB32_Premultiplied
                                                : QImage::Format_RGB32);
        return image;
    }
    void forgetSome()
    {
        kept_.remove_if([](const Kept& kept) { return kept.file.expired(); });
        qsizetype sum = 0;
        for (auto at = kept_.begin(); at != kept_.end();) {
            sum += at->image.sizeInBytes();
            at = sum > mostKept && at != kept_.begin() ? kept_.erase(at) : std::next(at);
        }
    }

    std::mutex lock_;
    std::list<Kept> kept_;
};

KeptPixels& keptPixels()
{
    static KeptPixels pixels;
    return pixels;
}

/// How often the image can be halved and still has a pixel for each of the device.
int levelFor(const QTransform& toDevice)
{
    const double scale = std::max(std::hypot(toDevice.m11(), toDevice.m12()),
                                  std::hypot(toDevice.m21(), toDevice.m22()));
    if (!(scale > 0))
        return lastLevel;
    return std::clamp(int(std::floor(-std::log2(scale) + 1e-9)), 0, lastLevel);
}

/// The pixels of the image that can be seen on the device, with a margin.
QRectF seenPixels(const ImageFile& file, const QPainter& painter, const QTransform& toDevice)
{
    const QRectF all(0, 0, file.width, file.height);
    bool isPossible = false;
    const QTransform back = toDevice.inverted(&isPossible);
    if (!isPossible)
        return {};
    const QRectF device = QRectF(0, 0, painter.device()->width(), painter.device()->height());
    constexpr double margin = 2; // device pixels, and pixels of the image
    const QRectF seen = back.mapRect(device.adjusted(-margin, -margin, margin, margin));
    return QRectF(seen.adjusted(-margin, -margin, margin, margin).toAlignedRect()).intersected(all);
}

/// The clip of an image that is neither turned nor skewed, in pixels of it, if it is a box: as such
/// it has smooth edges.
std::optional<QRectF> clippedPixels(const Underlay& underlay, const QTransform& toDrawing)
{
    const auto& clip = underlay.clip;
    if (clip.size() != 4 || underlay.place.x.y != 0 || underlay.place.y.x != 0)
        return std::nullopt;
    for (const int axis : {0, 1})
        for (std::size_t i = 0; i < 2; ++i)
            if (clip[i][axis] == clip[i + 2][axis])
                return std::nullopt;
    const bool isBox = (clip[0].x == clip[1].x && clip[1].y == clip[2].y && clip[2].x == clip[3].x
                        && clip[3].y == clip[0].y)
                       || (clip[0].y == clip[1].y && clip[1].x == clip[2].x
                           && clip[2].y == clip[3].y && clip[3].x == clip[0].x);
    if (!isBox)
        return std::nullopt;
    const QRectF box(QPointF(clip[0].x, clip[0].y), QPointF(clip[2].x, clip[2].y));
    return toDrawing.inverted().mapRect(box.normalized());
}

void clipTo(QPainter& painter, const std::vector<Point>& corners)
{
    QPolygonF polygon;
    for (const Point& corner : corners)
        polygon << QPointF(corner.x, corner.y);
    QPainterPath path;
    path.addPolygon(polygon);
    painter.setClipPath(path, Qt::IntersectClip);
}

} // namespace

QImage pixelsOf(const std::shared_ptr<const ImageFile>& file, int level)
{
    return keptPixels().find(file, level);
}

bool isReadable(const ImageFile& file) { return keptPixels().isReadable(file); }

void paintUnderlay(QPainter& painter, const Underlay& underlay, double opacity)
{
    const ImageFile& file = *underlay.file;
    const AffineMap& place = underlay.place;
    const QTransform toDrawing(place.x.x, place.x.y, place.y.x, place.y.y, place.to.x, place.to.y);
    const QTransform toDevice = toDrawing * painter.combinedTransform();
    const auto box = clippedPixels(underlay, toDrawing);
    QRectF seen = seenPixels(file, painter, toDevice);
    if (box)
        seen &= *box;
    if (seen.isEmpty())
        return;
    const QImage image = pixelsOf(underlay.file, levelFor(toDevice));
    if (image.isNull())
        return;
    const double across = double(image.width()) / file.width;
    const double down = double(image.height()) / file.height;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setOpacity(painter.opacity() * underlay.opacity * opacity);
    if (!box && !underlay.clip.empty())
        clipTo(painter, underlay.clip);
    painter.setTransform(toDrawing, true);
    painter.drawImage(
        seen, image,
        QRectF(seen.x() * across, seen.y() * down, seen.width() * across, seen.height() * down));
    painter.restore();
}

} // namespace app
