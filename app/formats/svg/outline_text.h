// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <string>
#include <string_view>

namespace app::svg {

/// Writes an outline as the shortest element that can represent it: <line>, <polyline>, <polygon>
/// or <path>. Coordinates are absolute, as relative ones would not read back bit for bit.
class OutlineText {
public:
    explicit OutlineText(const WriteOptions& options) : options_(options) {}

    /// Appends the beginning of the element with its coordinates, but without its end:
    /// `<line x1="0" ...`. Returns the element's name. `paths` must not be empty.
    std::string_view append(std::string& text, const std::vector<Subpath>& paths) const;
    std::string_view appendLine(std::string& text, const Point& from, const Point& to) const;

    /// Appends the path data of one subpath, as in the attribute "d".
    void appendPathData(std::string& text, const Subpath& path) const;

private:
    const WriteOptions& options_;
};

} // namespace app::svg
