// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/image_file.h"
#include "app/formats/svg/losses.h"

#include <QString>

#include <map>
#include <string>
#include <string_view>
#include <variant>

namespace app::svg {

/// Fetches the images of a file: from data: addresses, and from PNG and JPEG files in its folder or
/// below. Nothing else is opened. Each address is looked at once.
class ImageSource {
public:
    using Found = std::variant<std::shared_ptr<const ImageFile>, const LossKind*>;

    /// `folder`: of the file; empty: none, then only data: addresses count.
    explicit ImageSource(QString folder) : folder_(std::move(folder)) {}

    const QString& folder() const { return folder_; }
    /// The image, which can be read to its end, or what is lost.
    const Found& find(std::string_view address);

private:
    Found fetch(std::string_view address);
    std::variant<QByteArray, const LossKind*> bytesBeside(std::string_view address) const;
    Found checked(QByteArray bytes);

    QString folder_;
    std::map<std::string_view, Found> found_; ///< the addresses are the tree's
    std::int64_t pixels_ = 0, bytes_ = 0;     ///< of all images
};

} // namespace app::svg
