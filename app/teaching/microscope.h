// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

#include <QObject>

namespace app {

/// The clip microscope without a screen: its line and variant, and the current step. It has its own
/// copy of the line; moving its ends never changes the drawing.
class Microscope : public QObject {
    Q_OBJECT

public:
    explicit Microscope(QObject* parent = nullptr) : QObject(parent) {}

    bool isOpen() const { return open_; }
    /// Opens a specimen at a step; beyond the last step: at the last.
    void open(const Specimen& specimen, std::size_t step = 0);
    /// Opens a specimen about which a question is open: walk() has only the first `shown` steps and
    /// does not tell the result until the next open(), so that no view of the walk reveals the
    /// answer. The last of these steps is current.
    void openCovered(const Specimen& specimen, std::size_t shown);
    bool isCovered() const { return shown_.has_value(); }
    void close();

    const Specimen& specimen() const { return specimen_; }
    /// Changes the specimen; the step stays the same, or becomes the last if there are fewer steps.
    void setSpecimen(const Specimen& specimen);

    const Walk& walk() const { return walk_; }
    std::size_t step() const { return step_; } ///< index into walk().moments; 0 if it is empty
    const Moment* moment() const;              ///< null if there are no steps
    /// Goes to a step; beyond the last: the last.
    void goTo(std::size_t step);
    void next() { goTo(step_ + 1); }
    void previous() { goTo(step_ > 0 ? step_ - 1 : 0); }
    bool atEnd() const { return step_ + 1 >= walk_.moments.size(); }

signals:
    void openChanged();
    void specimenChanged(); ///< the walk has changed with it; the step may have changed too
    void stepChanged();

private:
    void show(const Specimen& specimen, std::size_t step);

    Specimen specimen_;
    Walk walk_;
    std::size_t step_ = 0;
    std::optional<std::size_t> shown_; ///< the number of steps that are shown; empty: all
    bool open_ = false;
};

} // namespace app
