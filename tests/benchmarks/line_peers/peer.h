// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/region/region.h"

#include <memory>
#include <span>
#include <string_view>

/// What a window leaves of lines. Contacts in points do not count.
struct KeptLines {
    double length = 0;
    std::size_t pieces = 0;
};

/// Lines and a window as another library wants them, and its output.
class LinePeerData {
public:
    virtual ~LinePeerData() = default;
    virtual KeptLines clipAll() = 0;
};

/// Another library that clips lines at a window of one area.
struct LinePeer {
    std::string_view name, package;
    bool isReferee; ///< whether its results are trusted: a difference is a fault
    std::unique_ptr<LinePeerData> (*prepare)(std::span<const clipping::Segment> lines,
                                             const clipping::Area& window);
};

/// Those that are installed.
std::span<const LinePeer> linePeers();
/// The names and packages of the others.
std::span<const std::string_view> missingLinePeers();
