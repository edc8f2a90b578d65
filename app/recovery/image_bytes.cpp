// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/image_bytes.h"

#include <algorithm>

namespace app {
namespace {

void writeImage(ByteWriter& out, const std::shared_ptr<const ImageFile>& file, KnownImages& known)
{
    const auto at = std::ranges::find(known.files, file);
    out.putCount(std::size_t(at - known.files.begin()));
    if (at != known.files.end())
        return;
    out.lendList(std::span(file->bytes.constData(), std::size_t(file->bytes.size())));
    known.files.push_back(file);
}

std::shared_ptr<const ImageFile> readImage(ByteReader& in, KnownImages& known)
{
    const auto number = in.get<std::uint32_t>();
    in.require(number <= known.files.size());
    if (!in.ok())
        return {};
    if (number < known.files.size())
        return known.files[number];
    const auto bytes = in.list<char>();
    const auto made = imageFileOf(QByteArray(bytes.data(), qsizetype(bytes.size())));
    const auto* const file = std::get_if<std::shared_ptr<const ImageFile>>(&made);
    in.require(file);
    if (!file)
        return {};
    known.files.push_back(*file);
    return *file;
}

} // namespace

KnownImages imagesOf(const Containers& containers)
{
    KnownImages known;
    for (const ContainerId id : containers.underlaid())
        if (const auto& file = containers[id].underlay->file;
            std::ranges::find(known.files, file) == known.files.end())
            known.files.push_back(file);
    return known;
}

void writeUnderlay(ByteWriter& out, const SharedUnderlay& underlay, KnownImages& known)
{
    out.put(std::uint8_t(bool(underlay)));
    if (!underlay)
        return;
    const auto& [file, place, clip, opacity, svgId] = *underlay;
    writeImage(out, file, known);
    out.put(place);
    out.putList(clip);
    out.put(opacity);
    out.put(svgId);
}

SharedUnderlay readUnderlay(ByteReader& in, KnownImages& known)
{
    if (!in.flag())
        return {};
    Underlay underlay;
    underlay.file = readImage(in, known);
    underlay.place = in.get<AffineMap>();
    underlay.clip = in.list<Point>();
    underlay.opacity = in.get<double>();
    underlay.svgId = in.text();
    return in.ok() ? SharedUnderlay(std::move(underlay)) : SharedUnderlay();
}

} // namespace app
