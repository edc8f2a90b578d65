// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/image_file.h"

#include <QBuffer>
#include <QImageReader>
#include <QLoggingCategory>

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
        QBuffer buffer(&bytes);
        const QSize size = QImageReader(&buffer, kind.name).size();
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
