// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal.h"

#include "app/recovery/journal_folder.h"
#include "app/recovery/log_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>

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

/// What the first job of a document hands back.
struct Journal::Opening {
    std::binary_semaphore inPlace{0};
    std::shared_ptr<QLockFile> claim{};
    std::shared_ptr<LogFile> log{};
    QString error{};
};

Journal::Journal(const EditedDocument& document, const History& history, QString above)
    : Journal(document, history, std::move(above), Limits{})
{
}

Journal::Journal(const EditedDocument& document, const History& history, QString above,
                 const Limits& limits)
    : document_(document), history_(history), above_(std::move(above)), limits_(limits),
      sync_([this](const std::shared_ptr<LogFile>& log, const QString& reason) {
          QMetaObject::invokeMethod(
              this, [this, log, reason] { noteUnsynced(log, reason); }, Qt::QueuedConnection);
      })
{
    connect(&document, &EditedDocument::changed, this, &Journal::noteLoad);
    connect(&history, &History::pushed, this, &Journal::notePush);
    connect(&history, &History::indexChanged, this, &Journal::noteIndex);
    connect(&history, &History::cleanIndexChanged, this, &Journal::noteClean);
    connect(&history, &History::restored, this, &Journal::begin);
    begin();
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

// A new document: the other thread makes its files, and removes those of the previous document.
void Journal::begin()
{
    const QString old = std::exchange(folder_, newJournalFolder(above_));
    generation_ = 1;
    nextRecord_ = 0;
    replayTime_ = 0;
    index_ = history_.index();
    pushing_ = beyondBase_ = false;
    inHand_.reset();
    later_.clear();
    log_.reset();
    complete_ = true;
    writingBase_ = true;
    auto opening = std::make_shared<Opening>();
    jobs_.post([this, base = base(), folder = folder_, old, oldClaim = std::exchange(claim_, {}),
                oldOpening = std::exchange(opening_, opening), opening]() mutable {
        oldClaim.reset();
        oldOpening.reset();
        if (!old.isEmpty())
            QDir(old).removeRecursively();
        const std::string bytes = baseBytes(base);
        base = {};
        opening->claim = createJournalFolder(folder);
        if (!opening->claim)
            opening->error = tr("The folder %1 cannot be written.").arg(folder);
        else if (const auto wrong = writeWhole(baseFile(folder, 1), bytes))
            opening->error = *wrong;
        else
            opening->log = LogFile::create(logFile(folder, 1), logHeader(0), opening->error);
        const bool inPlace = opening->log != nullptr;
        opening->inPlace.release();
        if (inPlace)
            putCopy(folder, 1, bytes);
        const auto deliver = [this, folder] {
            if (folder == folder_)
                opened();
        };
        QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
    });
}

/// Whether records can be appended. Waits until the first base is in place: without it, records
/// would be useless.
bool Journal::opened()
{
    if (const auto opening = std::exchange(opening_, nullptr)) {
        opening->inPlace.acquire();
        claim_ = opening->claim;
        log_ = opening->log;
        writingBase_ = false;
        if (!log_)
            fail(opening->error);
        for (std::string& frame : std::exchange(later_, {}))
            append({std::move(frame)}, timeOfRecord);
    }
    return log_ != nullptr;
}

/// Records go to a new log from now on; the other thread writes the base before it.
bool Journal::startGeneration()
{
    if (writingBase_ || !claim_)
        return false;
    QString error;
    auto next = LogFile::create(logFile(folder_, generation_ + 1), logHeader(nextRecord_), error);
    if (!next)
        return false;
    if (log_)
        sync_.appended(log_);
    ++generation_;
    log_ = std::move(next);
    replayTime_ = 0;
    beyondBase_ = false;
    writingBase_ = true;
    jobs_.post([this, base = base(), folder = folder_, generation = generation_,
                continues = complete_.load()]() mutable {
        const std::string bytes = baseBytes(base);
        base = {};
        const auto wrong = putBase(folder, generation, bytes, continues);
        const auto deliver = [this, folder, error = wrong.value_or(QString())] {
            if (folder == folder_)
                noteBase(error);
        };
        QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
    });
    if (inHand_)
        append({inHandRecord(inHand_)}, timeOfRecord);
    return true;
}

// If a base cannot be written, the older base and all logs still lead to the present state, unless
// a record was lost before.
void Journal::noteBase(const QString& error)
{
    writingBase_ = false;
    if (!error.isEmpty() && !complete_) {
        fail(error);
    } else if (error.isEmpty() && log_) {
        complete_ = true;
        said_ = false;
    }
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
        nextAttempt_.setRemainingTime(limits_.retry);
    if (retry && !claim_)
        return begin();
    if ((retry || (log_ && (beyondBase_ || replayTime_ > limits_.replay))) && !startGeneration())
        replayTime_ = 0; // tries again after as many records
}

void Journal::append(Frame frame, double replayTime)
{
    if (!opened())
        return say();
    sealFrame(frame, nextRecord_);
    if (const auto wrong = log_->append(frame.parts())) {
        fail(*wrong);
        return say();
    }
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
    complete_ = false;
    failure_ = reason;
    nextAttempt_.setRemainingTime(limits_.retry);
}

// Data that was not synced would be lost with the power. A new base writes everything again.
void Journal::noteUnsynced(const std::shared_ptr<LogFile>& log, const QString& reason)
{
    if (QFileInfo(log->path()).path() != folder_)
        return; // of a former document
    fail(reason);
    say();
}

void Journal::say()
{
    if (!std::exchange(said_, true))
        emit failed(tr("Unsaved changes are not protected against a crash: %1 Save the drawing.")
                        .arg(failure_.endsWith(u'.') ? failure_ : failure_ + u'.'));
}

void Journal::notePush(const UndoCommand& command, bool joined)
{
    const EditCommand& edit = editOf(command);
    pushing_ = true;
    inHand_.reset();
    append(stepRecord(edit, document_.now(), joined), timeOf(edit.next()));
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
    if (!std::exchange(pushing_, false) && (history_.count() > 0 || history_.forgotten() > 0)) {
        beyondBase_ = beyondBase_ || number(index) < firstKept_;
        if (index != before)
            append({indexRecord(number(index))}, timeBetween(before, index));
    }
    renew();
}

void Journal::noteClean()
{
    const auto clean = history_.cleanIndex();
    appendLater(cleanRecord(clean ? std::optional(number(*clean)) : std::nullopt));
}

void Journal::noteLoad(const DocumentChange& change)
{
    if (change.everything)
        begin();
}

void Journal::setOrigin(const JournalOrigin& origin)
{
    if (origin == origin_)
        return;
    origin_ = origin;
    appendLater(originRecord(origin));
}

void Journal::setInHand(std::optional<ObjectInHand> object)
{
    if (object == inHand_)
        return;
    inHand_ = std::move(object);
    append({inHandRecord(inHand_)}, timeOfRecord);
}

void Journal::wait()
{
    while (writingBase_)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    jobs_.finish();
}

void Journal::discard()
{
    disconnect(&document_, nullptr, this, nullptr);
    disconnect(&history_, nullptr, this, nullptr);
    jobs_.finish();
    opened();
    log_.reset();
    claim_.reset();
    QDir(folder_).removeRecursively();
}

} // namespace app
