// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThread>
#include <QThreadPool>
#include <QTimer>

#include <mutex>
#include <unordered_set>

// Brings all windows to rest at once and in the same way on every machine: background work is
// waited for, and what waits for a while does not wait.

// Qt's table of functions for debuggers (qhooks_p.h): it is told of every object.
extern Q_CORE_EXPORT quintptr qtHookData[]; // NOLINT: Qt's own name

namespace ui {

/// The timers of the thread that calls watch().
class Timers {
public:
    /// To be called before the objects are made.
    static void watch()
    {
        constexpr int added = 3, removed = 4; // QHooks::AddQObject, QHooks::RemoveQObject
        all().thread = QThread::currentThread();
        qtHookData[added] = quintptr(&add);
        qtHookData[removed] = quintptr(&remove);
    }
    /// Ends the waiting of every timer that fires once. False: none was waiting, and none that
    /// repeats is due.
    static bool fire()
    {
        bool some = false;
        for (const QPointer<QTimer>& timer : waiting()) {
            some = true;
            if (!timer || !timer->isActive() || !timer->isSingleShot())
                continue;
            timer->stop();
            QMetaObject::invokeMethod(timer, "timeout");
        }
        return some;
    }

private:
    struct All {
        std::mutex lock;
        QThread* thread = nullptr;
        std::unordered_set<QObject*> made; ///< since the last look: not known yet what they are
        std::unordered_set<QObject*> timers;
    };
    static All& all()
    {
        static All one;
        return one;
    }
    static void add(QObject* object)
    {
        const std::scoped_lock lock(all().lock);
        if (QThread::currentThread() == all().thread)
            all().made.insert(object);
    }
    static void remove(QObject* object)
    {
        const std::scoped_lock lock(all().lock);
        all().made.erase(object);
        all().timers.erase(object);
    }
    static QList<QPointer<QTimer>> waiting()
    {
        QList<QPointer<QTimer>> found;
        const std::scoped_lock lock(all().lock);
        for (QObject* object : std::exchange(all().made, {}))
            if (qobject_cast<QTimer*>(object))
                all().timers.insert(object);
        for (QObject* object : all().timers)
            if (auto* timer = static_cast<QTimer*>(object);
                timer->isActive() && (timer->isSingleShot() || timer->interval() == 0))
                found << timer;
        return found;
    }
};

/// The platform without a screen remarks on every window, so often that QtTest gives up.
inline void dropRemarksOfThePlatform()
{
    static QtMessageHandler before = nullptr;
    before = qInstallMessageHandler(
        [](QtMsgType type, const QMessageLogContext& context, const QString& message) {
            if (!message.startsWith(QStringLiteral("This plugin does not support")))
                before(type, context, message);
        });
}

/// Until nothing happens any more. False: it goes on for ever.
inline bool settle()
{
    constexpr int most = 3000, enough = 2; // each of up to 1,000 sheets takes a turn or two
    for (int turn = 0, quiet = 0; turn < most; ++turn) {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        bool works = false; // what ends may begin the next
        for (QThreadPool* threads : {&app::backgroundThreads(), &app::paintingThreads()}) {
            works = works || threads->activeThreadCount() > 0;
            threads->waitForDone();
        }
        quiet = Timers::fire() || works ? 0 : quiet + 1;
        if (quiet > enough)
            return true;
    }
    return false;
}

} // namespace ui
