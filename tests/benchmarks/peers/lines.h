// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <vector>

#include "tests/benchmarks/peers/peer.h"

/// `Peer::endsWithin` for those who calculate in double, on the benchmark scenes.
constexpr double doubleEnds = 1e-8;

/// A scene for one library. `Library` says how its lines, windows and pieces look:
///   Line lineOf(Segment), Box boxOf(Window), Segment segmentOf(Line or Piece),
///   optional<Piece> clip(const Line&, const Box&).
template <class Library>
class PeerLines final : public PeerData {
    using Line = typename Library::Line;
    using Piece = typename Library::Piece;
    struct Visible {
        Piece piece;
        std::uint32_t source;
    };

public:
    PeerLines(std::span<const clipping::Segment> in, const clipping::Window& window)
        : box_(Library::boxOf(window)), out_(in.size())
    {
        lines_.reserve(in.size());
        for (const auto& segment : in)
            lines_.push_back(Library::lineOf(segment));
    }

    std::uint64_t clipAll() override
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i < lines_.size(); ++i)
            if (const auto piece = Library::clip(lines_[i], box_))
                out_[count++] = {*piece, static_cast<std::uint32_t>(i)};
        return count;
    }
    std::size_t size() const override { return lines_.size(); }
    clipping::Segment given(std::size_t i) const override { return Library::segmentOf(lines_[i]); }
    std::optional<clipping::Segment> clip(std::size_t i) const override
    {
        const auto piece = Library::clip(lines_[i], box_);
        return piece ? std::optional(Library::segmentOf(*piece)) : std::nullopt;
    }

    static std::unique_ptr<PeerData> prepare(std::span<const clipping::Segment> in,
                                             const clipping::Window& window)
    {
        return std::make_unique<PeerLines>(in, window);
    }
    static constexpr std::size_t bytes = sizeof(Line) + sizeof(Visible);

private:
    std::vector<Line> lines_;
    typename Library::Box box_;
    std::vector<Visible> out_; // its pages are touched by making it
};
