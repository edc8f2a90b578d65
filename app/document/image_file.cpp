// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/image_file.h"

#include <QBuffer>
#include <QImageReader>
#include <QLoggingCategory>
#include <QtEndian>

#include <array>
#include <optional>

namespace app {
namespace {

struct KindOfImage {
    ImageFile::Kind kind;
    const char* name; ///< for Qt
    QByteArrayView magic;
};

const std::array kindsOfImages{
    KindOfImage{ImageFile::Kind::Png, "png", "\x89PNG\r\n\x1a\n"},
    KindOfImage{ImageFile::Kind::Jpeg, "jpeg", "\xff\xd8\xff"},
};

QLoggingCategory::CategoryFilter filterBefore = nullptr;

/// Qt's readers print each fault of a file; this program tells it in its own words.
void withoutImageFaults(QLoggingCategory* category)
{
    if (filterBefore)
        filterBefore(category);
    if (QByteArrayView(category->categoryName()).startsWith("qt.gui.imageio"))
        category->setEnabled(QtWarningMsg, false);
}

void quietenReaders()
{
    [[maybe_unused]] static const bool once = [] {
        filterBefore = QLoggingCategory::installFilter(withoutImageFaults);
        return true;
    }();
}

/// Whether a PNG file has all its parts; libpng prints what is wrong with one that ends early.
bool hasEnd(const QByteArray& png)
{
    constexpr qsizetype signature = 8, around = 12; // the size, the name and the checksum of a part
    for (qsizetype at = signature; at + around <= png.size();) {
        const QByteArrayView name = QByteArrayView(png).sliced(at + 4, 4);
        at += around + qsizetype(qFromBigEndian<std::uint32_t>(png.constData() + at));
        if (name == "IEND")
            return at <= png.size();
    }
    return false;
}

bool isTooLarge(const QSize& size)
{
    return size.width() > ImageFile::mostSide || size.height() > ImageFile::mostSide
           || std::int64_t(size.width()) * size.height() > ImageFile::mostPixels;
}

} // namespace

std::variant<std::shared_ptr<const ImageFile>, ImageFault> imageFileOf(QByteArray bytes)
{
    quietenReaders();
    for (const KindOfImage& kind : kindsOfImages) {
        if (!bytes.startsWith(kind.magic))
            continue;
        if (bytes.size() > ImageFile::mostBytes)
            return ImageFault::TooLarge;
        if (kind.kind == ImageFile::Kind::Png && !hasEnd(bytes))
            return ImageFault::Damaged;
        QBuffer buffer(&bytes);
        QImageReader reader(&buffer, kind.name);
        QSize size = reader.size();
        if (reader.transformation() & QImageIOHandler::TransformationRotate90)
            size.transpose();
        if (size.isEmpty())
            return ImageFault::Damaged;
        if (isTooLarge(size))
            return ImageFault::TooLarge;
        return std::make_shared<const ImageFile>(
            ImageFile{std::move(bytes), kind.kind, size.width(), size.height()});
    }
    return ImageFault::OtherKind;
}

} // namespace app
