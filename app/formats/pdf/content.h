// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/underlay.h"
#include "app/formats/format.h"

#include <set>
#include <string>

namespace app::pdf {

/// The content stream of a page: the operators that paint objects.
class Content {
public:
    explicit Content(const WriteOptions& options) : options_(options) {}

    /// Sets the coordinate system: a user unit is `scale` units of the page, y goes down, and the
    /// user origin lies at `origin` on the page.
    void place(double scale, const Point& origin);

    void paint(const Object& object);
    /// `number`: that of the image among the file's objects.
    void paint(const Underlay& underlay, std::size_t number);

    QByteArray bytes() const { return QByteArray::fromStdString(text_); }
    std::string resources() const; ///< the page's resource dictionary, for the names in the stream

private:
    void outline(std::span<const Subpath> subpaths);
    void setAlpha(std::uint8_t alpha);
    void set(std::string& last, const std::string& now); ///< writes a state only if it changes

    const WriteOptions& options_;
    std::string text_;
    std::string alpha_, fill_, stroke_, pen_; ///< the current states
    std::set<int> alphas_;
    std::set<std::size_t> images_;
};

} // namespace app::pdf
