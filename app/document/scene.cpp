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

Scene::Scene(const Drawing& drawing, QObject* parent) : QObject(parent), drawing_(drawing)
{
    connect(&drawing, &Drawing::changed, this, &Scene::update);
    update({});
}

std::size_t Scene::shapeOf(std::size_t segment) const
{
    return std::size_t(std::ranges::upper_bound(first_, segment) - first_.begin()) - 1;
}

Frame Scene::clip(const clipping::Uses<clipping::Segment, clipping::Window>& algorithm,
                  const clipping::Window& window, Removed removed)
{
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

void Scene::update(const Change& change)
{
    if (change.kind == Change::Kind::Window) {
        emit outdated();
        return;
    }
    const Sheet& sheet = drawing_.sheet();
    const double tolerance = usualTolerance(sheet.page);
    const bool splice = change.kind == Change::Kind::Shapes;
    const std::size_t from = splice ? change.first : 0;
    const std::size_t oldEnd = splice           ? from + change.removed
                               : first_.empty() ? 0
                                                : first_.size() - 1;
    const std::size_t newEnd = splice ? from + change.added : sheet.shapes.size();
    if (first_.empty())
        first_ = {0};

    std::vector<clipping::Segment> segments;
    std::vector<std::size_t> first;
    std::vector<Chord> chords;
    for (std::size_t i = from; i < newEnd; ++i) {
        first.push_back(first_[from] + segments.size());
        const Shape& shape = sheet.shapes[i];
        if (!sheet.shown(shape))
            continue;
        chords.clear();
        for (const Subpath& path : shape.paths)
            flatten(path, tolerance, chords);
        for (const Chord& chord : chords)
            segments.push_back(chord.segment);
    }
    const auto at = [](auto& v, std::size_t i) { return v.begin() + std::ptrdiff_t(i); };
    const std::size_t firstOld = first_[from], endOld = first_[oldEnd];
    const auto shift = std::ptrdiff_t(firstOld + segments.size()) - std::ptrdiff_t(endOld);
    std::for_each(at(first_, oldEnd), first_.end(),
                  [&](auto& n) { n = std::size_t(std::ptrdiff_t(n) + shift); });
    first_.erase(at(first_, from), at(first_, oldEnd));
    first_.insert(at(first_, from), first.begin(), first.end());
    segments_.erase(at(segments_, firstOld), at(segments_, endOld));
    segments_.insert(at(segments_, firstOld), segments.begin(), segments.end());
    chunks_.update(segments_, firstOld, firstOld + segments.size());
    emit outdated();
}

} // namespace app
