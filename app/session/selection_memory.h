// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"

#include <QObject>

#include <deque>

namespace app {

class Session;
struct DocumentChange;

/// Undo gives back the selection before the step, and redo the one after it, if the step adds,
/// removes or moves objects: then the selection cannot follow them. Everything else leaves the
/// selection alone.
class SelectionMemory : public QObject {
    Q_OBJECT

public:
    explicit SelectionMemory(Session& session); ///< which owns it

private:
    struct Step {
        ObjectRanges before{}, after{};
        bool remembers = false;
    };

    void follow(const DocumentChange& change);
    void pushed(bool joined);
    void go(int index);
    void restore(int from, int index);

    Session& session_;
    std::deque<Step> steps_; ///< of the history
    int index_ = 0;
    ObjectRanges selected_, before_; ///< now, and before the change that was made last
    bool changing_ = false, replaces_ = false;
};

} // namespace app
