// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/drawing.h"
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

/// The shown shapes as one flat array of segments, kept up to date by the drawing's change signal,
/// their boxes, and the buffers they are clipped into. Curves are flattened to 0.05 mm on paper.
class Scene : public QObject {
    Q_OBJECT

public:
    explicit Scene(const Drawing& drawing, QObject* parent = nullptr);

    std::span<const clipping::Segment> segments() const { return segments_; }

    /// The shape a segment belongs to: an index into Sheet::shapes.
    std::size_t shapeOf(std::size_t segment) const;
    /// The first segment of a shape; shape + 1 gives the end of its range.
    std::size_t firstSegmentOf(std::size_t shape) const { return first_[shape]; }

    /// Clips ALL segments, for the row `exact` by their boxes: the same bits in less time. `Kept`
    /// also computes what was removed (not timed).
    enum class Removed : std::uint8_t { Left, Kept };
    Frame clip(const clipping::Uses<clipping::Segment, clipping::Window>& algorithm,
               const clipping::Window& window, Removed removed);

signals:
    void outdated(); ///< the next frame will look different

private:
    void update(const Change& change);

    const Drawing& drawing_;
    std::vector<clipping::Segment> segments_;
    clipping::Chunks chunks_;
    std::vector<std::size_t> first_; ///< one more than there are shapes
    std::vector<clipping::Clipped> inside_, outside_;
};

} // namespace app
