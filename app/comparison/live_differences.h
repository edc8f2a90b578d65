// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/difference.h"
#include "app/comparison/live_finding.h"

#include <memory>

namespace app {

/// Which variants are compared: A against B.
struct Comparison {
    Variant a, b = exactVariant();
    std::optional<double> ulps{}; ///< allowed distance of ends; empty: the sum of both contracts

    double allowed() const { return ulps.value_or(contractUlps(a, b)); }
    friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// The differences found among the first `lines` lines.
struct Differences {
    clipping::Window window{};
    std::size_t lines = 0;                   ///< number of lines compared so far
    std::vector<Difference> list{};          ///< ascending by line
    std::vector<clipping::Clipped> pieces{}; ///< what A and B leave of these lines, A's first
};

/// Compares the lines `more`, which follow those compared so far, and adds their differences.
Differences extended(Differences so, const Comparison& comparison,
                     std::span<const clipping::Segment> more);
/// The same from what A and B leave of these lines.
Differences extended(Differences so, std::span<const clipping::Segment> more,
                     std::span<const clipping::Clipped> a, std::span<const clipping::Clipped> b,
                     const Allowance& allowed);
/// The same for the next `count` of all lines, or as many as are left.
Differences extended(Differences so, const Comparison& comparison, const SceneLines& lines,
                     std::size_t count);

/// The rectangle around what A and B show of the line.
clipping::Window placeOf(const Comparison& comparison, const clipping::Segment& line,
                         const clipping::Window& window);

/// The differences between A and B in an open drawing, kept up to date while a panel shows them.
class LiveDifferences final : public LiveFinding {
    Q_OBJECT

public:
    LiveDifferences(const EditedDocument& document, const Scene& scene, QObject* parent = nullptr);

    /// An empty optional stops the comparison.
    void ask(const std::optional<Comparison>& comparison);
    const std::optional<Comparison>& asked() const { return asked_; }

    /// The last result. While not up to date, it belongs to another window or to an earlier state
    /// of the drawing, so its line numbers may no longer exist.
    const Differences& found() const { return *found_; }

    static constexpr std::size_t mostAtOnce = 100'000;
    /// All differences at that window, which any thread may keep; null if not known (yet).
    std::shared_ptr<const Differences> at(const clipping::Window& window) const;
    /// The pieces to colour; valid until the next change.
    std::span<const clipping::Clipped> piecesAt(const clipping::Window& window) const;

private:
    class Growing;
    std::unique_ptr<Finding> start(const clipping::Window& window) override;
    void keep(Finding& whole) override;
    void forget() override;

    std::optional<Comparison> asked_;
    std::shared_ptr<const Differences> found_ = std::make_shared<const Differences>(); ///< not null
};

} // namespace app
