// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"
#include "app/scene/region_clipping.h"

namespace app {

/// The kept parts of lines, as a cut with these options leaves them. Reuses its buffers.
class LineClipping {
public:
    /// `options` must outlive this object. When a stop is requested, pieces are missing.
    explicit LineClipping(const CutOptions& options, const std::stop_token& stop = {});

    /// The pieces in the order of the lines; `source` is the index of a line. Valid until the next
    /// call.
    std::span<const clipping::Clipped> keptOf(std::span<const clipping::Segment> lines);

    /// The lines of the last call of which single points are kept, or would be without them left
    /// out; in order.
    std::span<const std::uint32_t> contacts() const { return contacts_; }

private:
    void findContacts(std::span<const clipping::Segment> lines);
    void keepAll(std::span<const clipping::Segment> lines);
    void clipAt(const clipping::Window& window, std::span<const clipping::Segment> lines);

    const CutOptions& options_;
    RegionClipping folding_;
    std::vector<clipping::Clipped> kept_, outside_;
    std::vector<std::uint32_t> contacts_;
};

} // namespace app
