// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/live_finding.h"
#include "app/exactness/error_class.h"
#include "app/view/frame_wish.h"

namespace app {

/// How exact an algorithm is for every line of an open drawing, kept up to date while it is shown.
class LiveExactness final : public LiveFinding {
    Q_OBJECT

public:
    LiveExactness(const EditedDocument& document, const Scene& scene, QObject* parent = nullptr);

    struct Question {
        Variant variant;
        ErrorUnit errorUnit = ErrorUnit::Largest;
        friend bool operator==(const Question&, const Question&) = default;
    };
    /// An empty optional hides the result and stops the computation.
    void ask(const std::optional<Question>& question);
    const std::optional<Question>& asked() const { return asked_; }

    /// The last result. While not up to date, it belongs to another window or to an earlier state
    /// of the drawing.
    const ExactnessResults& found() const { return found_; }
    const ErrorCounts& counts() const { return counts_; }

    static constexpr std::size_t mostAtOnce = 10'000;
    /// The pieces to colour, one list for each of errorClasses(), at that window; empty if nothing
    /// was asked, or if it is not known (yet). Valid until the next change, while the lists may be
    /// kept.
    std::span<const SharedPieces> piecesAt(const clipping::Window& window) const;

private:
    class Growing;
    std::unique_ptr<Finding> start(const clipping::Window& window) override;
    void keep(Finding& whole) override;
    void forget() override;
    void measure();

    std::optional<Question> asked_;
    ExactnessResults found_;
    ErrorCounts counts_; ///< of the result, by the errorUnit that was asked for
    std::vector<SharedPieces> pieces_; ///< by error class
};

} // namespace app
