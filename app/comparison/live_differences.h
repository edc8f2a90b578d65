// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/difference.h"
#include "app/document/scene.h"

#include <QTimer>

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

/// Compares lines[first, first + count) too and adds what is found.
Differences extended(Differences so, const Comparison& comparison,
                     std::span<const clipping::Segment> lines, std::size_t count);

/// What is to be seen of a difference: the pieces that A and B leave of the line.
clipping::Window placeOf(const Comparison& comparison, const clipping::Segment& line,
                         const clipping::Window& window);

/// What differs between A and B in an open drawing, while a panel shows it. Up to `mostAtOnce`
/// lines are compared in one go, before the next frame; more of them between events, some
/// milliseconds at a time, when a series of changes is over. Painting reads what was found and
/// computes nothing.
class LiveDifferences : public QObject {
    Q_OBJECT

public:
    LiveDifferences(const EditedDocument& document, const Scene& scene, QObject* parent = nullptr);

    /// Nothing: no panel shows it, and nothing is computed.
    void ask(const std::optional<Comparison>& comparison);
    const std::optional<Comparison>& asked() const { return asked_; }
    /// Where the clip window lies now, in the middle of a gesture too.
    void setWindow(const clipping::Window& window);

    /// What was found last. While not up to date, of a drawing that has changed since: a line may
    /// be gone; or of another window.
    const Differences& found() const { return found_; }
    bool upToDate() const { return upToDate_; }
    void finish(); ///< now, not soon

    static constexpr std::size_t mostAtOnce = 100'000;
    /// All of it, or what to colour, at that window; nothing if that is not known (yet). Valid
    /// until the next change.
    const Differences* at(const clipping::Window& window) const;
    std::span<const clipping::Clipped> piecesAt(const clipping::Window& window) const;

signals:
    void changed(); ///< the question, or what was found
    void begun();   ///< to look at so many lines that it takes a while

private:
    void outdate(const DocumentChange& change);
    void restart();
    void findAtOnce();
    void begin();
    void work();
    void keep(Differences found);

    const Scene& scene_;
    std::optional<Comparison> asked_;
    clipping::Window window_;
    Differences found_;
    std::optional<Differences> growing_; ///< what is being found
    bool upToDate_ = true;
    bool ofTheseLines_ = false; ///< found_ is, whatever its window is
    bool posted_ = false;       ///< findAtOnce() will be called
    QTimer soon_, work_;
};

} // namespace app
