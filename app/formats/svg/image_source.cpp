// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/image_source.h"

#include "app/formats/gzip.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/page.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"
#include "app/view/image_pixels.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace app::svg {
namespace {

constexpr std::string_view data = "data:", packed = ";base64";

bool isData(std::string_view address)
{
    return equalsIgnoringCase(address.substr(0, data.size()), data);
}

QByteArray rawBytes(std::string_view text)
{
    return QByteArray::fromRawData(text.data(), qsizetype(text.size()));
}

std::variant<QByteArray, const LossKind*> bytesWithin(std::string_view address)
{
    constexpr std::size_t mostText = std::size_t(ImageFile::mostBytes) * 2; // with line ends
    const auto comma = address.find(',');
    if (comma == address.npos)
        return &losses::imageDamaged;
    const std::string_view head = trimmed(address.substr(0, comma));
    const std::string_view text = address.substr(comma + 1);
    if (text.size() > mostText)
        return &losses::imageTooLarge;
    const bool isPlain = text.find('%') == text.npos;
    const QByteArray plain = isPlain ? rawBytes(text) : rawBytes(text).percentDecoded();
    return head.ends_with(packed) ? QByteArray::fromBase64(plain)
                                  : QByteArray(plain.constData(), plain.size());
}

/// Whether an address is a path alone, that leads down from where it begins.
bool leadsDown(const QString& path)
{
    const QString clean = QDir::cleanPath(path);
    return !path.isEmpty() && !path.contains(u':') && !path.contains(u'\\')
           && QDir::isRelativePath(clean) && clean != u".." && !clean.startsWith(u"../");
}

/// From the folder, if the address is the whole path of a file in it.
QString pathIn(const QString& address, const QString& folder)
{
    constexpr QLatin1StringView scheme("file://");
    const QString whole =
        address.startsWith(scheme, Qt::CaseInsensitive) ? address.mid(scheme.size()) : address;
    const QString within = QDir(folder).absolutePath() + u'/';
    return whole.startsWith(within) ? whole.mid(within.size()) : address;
}

/// The text of an SVG drawing, also of a compressed one; empty: it is none.
std::optional<QByteArray> svgText(QByteArray bytes)
{
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::ReadOnly);
    const auto text = isZipped(buffer) ? unzipped(buffer, std::size_t(ImageFile::mostBytes))
                                       : std::optional(bytes);
    return text && (text->contains("<svg") || text->contains(":svg")) ? text : std::nullopt;
}

Point ownSizeOf(const Tree& tree, const std::optional<Box>& viewBox)
{
    Report toldAsItIsDrawn;
    Styles styles(tree, toldAsItIsDrawn);
    const Page page = readPage(tree, styles, toldAsItIsDrawn).page;
    const Point pixels{toUserUnits(page.width, pixel), toUserUnits(page.height, pixel)};
    if (pixels.x > 0 && pixels.y > 0)
        return pixels;
    if (!viewBox)
        return {};
    const double ratio = viewBox->size.x / viewBox->size.y;
    return pixels.x > 0   ? Point{pixels.x, pixels.x / ratio}
           : pixels.y > 0 ? Point{pixels.y * ratio, pixels.y}
                          : viewBox->size;
}

} // namespace

ImageSource ImageSource::again() const
{
    ImageSource source(folder_);
    source.depth_ = depth_;
    return source;
}

ImageSource ImageSource::inImage() const
{
    ImageSource source{QString()};
    source.depth_ = depth_ + 1;
    source.totals_ = totals_;
    return source;
}

const ImageSource::Found& ImageSource::find(std::string_view address, Report& report)
{
    const auto at = found_.find(address);
    return at != found_.end() ? at->second
                              : found_.emplace(address, fetch(address, report)).first->second;
}

ImageSource::Found ImageSource::fetch(std::string_view address, Report& report)
{
    address = trimmed(address);
    if (address.empty())
        return &losses::image;
    auto bytes = isData(address) ? bytesWithin(address) : bytesBeside(address);
    if (const auto* const lost = std::get_if<const LossKind*>(&bytes))
        return *lost;
    return checked(std::move(std::get<QByteArray>(bytes)), report);
}

/// Links that lead out of the folder are not followed.
std::variant<QByteArray, const LossKind*> ImageSource::bytesBeside(std::string_view address) const
{
    if (depth_ > 0)
        return &losses::imageOfImage;
    const QString path = pathIn(QString::fromUtf8(rawBytes(address).percentDecoded()), folder_);
    if (folder_.isEmpty() || !leadsDown(path))
        return &losses::imageElsewhere;
    const QFileInfo info(QDir(folder_), path);
    const QString real = info.canonicalFilePath();
    if (real.isEmpty() || !info.isFile())
        return &losses::imageMissing;
    if (!real.startsWith(QDir(folder_).canonicalPath() + u'/'))
        return &losses::imageElsewhere;
    if (info.size() > ImageFile::mostBytes)
        return &losses::imageTooLarge;
    QFile file(real);
    if (!file.open(QIODevice::ReadOnly))
        return &losses::imageMissing;
    return file.read(ImageFile::mostBytes + 1);
}

ImageSource::Found ImageSource::checked(QByteArray bytes, Report& report)
{
    auto made = imageFileOf(bytes);
    if (const auto text = made
                                  == std::variant<std::shared_ptr<const ImageFile>, ImageFault>(
                                      ImageFault::OtherKind)
                              ? svgText(std::move(bytes))
                              : std::nullopt)
        return drawing(*text, report);
    if (const auto* const fault = std::get_if<ImageFault>(&made))
        return *fault == ImageFault::OtherKind ? &losses::imageKind
               : *fault == ImageFault::Damaged ? &losses::imageDamaged
                                               : &losses::imageTooLarge;
    const auto& file = std::get<std::shared_ptr<const ImageFile>>(made);
    if (!hasRoom(std::int64_t(file->width) * file->height, file->bytes.size()))
        return &losses::imageTooLarge;
    if (!isReadable(*file))
        return &losses::imageDamaged;
    return file;
}

ImageSource::Found ImageSource::drawing(const QByteArray& bytes, Report& report)
{
    if (!hasRoom(0, bytes.size()))
        return &losses::imageTooLarge;
    QByteArray text = bytes;
    QBuffer buffer(&text);
    buffer.open(QIODevice::ReadOnly);
    const Report::Pin pin(report);
    try {
        SvgImage image{Tree::read(buffer, report)};
        Report toldAsItIsDrawn;
        image.viewBox = readViewBox(image.tree, 0, toldAsItIsDrawn);
        image.size = ownSizeOf(image.tree, image.viewBox);
        return std::make_shared<const SvgImage>(std::move(image));
    } catch (const Refused&) {
        return &losses::imageDamaged;
    }
}

bool ImageSource::hasRoom(std::int64_t pixels, std::int64_t bytes)
{
    pixels += totals_->pixels;
    bytes += totals_->bytes;
    if (pixels > mostImagePixels || bytes > mostImageBytes)
        return false;
    totals_->pixels = pixels;
    totals_->bytes = bytes;
    return true;
}

} // namespace app::svg
