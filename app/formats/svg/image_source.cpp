// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/image_source.h"

#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"
#include "app/view/image_pixels.h"

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

} // namespace

const ImageSource::Found& ImageSource::find(std::string_view address)
{
    const auto at = found_.find(address);
    return at != found_.end() ? at->second : found_.emplace(address, fetch(address)).first->second;
}

ImageSource::Found ImageSource::fetch(std::string_view address)
{
    address = trimmed(address);
    if (address.empty())
        return &losses::image;
    auto bytes = isData(address) ? bytesWithin(address) : bytesBeside(address);
    if (const auto* const lost = std::get_if<const LossKind*>(&bytes))
        return *lost;
    return checked(std::move(std::get<QByteArray>(bytes)));
}

/// Links that lead out of the folder are not followed.
std::variant<QByteArray, const LossKind*> ImageSource::bytesBeside(std::string_view address) const
{
    const QString path = QString::fromUtf8(rawBytes(address).percentDecoded());
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

ImageSource::Found ImageSource::checked(QByteArray bytes)
{
    auto made = imageFileOf(std::move(bytes));
    if (const auto* const fault = std::get_if<ImageFault>(&made))
        return *fault == ImageFault::OtherKind ? &losses::imageKind
               : *fault == ImageFault::Damaged ? &losses::imageDamaged
                                               : &losses::imageTooLarge;
    const auto& file = std::get<std::shared_ptr<const ImageFile>>(made);
    const std::int64_t pixels = pixels_ + std::int64_t(file->width) * file->height;
    const std::int64_t size = bytes_ + file->bytes.size();
    if (pixels > mostImagePixels || size > mostImageBytes)
        return &losses::imageTooLarge;
    pixels_ = pixels;
    bytes_ = size;
    if (!isReadable(*file))
        return &losses::imageDamaged;
    return file;
}

} // namespace app::svg
