// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_in_hand.h"
#include "app/recovery/journal_base.h"
#include "app/recovery/journal_thread.h"

#include <QDeadlineTimer>
#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <mutex>
#include <vector>

namespace app {

class LogFile;

/// Keeps every finished step of an open document on disk: when push, undo or redo returns, the
/// step is in a file of the system, which outlives the process; another thread puts it on the disk
/// within a second, for a loss of power. A step costs one write of some bytes (change_bytes.h).
///
/// The file begins with a base: the drawing with its history. When the replay of all later records
/// would take long, a thread writes a new base. A base holds the newest steps that use at most
/// 32 MB; older steps cannot be undone after a recovery. Two ways lead to the present state
/// (journal_folder.h), so that a damaged file costs at most the steps after the damage.
///
/// If the disk is full or fails, or memory runs out, drawing goes on, `whyIncomplete` says what is
/// wrong, and the journal tries again and again to start with a new base.
class Journal : public QObject {
    Q_OBJECT

public:
    struct Limits {
        std::size_t history = 32'000'000;        ///< bytes of memory that the steps in a base use
        double replay = 0.3;                     ///< seconds, estimated
        std::chrono::milliseconds retry{10'000}; ///< after a failure
    };

    /// Starts at once, with a journal in `above`. Follows the document when another one is loaded.
    Journal(const EditedDocument& document, const History& history, QString above);
    Journal(const EditedDocument& document, const History& history, QString above,
            const Limits& limits);
    /// Leaves the files for the next start. Waits for a base that is being written.
    ~Journal() override;
    void discard(); ///< removes the files: there is nothing to recover. The last call.

    void setOrigin(const JournalOrigin& origin);
    /// The object being drawn or edited, or none. The last step of a recovered drawing.
    void setInHand(std::optional<ObjectInHand> object);

    QString folder() const { return folder_; }
    /// Waits until the document is on the disk; returns whether it is.
    bool ready() { return opened(); }
    /// Whether every step so far is in the files; any thread may ask.
    bool complete() const { return complete_; }
    /// Why they are not, and what to do, as sentences; empty: they are.
    QString whyIncomplete() const;
    /// Blocks until no file is being written, for tests.
    void wait();

signals:
    void completeChanged(); ///< or whyIncomplete()

private slots:
    void look(); ///< at what the other threads have handed over

private:
    struct Opening;
    struct Renewal;
    /// A log that may not be on the disk.
    struct Unsynced {
        std::shared_ptr<LogFile> log{};
        QString reason{};
    };

    template <class Act>
    void whileMemoryLasts(const Act& act);
    void wake();
    void beginAnew();
    void begin();
    bool startGeneration();
    void noteBase(const Renewal& renewal);
    void renew();
    bool opened();
    void append(Frame frame, double replayTime);
    void appendLater(std::string frame);
    void fail(const QString& reason);
    void tryLater();
    void setComplete(bool complete);
    void noteUnsynced(const Unsynced& unsynced);
    void notePush(const UndoCommand& command, bool joined);
    void noteIndex(int index);
    void noteClean();
    void noteLoad(const DocumentChange& change);
    JournalBase base();
    StepNumber number(int index) const;
    double timeBetween(int from, int to) const;

    const EditedDocument& document_;
    const History& history_;
    const QString above_;
    const Limits limits_;
    QString folder_;
    std::shared_ptr<QLockFile> claim_;
    std::shared_ptr<Opening> opening_; ///< the first generation, until it is known to be in place
    std::shared_ptr<Renewal> renewal_; ///< the next one, until its base is known to be in place
    std::shared_ptr<LogFile> log_;     ///< null: not open yet, or failed
    int generation_ = 0;
    std::uint64_t nextRecord_ = 0;
    double replayTime_ = 0;          ///< of the records since the last base, estimated in seconds
    StepNumber firstKept_ = 0;       ///< the first step of the last base
    int index_ = 0;                  ///< of the history, as far as recorded
    bool pushing_ = false;           ///< between History::pushed and indexChanged
    bool beyondBase_ = false;        ///< undone more than the last base can undo
    QString failure_;                ///< why records are not appended; empty: too little memory
    QDeadlineTimer nextAttempt_;     ///< after a failure
    QTimer retry_;                   ///< the same, where nothing else happens
    std::vector<std::string> later_; ///< records that wait until the log is open
    JournalOrigin origin_;
    std::optional<ObjectInHand> inHand_;
    std::atomic<bool> complete_ = true;
    std::atomic<bool> unheard_ = false; ///< there was no memory to wake this thread: look later
    std::mutex handing_;
    Unsynced unsynced_; ///< under handing_
    LogSync sync_;
    JobThread jobs_; ///< last: it ends before its data
};

} // namespace app
