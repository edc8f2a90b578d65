// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/pdf/images.h"

#include "app/view/image_pixels.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace app::pdf {
namespace {

std::string entriesOf(int width, int height, const std::string& space, int bits)
{
    return "/Type/XObject/Subtype/Image/Width " + std::to_string(width) + "/Height "
           + std::to_string(height) + "/ColorSpace" + space + "/BitsPerComponent "
           + std::to_string(bits);
}

/// Bytes of an image file, read with a check of the end.
class Bytes {
public:
    explicit Bytes(const QByteArray& bytes) : bytes_(bytes) {}

    bool hasAt(qsizetype at, qsizetype count) const
    {
        return at >= 0 && count >= 0 && at <= bytes_.size() - count;
    }
    int byte(qsizetype at) const { return hasAt(at, 1) ? std::uint8_t(bytes_[at]) : 0; }
    int word(qsizetype at) const { return byte(at) * 256 + byte(at + 1); }
    qsizetype number(qsizetype at) const { return qsizetype(word(at)) * 65'536 + word(at + 2); }

private:
    const QByteArray& bytes_;
};

/// The number of colours of a JPEG file as PDF knows them: baseline or progressive, of 8 bits. 0:
/// another one.
int coloursOfJpeg(const QByteArray& file)
{
    const Bytes bytes(file);
    constexpr int startOfScan = 0xda, firstFrame = 0xc0, lastFrame = 0xc2;
    for (qsizetype at = 2; bytes.hasAt(at, 4) && bytes.byte(at) == 0xff;
         at += 2 + bytes.word(at + 2)) {
        const int marker = bytes.byte(at + 1);
        if (marker >= firstFrame && marker <= lastFrame)
            return bytes.byte(at + 4) == 8 ? bytes.byte(at + 9) : 0;
        if (marker == startOfScan)
            break;
    }
    return 0;
}

std::optional<Stream> jpegAsIs(const ImageFile& file)
{
    const int colours = coloursOfJpeg(file.bytes);
    if (colours != 1 && colours != 3)
        return std::nullopt; // four are inverted in some files
    const std::string space = colours == 1 ? "/DeviceGray" : "/DeviceRGB";
    return Stream{entriesOf(file.width, file.height, space, 8) + "/Filter/DCTDecode", file.bytes};
}

std::string hexOf(const QByteArray& bytes) { return '<' + bytes.toHex().toStdString() + '>'; }

/// A PNG file without transparent pixels: PDF knows its way of packing rows.
std::optional<Stream> pngAsIs(const ImageFile& file)
{
    const Bytes bytes(file.bytes);
    constexpr qsizetype head = 16;
    const int bits = bytes.byte(head + 8), kind = bytes.byte(head + 9);
    const bool isInterlaced = bytes.byte(head + 12) != 0;
    constexpr int gray = 0, rgb = 2, palette = 3;
    if (isInterlaced || (kind != gray && kind != rgb && kind != palette))
        return std::nullopt;
    QByteArray packed, colours;
    for (qsizetype at = 8; bytes.hasAt(at, 12);) {
        const qsizetype size = bytes.number(at);
        const QByteArray name = file.bytes.mid(at + 4, 4);
        if (!bytes.hasAt(at + 8, size) || name == "tRNS" || name == "acTL")
            return std::nullopt;
        if (name == "IDAT")
            packed += file.bytes.mid(at + 8, size);
        else if (name == "PLTE")
            colours = file.bytes.mid(at + 8, size);
        at += size + 12;
    }
    if (packed.isEmpty() || (kind == palette && colours.size() < 3))
        return std::nullopt;
    const std::string space = kind == gray ? "/DeviceGray"
                              : kind == rgb
                                  ? "/DeviceRGB"
                                  : "[/Indexed/DeviceRGB " + std::to_string(colours.size() / 3 - 1)
                                        + hexOf(colours) + ']';
    return Stream{entriesOf(file.width, file.height, space, bits)
                      + "/Filter/FlateDecode/DecodeParms<</Predictor 15/Colors "
                      + (kind == rgb ? "3" : "1") + "/BitsPerComponent " + std::to_string(bits)
                      + "/Columns " + std::to_string(file.width) + ">>",
                  packed};
}

QByteArray packedBytes(const QByteArray& bytes)
{
    constexpr int sizeOfQtHeader = 4; // the rest is a zlib stream, as PDF requires
    return qCompress(bytes).sliced(sizeOfQtHeader);
}

/// The decoded pixels of a file that PDF cannot take as it is.
std::vector<Stream> asPixels(const std::shared_ptr<const ImageFile>& file, std::size_t mask)
{
    constexpr double mostPixels = 32e6; // beyond, at half the resolution: memory ends
    int level = 0;
    for (double pixels = double(file->width) * file->height; pixels > mostPixels; pixels /= 4)
        ++level;
    const QImage image = pixelsOf(file, level);
    QByteArray colours, opacities;
    for (int y = 0; y < image.height(); ++y) {
        const QImage row =
            image.copy(0, y, image.width(), 1).convertToFormat(QImage::Format_RGBA8888);
        for (const uchar* p = row.constBits(); p != row.constBits() + 4 * row.width(); p += 4) {
            colours.append(reinterpret_cast<const char*>(p), 3);
            if (image.hasAlphaChannel())
                opacities.append(char(p[3]));
        }
    }
    const std::string flate = "/Filter/FlateDecode";
    std::vector<Stream> streams{
        {entriesOf(image.width(), image.height(), "/DeviceRGB", 8) + flate, packedBytes(colours)}};
    if (opacities.isEmpty())
        return streams;
    streams.front().entries += "/SMask " + std::to_string(mask) + " 0 R";
    streams.push_back({entriesOf(image.width(), image.height(), "/DeviceGray", 8) + flate,
                       packedBytes(opacities)});
    return streams;
}

} // namespace

std::vector<Stream> streamsOf(const std::shared_ptr<const ImageFile>& file, std::size_t mask)
{
    auto asIs = file->kind == ImageFile::Kind::Jpeg  ? jpegAsIs(*file)
                : file->kind == ImageFile::Kind::Png ? pngAsIs(*file)
                                                     : std::nullopt;
    return asIs ? std::vector{std::move(*asIs)} : asPixels(file, mask);
}

std::size_t Images::numberOf(const std::shared_ptr<const ImageFile>& file)
{
    const auto at = std::ranges::find(files_, file);
    const std::size_t number = first_ + 2 * std::size_t(at - files_.begin());
    if (at == files_.end())
        files_.push_back(file);
    return number;
}

} // namespace app::pdf
