// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/image_file.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/transform.h"
#include "app/formats/svg/tree.h"

#include <QString>

#include <map>
#include <memory>
#include <string_view>
#include <variant>

namespace app::svg {

/// An image that is an SVG drawing itself.
struct SvgImage {
    Tree tree;
    Point size{}; ///< pixels, at least of these proportions; 0: it is as large as its place
    std::optional<Box> viewBox{};
};

/// Fetches the images of a file: from data: addresses, and from files in its folder or below.
/// Nothing else is opened. Each address is looked at once.
class ImageSource {
public:
    using Found = std::variant<std::shared_ptr<const ImageFile>, std::shared_ptr<const SvgImage>,
                               const LossKind*>;

    /// `folder`: of the file; empty: none, then only data: addresses count.
    explicit ImageSource(QString folder) : folder_(std::move(folder)) {}

    /// Of the same file, counted anew.
    ImageSource again() const;
    /// Of an SVG image of this file, counted with it. It has nothing from other files, as in
    /// browsers, and so no image has itself in it.
    ImageSource inImage() const;
    int depth() const { return depth_; } ///< in how many SVG images

    /// The image, which can be read to its end, or what is lost. Errors of XML in it are reported.
    const Found& find(std::string_view address, Report& report);

    int drawn() const { return totals_->drawn; }
    void countDrawn() { ++totals_->drawn; }
    bool gaveUp() const { return totals_->gaveUp; }
    /// An SVG image was beyond a limit of drawings: a file with many such ones would take long.
    void giveUp() { totals_->gaveUp = true; }

private:
    /// Of all images, also in SVG images.
    struct Totals {
        std::int64_t pixels = 0, bytes = 0;
        int drawn = 0;
        bool gaveUp = false;
    };

    Found fetch(std::string_view address, Report& report);
    std::variant<QByteArray, const LossKind*> bytesBeside(std::string_view address) const;
    Found checked(QByteArray bytes, Report& report);
    Found drawing(const QByteArray& bytes, Report& report);
    bool hasRoom(std::int64_t pixels, std::int64_t bytes);

    QString folder_;
    int depth_ = 0;
    std::map<std::string_view, Found> found_; ///< the addresses are the tree's
    std::shared_ptr<Totals> totals_ = std::make_shared<Totals>();
};

} // namespace app::svg
