// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

#include <QObject>

namespace app {

/// The clip microscope without a screen: what is looked at, and which step of it. It keeps its own
/// copy of the line; moving its ends never changes the drawing.
class Microscope : public QObject {
    Q_OBJECT

public:
    explicit Microscope(QObject* parent = nullptr) : QObject(parent) {}

    bool isOpen() const { return open_; }
    /// Looks at something, at one of its steps; beyond the last: at the last.
    void open(const Specimen& specimen, std::size_t step = 0);
    /// Looks at something about which a question is open: walk() has only the first `shown` steps
    /// and does not say what becomes of the line, until the next open(). So nothing that shows the
    /// walk can give the answer away. The last of these steps is looked at.
    void openCovered(const Specimen& specimen, std::size_t shown);
    bool isCovered() const { return shown_.has_value(); }
    void close();

    const Specimen& specimen() const { return specimen_; }
    /// Something else, while one looks: the step stays, as far as there are so many.
    void setSpecimen(const Specimen& specimen);

    const Walk& walk() const { return walk_; }
    std::size_t step() const { return step_; } ///< index into walk().moments; 0 if there are none
    const Moment* moment() const;              ///< null if there are none
    /// To a step; beyond the last: the last.
    void goTo(std::size_t step);
    void next() { goTo(step_ + 1); }
    void previous() { goTo(step_ > 0 ? step_ - 1 : 0); }
    bool atEnd() const { return step_ + 1 >= walk_.moments.size(); }

signals:
    void openChanged();
    void specimenChanged(); ///< and with it the walk; the step may have changed too
    void stepChanged();

private:
    void show(const Specimen& specimen, std::size_t step);

    Specimen specimen_;
    Walk walk_;
    std::size_t step_ = 0;
    std::optional<std::size_t> shown_; ///< how many steps can be seen; nothing: all
    bool open_ = false;
};

} // namespace app
