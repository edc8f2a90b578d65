// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <string>
#include <string_view>

namespace app::svg {

/// Writes outlines as the shortest element that holds them: <line>, <polyline>, <polygon>, <path>;
/// absolute coordinates, as relative ones would not read back bit for bit.
class OutlineText {
public:
    explicit OutlineText(const WriteOptions& options) : options_(options) {}

    /// The element's beginning, with its coordinates and without its end: `<line x1="0" ...`. Gives
    /// its name. `paths` is not empty.
    std::string_view append(std::string& text, const std::vector<Subpath>& paths) const;
    std::string_view appendLine(std::string& text, const Point& from, const Point& to) const;

private:
    void appendPathData(std::string& text, const Subpath& path) const;

    const WriteOptions& options_;
};

} // namespace app::svg
