// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/dashed_path.h"

#include "app/cut/true_curve.h"
#include "app/document/dash_parts.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace app {
namespace {

class Dashes {
public:
    Dashes(const Subpath& path, const Style& style, double tolerance)
        : path_(path), style_(style), tolerance_(tolerance)
    {
    }

    std::vector<Subpath> parts()
    {
        flatten(path_, tolerance_, chords_);
        std::vector<double> lengths;
        double length = 0;
        for (const Chord& chord : chords_) {
            lengths.push_back(glm::distance(chord.segment.a, chord.segment.b));
            length += lengths.back();
        }
        constexpr double mostDashes = 100'000; // further ones would not be seen as such
        const double shortest =
            std::max(tolerance_, length * double(style_.dashes.size()) / mostDashes);
        const auto dashes = dashParts(lengths, style_.dashes, style_.dashOffset, shortest);
        if (!dashes)
            return {path_};
        for (const DashPart& part : *dashes)
            add(part);
        finish();
        return std::move(parts_);
    }

private:
    void add(const DashPart& part)
    {
        const Chord& chord = chords_[part.line];
        const auto at = [&](double share) { return chord.t0 + (chord.t1 - chord.t0) * share; };
        if (part.begins) {
            finish();
            isOpen_ = true;
            parts_.push_back({pointAt(chord, part.from), {}, false});
        }
        if (part.begins || segment_ != chord.pathSegment) {
            if (!part.begins)
                append();
            segment_ = chord.pathSegment;
            from_ = at(part.from);
        }
        to_ = at(part.to);
        last_ = pointAt(chord, part.to);
        along_ = chord.segment.b - chord.segment.a;
    }

    Point pointAt(const Chord& chord, double share) const
    {
        const auto& [a, b] = chord.segment;
        if (share == 0 || share == 1)
            return share == 0 ? a : b;
        return isCurve(path_, chord.pathSegment)
                   ? curveOf(path_, chord.pathSegment).at(chord.t0 + (chord.t1 - chord.t0) * share)
                   : a + (b - a) * share;
    }

    void append()
    {
        if (!isCurve(path_, segment_))
            return parts_.back().segments.push_back({last_});
        const Bezier part = curveOf(path_, segment_).part(from_, to_);
        parts_.back().segments.push_back({last_, part.control1, part.control2, true});
    }

    void finish()
    {
        if (!isOpen_)
            return;
        const Point start = parts_.back().start;
        const double length = glm::length(along_);
        // A dash without length has caps, which have its direction.
        if (from_ == to_ && parts_.back().segments.empty() && length > 0)
            last_ = start + along_ * (style_.width * 1e-6 / length);
        if (from_ == to_)
            parts_.back().segments.push_back({last_});
        else
            append();
        isOpen_ = false;
    }

    const Subpath& path_;
    const Style& style_;
    const double tolerance_;
    std::vector<Chord> chords_;
    std::vector<Subpath> parts_;
    bool isOpen_ = false;
    std::size_t segment_ = 0; ///< which the last part of the dash in hand is on
    double from_ = 0, to_ = 0;
    Point last_{}, along_{};
};

} // namespace

std::vector<Subpath> dashesOf(const Subpath& path, const Style& style, double tolerance)
{
    if (style.dashes.empty())
        return {path};
    return Dashes(path, style, tolerance).parts();
}

} // namespace app
