// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

namespace app {

/// The functions of a published form, made from `Method::published(segment, window, step)`. As in
/// the library this is a template: it runs with plain numbers, with numbers that count their
/// operations, and with a recorder as `step` (clipping/trace.h).
template <class Method>
struct MisprintUses {
    using Segment = clipping::Segment;
    using Window = clipping::Window;

    static std::optional<Segment> clip(const Segment& segment, const Window& window)
    {
        return Method::published(segment, window, clipping::Unwatched{});
    }
    static std::size_t clipAll(std::span<const Segment> in, const Window& window,
                               std::span<clipping::Clipped> out)
    {
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < in.size(); ++i)
            if (const auto visible = clip(in[i], window))
                out[count++] = {*visible, i, 0};
        return count;
    }
    static clipping::OperationCounts count(std::span<const Segment> in, const Window& window)
    {
        clipping::operations = {};
        for (const Segment& segment : in)
            Method::published(clipping::counted(segment), clipping::counted(window),
                              clipping::Unwatched{});
        return clipping::operations;
    }
    static clipping::Trace trace(const Segment& segment, const Window& window)
    {
        clipping::operations = {};
        clipping::Recorder recorder;
        recorder.begin(segment, window);
        const auto visible =
            Method::published(clipping::counted(segment), clipping::counted(window), recorder);
        clipping::Trace trace = recorder.take();
        if (visible) {
            trace.outcome = clipping::Outcome::Visible;
            trace.visible = clipping::plain(*visible);
        }
        return trace;
    }

    static constexpr clipping::Functions<Segment, Window> all{clip, clipAll, count, trace};
};

} // namespace app
