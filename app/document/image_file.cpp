// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/image_file.h"

#include <QBuffer>
#include <QImageReader>
#include <QLoggingCategory>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <optional>

namespace app {
namespace {

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

/// Where the blocks of data in a GIF file end that begin at this byte.
qsizetype endOfBlocks(const QByteArray& gif, qsizetype at)
{
    while (at < gif.size() && gif[at] != 0)
        at += 1 + std::uint8_t(gif[at]);
    return at + 1;
}

/// Whether a GIF file has all of its first picture; Qt shows what there is of one that ends early.
bool hasFirstPicture(const QByteArray& gif)
{
    const auto coloursAfter = [&](qsizetype flags) { // the bytes of a colour table
        constexpr int isThere = 0x80, sizeBits = 0x07;
        const int byte = flags < gif.size() ? std::uint8_t(gif[flags]) : 0;
        return (byte & isThere) != 0 ? qsizetype(3) << ((byte & sizeBits) + 1) : 0;
    };
    constexpr qsizetype head = 13, descriptor = 10;
    constexpr char extension = 0x21, picture = 0x2c;
    qsizetype at = head + coloursAfter(10);
    while (at < gif.size() && gif[at] == extension)
        at = endOfBlocks(gif, at + 2);
    if (at >= gif.size() || gif[at] != picture)
        return false;
    return endOfBlocks(gif, at + descriptor + coloursAfter(at + 9) + 1) <= gif.size();
}

struct KindOfImage {
    ImageFile::Kind kind;
    const char* name;
    QByteArrayView magic;
    bool (*isWhole)(const QByteArray&) = nullptr; ///< null: its reader says so
};

const std::array kindsOfImages{
    KindOfImage{ImageFile::Kind::Png, "png", "\x89PNG\r\n\x1a\n", hasEnd},
    KindOfImage{ImageFile::Kind::Jpeg, "jpeg", "\xff\xd8\xff"},
    KindOfImage{ImageFile::Kind::Gif, "gif", "GIF8", hasFirstPicture},
};

bool isTooLarge(const QSize& size)
{
    return size.width() > ImageFile::mostSide || size.height() > ImageFile::mostSide
           || std::int64_t(size.width()) * size.height() > ImageFile::mostPixels;
}

} // namespace

const char* nameOf(ImageFile::Kind kind)
{
    return std::ranges::find(kindsOfImages, kind, &KindOfImage::kind)->name;
}

std::variant<std::shared_ptr<const ImageFile>, ImageFault> imageFileOf(QByteArray bytes)
{
    quietenReaders();
    for (const KindOfImage& kind : kindsOfImages) {
        if (!bytes.startsWith(kind.magic))
            continue;
        if (bytes.size() > ImageFile::mostBytes)
            return ImageFault::TooLarge;
        if (kind.isWhole && !kind.isWhole(bytes))
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
