// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/image_text.h"

#include "app/base/number.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/transform.h"

#include <array>
#include <optional>

namespace app::svg {
namespace {

Matrix matrixOf(const AffineMap& m) { return {m.x.x, m.x.y, m.y.x, m.y.y, m.to.x, m.to.y}; }

/// The box of an image that is only moved and resized, if it is read as the same bits.
std::optional<Box> plainBox(const Underlay& image)
{
    const Matrix place = matrixOf(image.place);
    const Point pixels(image.file->width, image.file->height);
    if (place.b != 0 || place.c != 0 || !(place.a > 0 && place.d > 0))
        return std::nullopt;
    const Box box{{place.e, place.f}, {place.a * pixels.x, place.d * pixels.y}};
    const Matrix read = Matrix() * viewBoxTransform({{}, pixels}, box, "none");
    return read == place ? std::optional(box) : std::nullopt;
}

void appendPoints(std::string& text, std::string_view name, const std::vector<Point>& points)
{
    text.append(" ").append(name).append("=\"");
    for (std::size_t i = 0; i < points.size(); ++i) {
        text += i > 0 ? " " : "";
        appendNumber(text, points[i].x);
        text += ',';
        appendNumber(text, points[i].y);
    }
    text += '"';
}

void appendPlace(std::string& text, const Underlay& image, const std::optional<Box>& box)
{
    const Point from = box ? box->min : Point();
    const Point size = box ? box->size : Point(image.file->width, image.file->height);
    if (from.x != 0)
        appendAttribute(text, "x", from.x);
    if (from.y != 0)
        appendAttribute(text, "y", from.y);
    appendAttribute(text, "width", size.x);
    appendAttribute(text, "height", size.y);
    appendAttribute(text, "preserveAspectRatio", "none");
    if (box)
        return;
    const Matrix m = matrixOf(image.place);
    text += " transform=\"matrix(";
    for (const double number : {m.a, m.b, m.c, m.d, m.e}) {
        appendNumber(text, number);
        text += ' ';
    }
    appendNumber(text, m.f);
    text += ")\"";
}

} // namespace

void appendImage(std::string& text, const Underlay& image, std::uint32_t number)
{
    const auto box = plainBox(image);
    const std::string clip = "clearcut-image-clip-" + std::to_string(number);
    const bool isCut = !image.clip.empty();
    if (isCut) {
        std::vector<Point> corners = image.clip;
        if (const auto back = box ? std::nullopt : inverse(matrixOf(image.place)))
            for (Point& corner : corners)
                corner = (*back)(corner);
        text.append("<clipPath id=\"").append(clip).append("\"><polygon");
        appendPoints(text, "points", corners);
        text += "/></clipPath>\n";
    }
    text += "<image";
    if (!image.svgId.isEmpty())
        appendAttribute(text, "id", escaped(image.svgId));
    appendPlace(text, image, box);
    if (image.opacity != 1)
        appendAttribute(text, "opacity", image.opacity);
    if (isCut) {
        appendAttribute(text, "clip-path", "url(#" + clip + ")");
        appendPoints(text, "clearcut:clip", image.clip);
    }
    text.append(" xlink:href=\"data:image/").append(nameOf(image.file->kind)).append(";base64,");
    const QByteArray packed = image.file->bytes.toBase64();
    text.append(packed.constData(), std::size_t(packed.size())).append("\"/>\n");
}

} // namespace app::svg
