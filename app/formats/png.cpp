// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/png.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/formats/format.h"
#include "app/formats/paint_drawing.h"
#include "app/formats/painted.h"

#include <QBuffer>
#include <QColor>
#include <QImageWriter>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// QPainter paints nothing on larger images, and they need more than 600 MB.
constexpr double mostPixelsOfSide = 32'767, mostPixels = 150e6;
constexpr double millimetresPerInch = 25.4;

std::optional<QString> tooLarge(const Point& pixels, const Point& inches)
{
    const double side = std::max(pixels.x, pixels.y), area = pixels.x * pixels.y;
    if (side <= mostPixelsOfSide && area <= mostPixels)
        return std::nullopt;
    const double fits = std::min(mostPixelsOfSide / std::max(inches.x, inches.y),
                                 std::sqrt(mostPixels / inches.x / inches.y));
    constexpr double mostShown = 1e9;
    const auto number = [](double x) {
        return x <= mostShown ? QString::number(x, 'f', 0) : Text::tr("more than 1,000,000,000");
    };
    return Text::tr(
               "the picture would have %1 × %2 pixels, but at most %3 pixels a side and %4 in all "
               "are possible. Choose %5 dpi or less.")
        .arg(number(pixels.x), number(pixels.y), number(mostPixelsOfSide), number(mostPixels),
             fits >= 1 ? number(std::floor(fits)) : QString::number(fits, 'g', 2));
}

std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    if (auto fault = faultOf(document.page()))
        return fault;
    if (!(options.dpi > 0))
        return Text::tr("the picture would have no pixels. Choose at least 1 dpi.");
    const Paper paper = paperOf(document.page());
    const Point inches = paper.millimetres / millimetresPerInch;
    const Point pixels = pixelsOf(document.page(), options.dpi);
    if (auto sentence = tooLarge(pixels, inches))
        return sentence;
    const Colour ground = options.backgroundOf(document.page()).value_or(Colour{255, 255, 255});
    QImage image(int(pixels.x), int(pixels.y),
                 ground.alpha == 255 ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied);
    if (image.isNull())
        return Text::tr("there is not enough memory for the picture. Choose fewer dpi.");
    image.fill(QColor(ground.red, ground.green, ground.blue, ground.alpha));
    const int dotsPerMetre = int(std::lround(options.dpi / millimetresPerInch * 1000));
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);

    paintOn(image, document, options.dpi / millimetresPerInch * paper.millimetresPerUnit,
            options.stop);

    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!QImageWriter(&buffer, "png").write(image))
        return Text::tr("there is not enough memory for the picture. Choose fewer dpi.");
    const std::string_view view(bytes.data(), std::size_t(bytes.size()));
    return writeAll(out, view) ? std::nullopt : std::optional(out.errorString() + u'.');
}

} // namespace

Point pixelsOf(const Page& page, double dpi)
{
    return glm::max(Point{1, 1}, glm::round(paperOf(page).millimetres / millimetresPerInch * dpi));
}

Format pngFormat()
{
    return {"png",
            Text::tr("PNG picture"),
            nullptr,
            write,
            Holds::Paths,
            StoresHidden::No,
            Text::tr("%1 pixels a side and %2 in all")
                .arg(countText(std::size_t(mostPixelsOfSide)), countText(std::size_t(mostPixels))),
            Text::tr("picture"),
            {.dpi = true, .background = true, .paper = true}};
}

} // namespace app
