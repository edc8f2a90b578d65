// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/trace_file.h"

#include <QImage>

#include <algorithm>
#include <array>
#include <gif_lib.h>
#include <memory>
#include <unordered_map>

// A trace as an animation: one frame for each step, shown as long as its sentence takes to read.

namespace app {

namespace {

constexpr int colours = 256;

/// The duration of a step in hundredths of a second.
int delayOf(const Narration& narration, std::size_t step)
{
    const bool last = step + 1 >= narration.steps.size();
    return 120 + 4 * int(slideSentence(narration, step).size()) + (last ? 200 : 0);
}

QImage frameOf(const TraceExport& trace, std::size_t step)
{
    return imageOf(slidePage(trace, step), trace.scale);
}

/// The bucket of a colour: five bits of each component.
unsigned bucketOf(QRgb colour)
{
    return unsigned(qRed(colour) >> 3) << 10 | unsigned(qGreen(colour) >> 3) << 5
           | unsigned(qBlue(colour) >> 3);
}

/// The number of pixels in a bucket, and the sum of their colours.
struct Bucket {
    unsigned index = 0;
    std::uint64_t count = 0, red = 0, green = 0, blue = 0;
    void add(QRgb colour)
    {
        ++count;
        red += unsigned(qRed(colour)), green += unsigned(qGreen(colour));
        blue += unsigned(qBlue(colour));
    }
    QRgb middle() const { return qRgb(int(red / count), int(green / count), int(blue / count)); }
};

/// The most frequent colours of all frames: there are few except on antialiased edges.
std::vector<QRgb> paletteOf(const TraceExport& trace, std::span<const std::size_t> steps)
{
    std::vector<Bucket> buckets(1U << 15);
    for (const std::size_t step : steps) {
        const QImage frame = frameOf(trace, step);
        for (int y = 0; y < frame.height(); ++y) {
            const auto* row = reinterpret_cast<const QRgb*>(frame.constScanLine(y));
            for (int x = 0; x < frame.width(); ++x)
                buckets[bucketOf(row[x])].add(row[x]);
        }
    }
    for (unsigned i = 0; i < buckets.size(); ++i)
        buckets[i].index = i;
    std::ranges::sort(buckets, [](const Bucket& p, const Bucket& q) {
        return p.count != q.count ? p.count > q.count : p.index < q.index;
    });
    std::vector<QRgb> palette;
    for (const Bucket& bucket : buckets)
        if (bucket.count > 0 && palette.size() < colours)
            palette.push_back(bucket.middle());
    return palette;
}

/// Finds the nearest colour of a palette, and remembers the result for each colour.
class Matcher {
public:
    explicit Matcher(const std::vector<QRgb>& palette) : palette_(palette) {}
    GifPixelType operator()(QRgb colour)
    {
        const auto [known, isNew] = found_.try_emplace(colour, 0);
        if (isNew)
            known->second = nearest(colour);
        return known->second;
    }

private:
    GifPixelType nearest(QRgb colour) const
    {
        const auto distance = [&](QRgb other) {
            const int red = qRed(colour) - qRed(other), green = qGreen(colour) - qGreen(other),
                      blue = qBlue(colour) - qBlue(other);
            return 2 * red * red + 4 * green * green + 3 * blue * blue;
        };
        return GifPixelType(std::ranges::min_element(palette_, {}, distance) - palette_.begin());
    }
    const std::vector<QRgb>& palette_;
    std::unordered_map<QRgb, GifPixelType> found_;
};

int append(GifFileType* gif, const GifByteType* bytes, int count)
{
    static_cast<QByteArray*>(gif->UserData)
        ->append(reinterpret_cast<const char*>(bytes), qsizetype(count));
    return count;
}

struct CloseGif {
    void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
};
using Gif = std::unique_ptr<GifFileType, CloseGif>;

/// Makes the animation repeat without end.
bool putLoop(GifFileType* gif)
{
    const std::array<GifByteType, 3> forEver{1, 0, 0};
    return EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK
           && EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0") == GIF_OK
           && EGifPutExtensionBlock(gif, int(forEver.size()), forEver.data()) == GIF_OK
           && EGifPutExtensionTrailer(gif) == GIF_OK;
}

bool putFrame(GifFileType* gif, const QImage& frame, int delay, Matcher& matcher)
{
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, delay, NO_TRANSPARENT_COLOR};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    if (frame.isNull()
        || EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, int(bytes.size()), bytes.data()) != GIF_OK
        || EGifPutImageDesc(gif, 0, 0, frame.width(), frame.height(), false, nullptr) != GIF_OK)
        return false;
    std::vector<GifPixelType> line(std::size_t(frame.width()));
    for (int y = 0; y < frame.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(frame.constScanLine(y));
        std::transform(row, row + frame.width(), line.begin(),
                       [&](QRgb colour) { return matcher(colour | 0xFF000000); });
        if (EGifPutLine(gif, line.data(), frame.width()) != GIF_OK)
            return false;
    }
    return true;
}

bool putScreen(GifFileType* gif, const QSize& size, const std::vector<QRgb>& palette)
{
    std::array<GifColorType, colours> table{};
    std::ranges::transform(palette, table.begin(), [](QRgb colour) {
        return GifColorType{GifByteType(qRed(colour)), GifByteType(qGreen(colour)),
                            GifByteType(qBlue(colour))};
    });
    const std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> map(
        GifMakeMapObject(colours, table.data()), GifFreeMapObject);
    EGifSetGifVersion(gif, true);
    return map && EGifPutScreenDesc(gif, size.width(), size.height(), 8, 0, map.get()) == GIF_OK;
}

} // namespace

QByteArray traceGif(const TraceExport& trace, std::span<const std::size_t> steps)
{
    QByteArray bytes;
    const QImage first = frameOf(trace, steps.front());
    const Gif gif(EGifOpen(&bytes, append, nullptr));
    if (!gif || first.isNull())
        return {};
    const std::vector<QRgb> palette = paletteOf(trace, steps);
    Matcher matcher(palette);
    bool fine = putScreen(gif.get(), first.size(), palette) && putLoop(gif.get());
    for (const std::size_t step : steps)
        fine =
            fine
            && putFrame(gif.get(), frameOf(trace, step), delayOf(trace.narration, step), matcher);
    return fine ? bytes : QByteArray();
}

} // namespace app
