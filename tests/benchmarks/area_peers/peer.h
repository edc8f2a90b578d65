// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/region/region.h"

#include <memory>
#include <span>
#include <string_view>

/// Areas and a window as another library wants them, and its output.
class AreaPeerData {
public:
    virtual ~AreaPeerData() = default;
    /// Clips all areas; returns the sum of what is left of them, in square units.
    virtual double clipAll() = 0;
};

/// Another library that clips areas at a window of one area.
struct AreaPeer {
    std::string_view name, package;
    bool isReferee; ///< whether its results are trusted: a difference is a fault
    std::unique_ptr<AreaPeerData> (*prepare)(std::span<const clipping::Area> areas,
                                             const clipping::Area& window);
};

/// Those that are installed.
std::span<const AreaPeer> areaPeers();
