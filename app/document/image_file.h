// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cstdint>
#include <memory>
#include <variant>

namespace app {

/// A PNG, JPEG or GIF file in memory, as it was given. It may be damaged: only its head is known.
/// Of an animation the first picture is shown.
struct ImageFile {
    static constexpr qsizetype mostBytes = 64'000'000;
    static constexpr int mostSide = 32'767;
    static constexpr std::int64_t mostPixels = 100'000'000; ///< which are 400 MB

    enum class Kind : std::uint8_t { Png, Jpeg, Gif };
    QByteArray bytes{};
    Kind kind = Kind::Png;
    int width = 0, height = 0; ///< pixels, as it is shown: turned as its camera says (Exif)
    friend bool operator==(const ImageFile&, const ImageFile&) = default;
};

/// "png", as Qt and the types of images call it.
const char* nameOf(ImageFile::Kind kind);

/// Why bytes are no image that a drawing can hold.
enum class ImageFault : std::uint8_t { OtherKind, Damaged, TooLarge };

/// Looks at the head of the bytes.
std::variant<std::shared_ptr<const ImageFile>, ImageFault> imageFileOf(QByteArray bytes);

} // namespace app
