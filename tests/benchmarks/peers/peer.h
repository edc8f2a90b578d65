// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

/// A scene as another library wants it: its own lines, its own window, its own output (touched).
class PeerData {
public:
    virtual ~PeerData() = default;
    virtual std::uint64_t clipAll() = 0; ///< how many are visible

    /// For comparing: what the library was given (rounded, where it knows whole numbers only), and
    /// what it leaves of one segment by the same call as clipAll's.
    virtual std::size_t size() const = 0;
    virtual clipping::Segment given(std::size_t i) const = 0;
    virtual std::optional<clipping::Segment> clip(std::size_t i) const = 0;
};

/// One way in which another library clips.
struct Peer {
    std::string_view name;
    std::string_view algorithm; ///< the key of our row that implements the same one; empty: none
    std::string_view numbers;
    std::unique_ptr<PeerData> (*prepare)(std::span<const clipping::Segment>,
                                         const clipping::Window&);
    double endsWithin; ///< drawing units that its ends may differ from ours before a test fails
    std::size_t bytes; ///< that a segment takes, roughly, in and out
};

/// A library that may be installed; one row of the catalogue. A null function: it is not.
struct PeerLibrary {
    std::string_view name, package;
    std::span<const Peer> (*peers)();
};

std::span<const PeerLibrary> peerLibraries();
