// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/block_scene.h"
#include "app/document/edited_document.h"
#include "clipping/algorithm.h"
#include "clipping/chunks.h"

#include <QObject>

#include <span>
#include <vector>

namespace app {

/// What one frame shows, and what it took. The spans are valid until the next call.
struct Frame {
    std::span<const clipping::Clipped> inside;  ///< what the algorithm leaves
    std::span<const clipping::Clipped> outside; ///< what the window removes, if asked for
    std::size_t total = 0;
    std::uint64_t nanoseconds = 0; ///< of the clipping of all segments, nothing else
};

/// The shown lines of a document that is being edited, kept up to date by its change signal, and
/// what clipping leaves of them. Curves are flattened to 0.05 mm on paper.
class Scene : public QObject {
    Q_OBJECT

public:
    explicit Scene(const EditedDocument& document, QObject* parent = nullptr);

    const SceneLines& lines() const { return blocks_.lines(); }

    /// The kept part of every line; see `SceneClipping`. The variant must not be an exhibit. Valid
    /// until the next call and the next change of the lines.
    SceneFrame clip(const ClipRegion& region, const Variant& variant)
    {
        return blocks_.clip(region, variant);
    }

    // For what still wants all lines in one array: a copy, made when it is asked for.
    std::span<const clipping::Segment> segments() const;
    std::size_t shapeOf(std::size_t segment) const { return lines().objectOf(segment); }
    std::size_t firstSegmentOf(std::size_t shape) const { return lines().firstLineOf(shape); }

    /// Clips ALL segments, for the row `exact` by their boxes: the same bits in less time. `Kept`
    /// also computes what was removed (not timed).
    enum class Removed : std::uint8_t { Left, Kept };
    Frame clip(const clipping::Uses<clipping::Segment, clipping::Window>& algorithm,
               const clipping::Window& window, Removed removed);

signals:
    void outdated(); ///< the next frame will look different

private:
    void update();

    const EditedDocument& document_;
    BlockScene blocks_;
    mutable std::uint64_t copied_ = 0; ///< the revision that segments_ is a copy of
    mutable std::vector<clipping::Segment> segments_;
    mutable clipping::Chunks chunks_;
    std::vector<clipping::Clipped> inside_, outside_;
};

} // namespace app
