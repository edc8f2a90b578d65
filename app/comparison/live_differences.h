// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/difference.h"
#include "app/comparison/live_finding.h"

namespace app {

/// A against B.
struct Comparison {
    Variant a, b = exactVariant();
    std::optional<double> ulps{}; ///< that ends may be apart; nothing: as far as both contracts go

    double allowed() const { return ulps.value_or(contractUlps(a, b)); }
    friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// What was found among some lines.
struct Differences {
    clipping::Window window{};
    std::size_t lines = 0;                   ///< that were compared
    std::vector<Difference> list{};          ///< ascending by line
    std::vector<clipping::Clipped> pieces{}; ///< what A and B leave of these lines
};

/// Compares these lines too, which come after those that were compared, and adds what is found.
Differences extended(Differences so, const Comparison& comparison,
                     std::span<const clipping::Segment> more);
/// The same with the next `count` of all lines, or as many as there are.
Differences extended(Differences so, const Comparison& comparison, const SceneLines& lines,
                     std::size_t count);

/// What is to be seen of a difference: the pieces that A and B leave of the line.
clipping::Window placeOf(const Comparison& comparison, const clipping::Segment& line,
                         const clipping::Window& window);

/// The differences between A and B in an open drawing, while a panel shows them.
class LiveDifferences final : public LiveFinding {
    Q_OBJECT

public:
    LiveDifferences(const EditedDocument& document, const Scene& scene, QObject* parent = nullptr);

    /// Nothing: no panel shows it, and nothing is computed.
    void ask(const std::optional<Comparison>& comparison);
    const std::optional<Comparison>& asked() const { return asked_; }

    /// What was found last. While not up to date, of a drawing that has changed since: a line may
    /// be gone; or of another window.
    const Differences& found() const { return found_; }

    static constexpr std::size_t mostAtOnce = 100'000;
    /// All of it, or what to colour, at that window; nothing if that is not known (yet). Valid
    /// until the next change.
    const Differences* at(const clipping::Window& window) const;
    std::span<const clipping::Clipped> piecesAt(const clipping::Window& window) const;

private:
    void start(const clipping::Window& window) override;
    void look(const SceneLines& lines, std::size_t count) override;
    void keep() override;
    void forget() override;

    std::optional<Comparison> asked_;
    Differences found_, growing_; ///< growing_: what is being found
};

} // namespace app
