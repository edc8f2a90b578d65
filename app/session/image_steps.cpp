// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/image_steps.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/commands/history.h"
#include "app/commands/set_containers.h"
#include "app/session/image_room.h"
#include "app/view/image_pixels.h"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <QImage>

#include <algorithm>

namespace app {
namespace {

AffineMap onPage(const ImageFile& file, const Page& page)
{
    const Point pixels(file.width, file.height);
    const double scale = std::min(page.size.x / pixels.x, page.size.y / pixels.y);
    return {{scale, 0}, {0, scale}, {0, 0}, page.min + (page.size - pixels * scale) * 0.5};
}

QString faultText(ImageFault fault)
{
    if (fault == ImageFault::OtherKind)
        return Text::tr("it is neither PNG, JPEG nor GIF, or cannot be read.");
    if (fault == ImageFault::Damaged)
        return Text::tr("it is damaged.");
    return Text::tr("it is too large. An image can have %1 million pixels and %2 MB.")
        .arg(ImageFile::mostPixels / 1'000'000)
        .arg(ImageFile::mostBytes / 1'000'000);
}

QByteArray bytesOfFile(const QString& path)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return {};
    return file.read(ImageFile::mostBytes + 1);
}

QByteArray packed(const QImage& image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "png");
    return bytes;
}

QStringList imageTypes()
{
    return {QStringLiteral("image/png"), QStringLiteral("image/jpeg"), QStringLiteral("image/gif")};
}

} // namespace

void placeImage(Session& session, const std::shared_ptr<const ImageFile>& file, const QString& name)
{
    const Document& document = session.now();
    const Containers& tree = document.containers();
    if (!hasRoomFor({file}, tree)) {
        emit session.refused(Text::tr("No image was placed. %1").arg(imageRoomText()));
        return;
    }
    const auto layers = std::ranges::count_if(
        tree.inOrder(), [&](ContainerId id) { return tree[id].kind == Container::Kind::Layer; });
    const Container layer{.name = name.isEmpty() ? Text::tr("Image %1").arg(layers + 1) : name,
                          .locked = true,
                          .underlay =
                              Underlay{.file = file, .place = onPage(*file, document.page())}};
    auto more = std::size_t(layers) < Containers::mostLayers ? tree.inserted(layer, 0, 0, {0, 0})
                                                             : std::nullopt;
    if (!more) {
        emit session.refused(Text::tr("No image was placed. This drawing has %1 layers, and a file "
                                      "cannot hold more. Delete a layer first.")
                                 .arg(countText(std::size_t(layers))));
        return;
    }
    session.history.push(
        new SetContainers(session.document, std::move(*more), Text::tr("Place image")));
}

void removeImage(Session& session, ContainerId layer)
{
    const Containers& tree = session.now().containers();
    if (!tree.contains(layer) || !tree[layer].underlay)
        return;
    Container without = tree[layer];
    without.underlay = {};
    session.history.push(
        new SetContainers(session.document, tree.with(without), Text::tr("Remove image")));
}

bool isNamedLikeImage(const QString& path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    return suffix == u"png" || suffix == u"jpg" || suffix == u"jpeg" || suffix == u"gif";
}

bool offersImage(const QMimeData& data)
{
    return data.hasImage() || std::ranges::any_of(imageTypes(), [&](const QString& type) {
               return data.hasFormat(type);
           });
}

ImagePlacing::ImagePlacing(Session& session) : session_(session)
{
    connect(&session.document, &EditedDocument::changed, this,
            [this](const DocumentChange& change) {
                if (!change.everything)
                    return;
                reading_.cancel(); // it was meant for the drawing before
                waiting_.clear();
            });
}

void ImagePlacing::place(const QString& path)
{
    add([path] { return bytesOfFile(path); }, QFileInfo(path).completeBaseName());
}

void ImagePlacing::place(const QMimeData& data)
{
    for (const QString& type : imageTypes())
        if (data.hasFormat(type))
            return add([bytes = data.data(type)] { return bytes; }, {});
    add([image = qvariant_cast<QImage>(data.imageData())] { return packed(image); }, {});
}

ImagePlacing::Read ImagePlacing::read(const Bytes& bytes)
{
    const auto made = imageFileOf(bytes());
    if (const auto* const fault = std::get_if<ImageFault>(&made))
        return {.fault = faultText(*fault)};
    const auto& file = std::get<std::shared_ptr<const ImageFile>>(made);
    if (!isReadable(*file))
        return {.fault = faultText(ImageFault::Damaged)};
    return {.file = file};
}

void ImagePlacing::add(Bytes bytes, const QString& name)
{
    waiting_.push_back({std::move(bytes), name});
    if (waiting_.size() == 1)
        start();
}

void ImagePlacing::start()
{
    reading_.start([bytes = waiting_.front().bytes](const Follower&) { return read(bytes); },
                   [this](const Read& read) {
                       const QString name = waiting_.front().name;
                       waiting_.pop_front();
                       if (!waiting_.empty())
                           start();
                       if (read.file)
                           placeImage(session_, read.file, name);
                       else
                           emit session_.refused(
                               Text::tr("The image was not placed: %1").arg(read.fault));
                   });
}

} // namespace app

#include "moc_image_steps.cpp"
