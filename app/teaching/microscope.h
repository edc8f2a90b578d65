// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

#include <QObject>

namespace app {

/// The clip microscope without a screen: its line and variant, and the current step. It has its own
/// copy of the line; moving its ends never changes the drawing.
class Microscope : public QObject {
    Q_OBJECT

public:
    explicit Microscope(QObject* parent = nullptr) : QObject(parent) {}

    bool isOpen() const { return open_; }
    /// Opens a traced line at a step; beyond the last step: at the last.
    void open(const TracedLine& tracedLine, std::size_t step = 0);
    /// Opens a traced line about which a question is open: narration() has only the first `shown`
    /// steps and does not tell the result until the next open(), so that no view of the trace
    /// reveals the answer. The last of these steps is current. Plain sentences do not say what
    /// follows from a step either.
    void openCovered(const TracedLine& tracedLine, std::size_t shown,
                     Sentences sentences = Sentences::Explained);
    bool isCovered() const { return shown_.has_value(); }
    void close();

    const TracedLine& tracedLine() const { return tracedLine_; }
    /// Changes the traced line; the step stays the same, or becomes the last if there are fewer
    /// steps.
    void setTracedLine(const TracedLine& tracedLine);

    const Narration& narration() const { return narration_; }
    std::size_t step() const { return step_; } ///< index into narration().steps; 0 if it is empty
    const NarratedStep* narrated() const;      ///< null if there are no steps
    /// Goes to a step; beyond the last: the last.
    void goTo(std::size_t step);
    void next() { goTo(step_ + 1); }
    void previous() { goTo(step_ > 0 ? step_ - 1 : 0); }
    bool atEnd() const { return step_ + 1 >= narration_.steps.size(); }

signals:
    void openChanged();
    void tracedLineChanged(); ///< the trace has changed with it; the step may have changed too
    void stepChanged();

private:
    void show(const TracedLine& tracedLine, std::size_t step);

    TracedLine tracedLine_;
    Narration narration_;
    std::size_t step_ = 0;
    std::optional<std::size_t> shown_; ///< the number of steps that are shown; empty: all
    bool open_ = false;
    Sentences sentences_ = Sentences::Explained;
};

} // namespace app
