// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/scene/scene.h"

#include <QTimer>

#include <optional>

namespace app {

/// A result for all lines of an open drawing at the clip window, kept up to date while a question
/// is asked. Lines are examined in the background: few of them at once, so that the result is there
/// before the next frame, or soon after it; many when a series of changes is over. Painting only
/// reads the result.
class LiveFinding : public QObject {
    Q_OBJECT

public:
    /// The current place of the clip window, also during a drag; empty: there is none, and nothing
    /// is found.
    void setWindow(const std::optional<clipping::Window>& window);

    /// Whether the result belongs to the present lines and window, or no question is asked.
    bool upToDate() const { return upToDate_; }
    double progress() const; ///< of the result in progress: 0 to 1
    void finish();           ///< finishes the result before it returns

signals:
    void changed();    ///< the question, the result, or whether it is up to date
    void begun();      ///< a long examination of many lines has started
    void progressed(); ///< more of many lines were examined

protected:
    struct BatchSizes {
        std::size_t atOnce; ///< up to this many lines are few
        std::size_t slice;  ///< lines between two readings of the stop token
    };
    LiveFinding(const EditedDocument& document, const Scene& scene, BatchSizes sizes,
                QObject* parent);

    /// A new question (or none, if false): forgets the last result.
    void askAnew(bool something);

    /// A partial result, which owns everything it uses: it grows on another thread.
    class Finding {
    public:
        Finding() = default;
        virtual ~Finding() = default;
        Q_DISABLE_COPY_MOVE(Finding)
        /// Examines the next `count` lines; at least that many are left.
        virtual void look(const SceneLines& lines, std::size_t count) = 0;
    };

private:
    /// A result for this window, of no lines yet.
    virtual std::unique_ptr<Finding> start(const clipping::Window& window) = 0;
    /// It is the result from now on. All lines were examined; start() made it.
    virtual void keep(Finding& whole) = 0;
    virtual void forget() = 0; ///< drops the result

    /// The lines and the window of a result.
    struct FindingInput {
        std::uint64_t lines; ///< their revision
        std::optional<clipping::Window> window;
        friend bool operator==(const FindingInput&, const FindingInput&) = default;
    };
    FindingInput now() const { return {scene_.lines().revision(), window_}; }
    bool many() const { return scene_.lines().size() > sizes_.atOnce; }
    void follow(const DocumentChange& change);
    void restart();
    void stop();
    void findAtOnce();
    void begin();
    void keepFound(Finding& whole);

    const Scene& scene_;
    const BatchSizes sizes_;
    std::optional<clipping::Window> window_;
    std::optional<FindingInput> foundOf_{}; ///< what the present result is for
    double share_ = 0;                      ///< examined by background_
    bool asking_ = false;
    bool upToDate_ = true;
    bool posted_ = false; ///< a call of findAtOnce() is queued
    QTimer soon_;
    Background<std::unique_ptr<Finding>> background_;
};

} // namespace app
