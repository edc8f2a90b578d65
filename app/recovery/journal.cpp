// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal.h"

#include "app/base/text.h"
#include "app/recovery/journal_folder.h"
#include "app/recovery/log_file.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <new>
#include <semaphore>

namespace app {
namespace {

// Seconds that the replay of records takes, on a slow machine.
constexpr double timeOfRecord = 20e-6, timeOfObject = 0.1e-6, timeOfContainer = 0.4e-6,
                 timeOfByte = 10e-9;

double timeOf(const Edit& edit)
{
    double objects = 0;
    for (const Splice& s : edit.splices)
        objects += s.removed + s.added;
    const double containers = edit.containers ? double(edit.containers->size()) : 0;
    return timeOfRecord + timeOfObject * objects + timeOfContainer * containers;
}

const EditCommand& editOf(const UndoCommand& command)
{
    return static_cast<const EditCommand&>(command);
}

} // namespace

/// What the first job of a document hands over.
struct Journal::Opening {
    std::binary_semaphore inPlace{0};
    std::shared_ptr<QLockFile> claim{};
    std::shared_ptr<LogFile> log{}; ///< null: it failed
    QString error{};                ///< then; empty: there was too little memory

    /// Makes the first files, and removes those of the previous document.
    void make(const QString& folder, JournalBase base, const QString& old)
    {
        std::string bytes;
        try {
            if (!old.isEmpty())
                removeJournal(old);
            bytes = baseBytes(base);
            base = {};
            claim = createJournalFolder(folder);
            if (!claim)
                error = Text::tr("The folder %1 cannot be written.").arg(folder);
            else if (auto wrong = writeWhole(baseFile(folder, 1), bytes))
                error = std::move(*wrong);
            else
                log = LogFile::create(logFile(folder, 1), logHeader(0), error);
        } catch (const std::bad_alloc&) {
            log.reset();
        }
        const bool made = log != nullptr;
        inPlace.release();
        if (made)
            putCopy(folder, 1, bytes);
    }
};

/// What the job of a new base hands over.
struct Journal::Renewal {
    std::binary_semaphore ended{0};
    std::optional<QString> error{}; ///< as in Opening

    void write(const QString& folder, int generation, JournalBase base, bool continues)
    {
        try {
            const std::string bytes = baseBytes(base);
            base = {};
            error = putBase(folder, generation, bytes, continues);
        } catch (const std::bad_alloc&) {
            error.emplace();
        }
        ended.release();
    }
};

Journal::Journal(const EditedDocument& document, const History& history, QString above)
    : Journal(document, history, std::move(above), Limits{})
{
}

Journal::Journal(const EditedDocument& document, const History& history, QString above,
                 const Limits& limits)
    : document_(document), history_(history), above_(std::move(above)), limits_(limits),
      sync_([this](const std::shared_ptr<LogFile>& log, const QString& reason) {
          {
              const std::lock_guard guard(handing_);
              unsynced_ = {log, reason};
          }
          wake();
      })
{
    retry_.setSingleShot(true);
    retry_.setTimerType(Qt::PreciseTimer); // never before nextAttempt_
    connect(&retry_, &QTimer::timeout, this, [this] { whileMemoryLasts([this] { renew(); }); });
    connect(&document, &EditedDocument::changed, this, &Journal::noteLoad);
    connect(&history, &History::pushed, this, &Journal::notePush);
    connect(&history, &History::indexSet, this, &Journal::noteIndex);
    connect(&history, &History::cleanIndexChanged, this, &Journal::noteClean);
    connect(&history, &History::restored, this, &Journal::beginAnew);
    beginAnew();
}

Journal::~Journal() = default;

StepNumber Journal::number(int index) const
{
    return StepNumber(history_.forgotten()) + StepNumber(index);
}

JournalBase Journal::base()
{
    RecordedHistory steps = recorded(history_, limits_.history);
    firstKept_ = number(history_.index() - steps.index);
    return {nextRecord_, firstKept_, origin_, document_.now(), std::move(steps)};
}

/// A step is not lost because there is no memory to record it.
template <class Act>
void Journal::whileMemoryLasts(const Act& act)
{
    try {
        act();
    } catch (const std::bad_alloc&) {
        try {
            fail({});
        } catch (const std::bad_alloc&) { // what can be said later is said then
        }
    }
}

// For the other threads. The event carries nothing: what is handed over is guarded by a semaphore
// or mutex of ours, as ThreadSanitizer does not see into the queue of events.
void Journal::wake()
{
    try {
        QMetaObject::invokeMethod(this, "look", Qt::QueuedConnection);
    } catch (const std::bad_alloc&) {
        unheard_ = true;
    }
}

void Journal::look()
{
    whileMemoryLasts([this] {
        Unsynced unsynced;
        {
            const std::lock_guard guard(handing_);
            std::swap(unsynced, unsynced_);
        }
        if (unsynced.log)
            noteUnsynced(unsynced);
        if (opening_ && opening_->inPlace.try_acquire()) {
            opening_->inPlace.release();
            opened();
        }
        if (renewal_ && renewal_->ended.try_acquire())
            noteBase(*std::exchange(renewal_, nullptr));
    });
}

// For another document, of which nothing can be lost yet.
void Journal::beginAnew()
{
    inHand_.reset();
    setComplete(true);
    whileMemoryLasts([this] { begin(); });
}

// The other thread makes the files, and removes those of the previous document.
void Journal::begin()
{
    nextRecord_ = 0;
    const QString folder = newJournalFolder(above_);
    const auto opening = std::make_shared<Opening>();
    std::vector<std::string> later;
    if (inHand_)
        later.push_back(inHandRecord(inHand_));
    jobs_.post([this, opening, folder, base = base(), old = folder_,
                oldClaim = std::exchange(claim_, {}),
                oldOpening = std::exchange(opening_, {})]() mutable {
        oldClaim.reset();
        oldOpening.reset();
        opening->make(folder, std::move(base), old);
        wake();
    });
    opening_ = opening; // from here on nothing can fail
    folder_ = folder;
    renewal_.reset();
    log_.reset();
    later_.swap(later);
    generation_ = 1;
    replayTime_ = 0;
    index_ = history_.index();
    pushing_ = beyondBase_ = false;
}

/// Whether records can be appended. Waits until the first base is in place: without it, records
/// would be useless.
bool Journal::opened()
{
    if (const auto opening = std::exchange(opening_, nullptr)) {
        opening->inPlace.acquire();
        claim_ = opening->claim;
        log_ = opening->log;
        if (!log_)
            fail(opening->error);
        else
            setComplete(true);
        for (std::string& frame : std::exchange(later_, {}))
            append({std::move(frame)}, timeOfRecord);
    }
    return log_ != nullptr;
}

/// Records go to a new log from now on; the other thread writes the base before it.
bool Journal::startGeneration()
{
    if (renewal_ || !claim_)
        return false;
    QString error;
    auto next = LogFile::create(logFile(folder_, generation_ + 1), logHeader(nextRecord_), error);
    if (!next)
        return false;
    if (log_)
        sync_.appended(log_);
    const auto renewal = std::make_shared<Renewal>();
    jobs_.post([this, renewal, base = base(), folder = folder_, generation = generation_ + 1,
                continues = complete_.load()]() mutable {
        renewal->write(folder, generation, std::move(base), continues);
        wake();
    });
    renewal_ = renewal;
    ++generation_;
    log_ = std::move(next);
    replayTime_ = 0;
    beyondBase_ = false;
    if (inHand_)
        append({inHandRecord(inHand_)}, timeOfRecord);
    return true;
}

// If a base cannot be written, the older base and all logs still lead to the present state, unless
// a record was lost before.
void Journal::noteBase(const Renewal& renewal)
{
    if (renewal.error && !complete_)
        fail(*renewal.error);
    else if (!renewal.error && log_)
        setComplete(true);
    renew();
}

/// Starts a generation if the present one would take long to replay, cannot undo far enough, or
/// lacks records.
void Journal::renew()
{
    if (opening_)
        return;
    const bool retry = !log_ && nextAttempt_.hasExpired();
    if (retry)
        tryLater();
    if (retry && !claim_)
        return begin();
    if ((retry || (log_ && (beyondBase_ || replayTime_ > limits_.replay))) && !startGeneration())
        replayTime_ = 0; // tries again after as many records
}

void Journal::append(Frame frame, double replayTime)
{
    if (!opened())
        return setComplete(false);
    sealFrame(frame, nextRecord_);
    if (const auto wrong = log_->append(frame.parts()))
        return fail(*wrong);
    ++nextRecord_;
    sync_.appended(log_);
    replayTime_ += replayTime + timeOfByte * double(frame.size());
}

/// Appends a record that is of no use without steps: it need not wait for the first base.
void Journal::appendLater(std::string frame)
{
    if (opening_)
        later_.push_back(std::move(frame));
    else if (log_)
        append({std::move(frame)}, timeOfRecord);
}

// The next log must not seem to continue this one.
void Journal::fail(const QString& reason)
{
    log_.reset();
    ++nextRecord_;
    failure_ = reason;
    complete_ = false; // whatever throws below
    tryLater();
    setComplete(false);
}

void Journal::tryLater()
{
    nextAttempt_.setRemainingTime(limits_.retry);
    retry_.start(limits_.retry);
}

void Journal::setComplete(bool complete)
{
    const bool was = complete_.exchange(complete);
    if (!was || !complete)
        emit completeChanged();
}

QString Journal::whyIncomplete() const
{
    if (complete_)
        return {};
    const QString reason = failure_.isEmpty() ? Text::tr("There is not enough memory.") : failure_;
    return Text::tr("Unsaved changes are not protected against a crash: %1 Save the drawing.")
        .arg(reason.endsWith(u'.') ? reason : reason + u'.');
}

// Data that was not synced would be lost with the power. A new base writes everything again.
void Journal::noteUnsynced(const Unsynced& unsynced)
{
    if (QFileInfo(unsynced.log->path()).path() == folder_) // not of a former document
        fail(unsynced.reason);
}

void Journal::notePush(const UndoCommand& command, bool joined)
{
    const EditCommand& edit = editOf(command);
    pushing_ = true;
    inHand_.reset();
    whileMemoryLasts(
        [&] { append(stepRecord(edit, document_.now(), joined), timeOf(edit.next())); });
}

double Journal::timeBetween(int from, int to) const
{
    double time = 0;
    for (int i = std::min(from, to); i < std::max(from, to) && i < history_.count(); ++i)
        time += timeOf(editOf(history_.command(i)).next());
    return time;
}

// After clear(), which precedes another document, there is nothing to record.
void Journal::noteIndex(int index)
{
    const int before = std::exchange(index_, index);
    const bool pushed = std::exchange(pushing_, false);
    whileMemoryLasts([&] {
        if (!pushed && (history_.count() > 0 || history_.forgotten() > 0)) {
            beyondBase_ = beyondBase_ || number(index) < firstKept_;
            if (index != before)
                append({indexRecord(number(index))}, timeBetween(before, index));
        }
        if (unheard_.exchange(false))
            look();
        renew();
    });
}

void Journal::noteClean()
{
    const auto clean = history_.cleanIndex();
    whileMemoryLasts(
        [&] { appendLater(cleanRecord(clean ? std::optional(number(*clean)) : std::nullopt)); });
}

void Journal::noteLoad(const DocumentChange& change)
{
    if (change.everything)
        beginAnew();
}

void Journal::setOrigin(const JournalOrigin& origin)
{
    if (origin == origin_)
        return;
    origin_ = origin;
    whileMemoryLasts([&] { appendLater(originRecord(origin)); });
}

void Journal::setInHand(std::optional<ObjectInHand> object)
{
    if (object == inHand_)
        return;
    inHand_ = std::move(object);
    whileMemoryLasts([&] { append({inHandRecord(inHand_)}, timeOfRecord); });
}

void Journal::wait()
{
    do {
        jobs_.finish();
        look();
    } while (opening_ || renewal_);
}

void Journal::discard()
{
    disconnect(&document_, nullptr, this, nullptr);
    disconnect(&history_, nullptr, this, nullptr);
    jobs_.finish();
    opened();
    log_.reset();
    claim_.reset();
    removeJournal(folder_);
}

} // namespace app

#include "moc_journal.cpp"
