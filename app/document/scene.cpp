// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/scene.h"

#include "app/document/flatten.h"
#include "app/vector_registers.h"
#include "clipping/outside.h"

#include <algorithm>
#include <chrono>

namespace app {

static bool clipsExactly(const clipping::Uses<clipping::Segment, clipping::Window>& algorithm)
{
    static const auto* const exact = &clipping::exactAlgorithm();
    return algorithm.clipAll == exact->corrected.clipAll;
}

Scene::Scene(const EditedDocument& document, QObject* parent) : QObject(parent), document_(document)
{
    connect(&document, &EditedDocument::changed, this, [this](const DocumentChange& change) {
        if (change.drawing())
            update();
        emit outdated();
    });
    update();
}

void Scene::update()
{
    const Document& now = document_.now();
    blocks_.update(now.objects(), now.containers().hiddenRanges(), usualTolerance(now.page()));
}

std::span<const clipping::Segment> Scene::segments() const
{
    if (copied_ != lines().revision()) {
        segments_.clear();
        segments_.reserve(lines().size());
        for (const SceneLines::Run& run : lines().runs())
            segments_.insert(segments_.end(), run.segments.begin(), run.segments.end());
        chunks_ = {};
        chunks_.update(segments_, 0, segments_.size());
        copied_ = lines().revision();
    }
    return segments_;
}

Frame Scene::clip(const clipping::Uses<clipping::Segment, clipping::Window>& algorithm,
                  const clipping::Window& window, Removed removed)
{
    segments();
    inside_.resize(segments_.size());
    emptyUpperHalves(); // a picture may have been painted before
    const auto start = std::chrono::steady_clock::now();
    const std::size_t count = clipsExactly(algorithm)
                                  ? chunks_.clipAll(segments_, window, inside_)
                                  : algorithm.clipAll(segments_, window, inside_);
    const auto time = std::chrono::steady_clock::now() - start;
    Frame frame{std::span(inside_).first(count),
                {},
                segments_.size(),
                std::uint64_t(std::chrono::nanoseconds(time).count())};
    if (removed == Removed::Kept) {
        outside_.resize(segments_.size() + count);
        const auto pieces = clipping::outsideAll(segments_, frame.inside, outside_);
        frame.outside = std::span(outside_).first(pieces);
    }
    return frame;
}

} // namespace app
