// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/scene.h"
#include "app/truth/error_class.h"

#include <QTimer>

namespace app {

/// How right an algorithm is about every line of an open drawing, while that is shown. Up to
/// `mostAtOnce` lines are judged in one go, before the next frame; more of them between events,
/// some milliseconds at a time, when a series of changes is over.
class LiveTruth : public QObject {
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
    /// Where the clip window lies now, in the middle of a gesture too.
    void setWindow(const clipping::Window& window);

    /// What was found last. While not up to date, of a drawing that has changed since, or of
    /// another window.
    const Truths& found() const { return found_; }
    const TruthCounts& counts() const { return counts_; }
    bool upToDate() const { return upToDate_; }
    double progress() const; ///< of what is being found: 0 to 1
    void finish();           ///< now, not soon

    static constexpr std::size_t mostAtOnce = 10'000;
    /// What to colour, by errorClasses(), at that window; empty if nothing was asked, or if it is
    /// not known (yet). Valid until the next change.
    std::span<const std::vector<clipping::Clipped>> piecesAt(const clipping::Window& window) const;

signals:
    void changed();    ///< the question, or what was found
    void progressed(); ///< some more was judged

private:
    using Pieces = std::vector<std::vector<clipping::Clipped>>;

    void outdate(const DocumentChange& change);
    void restart();
    void findAtOnce();
    void begin();
    void work();
    void keep(Truths found);
    Pieces piecesOf(const Truths& truths) const;

    const Scene& scene_;
    std::optional<Question> asked_;
    clipping::Window window_;
    Truths found_;
    TruthCounts counts_;
    Pieces pieces_;
    std::optional<Truths> growing_;
    bool upToDate_ = true;
    bool ofTheseLines_ = false; ///< found_ is, whatever its window is
    bool posted_ = false;       ///< findAtOnce() will be called
    QTimer soon_, work_;
};

} // namespace app
