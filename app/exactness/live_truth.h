// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/live_finding.h"
#include "app/exactness/error_class.h"

namespace app {

/// How right an algorithm is about every line of an open drawing, while that is shown.
class LiveTruth final : public LiveFinding {
    Q_OBJECT

public:
    LiveTruth(const EditedDocument& document, const Scene& scene, QObject* parent = nullptr);

    struct Question {
        Variant variant;
        Yardstick yardstick = Yardstick::Largest;
        friend bool operator==(const Question&, const Question&) = default;
    };
    /// No question: nothing is shown, and nothing is computed.
    void ask(const std::optional<Question>& question);
    const std::optional<Question>& asked() const { return asked_; }

    /// What was found last. While not up to date, of a drawing that has changed since, or of
    /// another window.
    const Truths& found() const { return found_; }
    const TruthCounts& counts() const { return counts_; }

    static constexpr std::size_t mostAtOnce = 10'000;
    /// What to colour, by errorClasses(), at that window; empty if nothing was asked, or if it is
    /// not known (yet). Valid until the next change.
    std::span<const std::vector<clipping::Clipped>> piecesAt(const clipping::Window& window) const;

private:
    void start(const clipping::Window& window) override;
    void look(const SceneLines& lines, std::size_t count) override;
    void keep() override;
    void forget() override;
    void measure();

    std::optional<Question> asked_;
    Truths found_, growing_; ///< growing_: what is being found
    TruthCounts counts_;     ///< of what was found, by the yardstick that was asked for
    std::vector<std::vector<clipping::Clipped>> pieces_; ///< the same, by error class
};

} // namespace app
