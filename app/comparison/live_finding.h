// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"

#include <QTimer>

#include <optional>

namespace app {

/// A result for all lines of an open drawing at the clip window, kept up to date while there is a
/// question. Few lines are looked at in one go, before the next frame;
/// many of them between events, some milliseconds at a time, when a series of changes is over.
/// Painting reads what was found and computes nothing.
class LiveFinding : public QObject {
    Q_OBJECT

public:
    /// Where the clip window lies now, in the middle of a gesture too.
    void setWindow(const clipping::Window& window);

    /// The result is that of the present lines and window, or there is no question.
    bool upToDate() const { return upToDate_; }
    double progress() const; ///< of what is being found: 0 to 1
    void finish();           ///< now, not soon

signals:
    void changed();    ///< the question, what was found, or that this is not up to date for a while
    void begun();      ///< to look at so many lines that it takes a while
    void progressed(); ///< more lines were looked at

protected:
    struct Pace {
        std::size_t atOnce; ///< lines: so many are few
        std::size_t slice;  ///< lines between two looks at the clock
    };
    LiveFinding(const EditedDocument& document, const Scene& scene, Pace pace, QObject* parent);

    /// Another question, or none any more: what was found is forgotten.
    void askAnew(bool something);

private:
    /// Drops the partial result; the next one is for this window.
    virtual void start(const clipping::Window& window) = 0;
    /// Looks at the next `count` lines, which there are.
    virtual void look(const SceneLines& lines, std::size_t count) = 0;
    virtual void keep() = 0;   ///< all lines were looked at: this is what is found
    virtual void forget() = 0; ///< nothing is found

    /// The lines and the window that a result is for.
    struct Matter {
        std::uint64_t lines; ///< their revision
        clipping::Window window;
        friend bool operator==(const Matter&, const Matter&) = default;
    };
    Matter now() const { return {scene_.lines().revision(), window_}; }
    bool many() const { return scene_.lines().size() > pace_.atOnce; }
    void follow(const DocumentChange& change);
    void restart();
    void stop();
    void findAtOnce();
    void begin();
    void work();
    void keepFound();

    const Scene& scene_;
    const Pace pace_;
    clipping::Window window_;
    std::optional<Matter> foundOf_{};   ///< of which something is found
    std::optional<std::size_t> seen_{}; ///< lines that were looked at, since the last start
    bool asking_ = false;
    bool upToDate_ = true;
    bool posted_ = false; ///< findAtOnce() will be called
    QTimer soon_, work_;
};

} // namespace app
