// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/permanent_cuts.h"
#include "app/export/export_file.h"
#include "app/export/print_job.h"
#include "app/export/remembered_choice.h"
#include "app/recovery/replay.h"
#include "app/session/file_watch.h"
#include "app/session/recent_files.h"
#include "app/session/samples.h"
#include "app/session/save.h"
#include "app/session/session.h"
#include "app/tiles/sheets.h"
#include "ui/dialogs/in_background.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QDateTime>

namespace ui {

/// The File menu's functions on one session. Asks about unsaved changes before it replaces them.
/// Reading, cutting and writing do not block the window. What is called while another function is
/// busy begins when that one has ended, in the order of the calls.
class Files : public QObject {
    Q_OBJECT

public:
    Files(app::Session& session, QWidget& window, std::unique_ptr<Questions> questions);

    void setQuestions(std::unique_ptr<Questions> questions);

    /// Gives another drawing its place: the files of the window that shall show it, which may be
    /// these; or null: this file is open and shown. Without it, it replaces the drawing here.
    /// Null also if no more can be open.
    using Place = std::function<Files*(const QString& path)>; ///< empty: it is not of a file
    /// Whether another drawing has this file, so that it must not be written.
    using Held = std::function<bool(const QString& path)>;
    void setOthers(Place place, Held held);
    bool isUnused() const; ///< an empty drawing or a sample, without changes: it may be replaced
    bool holds(const QString& path) const; ///< it is the drawing's file, or the one being opened
    bool isOpening() const { return !opening_.isEmpty(); }   ///< a file is being read
    static bool areSame(const QString& a, const QString& b); ///< files: also by links
    /// Why this file must not be written by an export, in one sentence: it is an open drawing.
    QString refusalToWrite(const QString& path) const;

    /// Called once, unless the window is destroyed before; at once if nothing has to be read,
    /// written or waited for.
    using Answer = std::function<void(bool)>;

    void startNew(std::function<void()> started = {}); ///< on the last page
    void clear();                                      ///< the same here, without a question
    void open();
    void open(const QString& path);
    void showLosses(); ///< what was changed or left out when the drawing was opened
    void openSample(const app::Sample& sample);
    /// Opens a document made by the program. The answer has the session that shows it; null: the
    /// person kept the current drawing.
    void openMade(app::Document document, const QString& title,
                  std::function<void(app::Session*)> opened = {});
    void save(Answer saved = {});
    void saveAs(Answer saved = {});
    /// Writes an export in the background; `written` is told whether the file is there.
    void exportTo(const app::ExportJob& job, const QString& path, Answer written = {});
    /// Puts on the clipboard what an export would write.
    void copyExport(const app::ExportJob& job);
    /// Makes the last export of this drawing again, to the same file. False, and nothing is
    /// written: there is none, or it is not known which window or layer it was.
    bool exportAgain();
    /// Prints in the background, at true size, on a printer that the person chooses; `printed` is
    /// told whether the sheets are on their way.
    void printTo(const app::ExportJob& job, const app::PrintChoice& choice, Answer printed = {});
    /// The same to a PDF file.
    void printToFile(const app::ExportJob& job, const app::PrintChoice& choice, const QString& path,
                     Answer printed = {});
    std::optional<app::DrawingExport> lastExport() const; ///< of this drawing; empty: none
    /// What a first export of a drawing begins with: as at the last one of any drawing, in the last
    /// format or in this one.
    app::ExportChoice usualExport() const;
    app::ExportChoice usualExport(const app::Format& format) const;
    QString exportProposal(const app::ExportChoice& choice) const; ///< a path
    QString printProposal() const;                                 ///< of a PDF file
    /// Writes sheets to a folder that the person chooses, or to one PDF file; asks once about all
    /// files that exist. `pattern` names the files, without a folder.
    void exportSheets(const app::Sheets& sheets, const QString& pattern);
    void cutPermanently(const app::PermanentCut& kind); ///< undoable
    void outlineStrokes();                              ///< of the selection; undoable
    void mayClose(const Answer& answer);
    /// How recover() ended. Partly: files were damaged and something is lost, so they should be
    /// kept. Not at all: cancelled, or its file was unreadable and has been set aside.
    enum class Recovered : std::uint8_t { Wholly, Partly, NotAtAll };
    /// Opens a drawing that an earlier run left, with its history, marked as unsaved.
    void recover(const app::Leftover& leftover, const std::function<void(Recovered)>& recovered);

    bool busy() const { return background_.busy(); }
    void whenIdle(std::function<void()> act) { background_.whenIdle(std::move(act)); }
    /// Blocks until nothing is read or written, or until the deadline.
    void wait(QDeadlineTimer deadline = QDeadlineTimer(QDeadlineTimer::Forever))
    {
        background_.wait(deadline);
    }

    Questions& questions() { return *questions_; }
    app::Origin origin() const; ///< restored with the document after a signal ended the program
    QString baseName() const;   ///< the name without the ending of a file
    QString name() const;       ///< for the title: the file's, the sample's, or "Untitled"
    QString title() const;      ///< without the number that tells drawings without a file apart
    int number() const { return number_; }
    /// Tells it apart from another open drawing without a file: "Untitled 2". 1: there is none.
    void setNumber(int number);
    QString sample() const { return sample_; } ///< the key of the sample that is open; empty: none
    std::vector<app::RecentFile> recent() const;
    void forgetRecent();

signals:
    void documentWanted(); ///< finish the gesture: the document is about to be saved or replaced
    void told(const ui::Message& message);
    void notOpened(const ui::Message& why); ///< a file; empty: it was cancelled
    void recentChanged();
    void nameChanged();

private:
    using Turn = InBackground::Turn;

    Files* placeFor(const QString& path = {}) { return place_ ? place_(path) : this; }

    // The consequences of the answers of keepChanges(). Each holds its turn until it has ended.
    void replace(std::function<void(const Turn&)> then); ///< not if the person keeps the drawing
    void read(const QString& path, const Turn& turn);
    bool show(app::Imported imported, const QString& path, const QString& title,
              std::optional<app::SceneBlockCache> blocks = {});
    void tellLosses();
    bool showRecovered(app::Recovered recovered, const app::Leftover& leftover);
    void tellRecovered(const QString& lost, const app::Leftover& leftover);
    void setAside(app::Leftover leftover, const QString& error);

    // Parts of a turn that their answer holds.
    /// `then` is called in the same turn, or in one of its own if the person answers later.
    using Replacing = std::function<void(bool mayReplace, const Turn& turn)>;
    void keepChanges(const Turn& turn, const Replacing& then);
    void saveNow(const Answer& saved);
    void askPath(const Answer& saved);
    void write(const QString& path, const Answer& saved);

    void writeSheets(const app::Sheets& sheets, const QString& path, const Turn& turn);

    void watchFile();
    void reload();

    void noteSaved(const app::Saved& saved, const QString& path);
    /// A cut of the open document in the background.
    struct Cutting {
        QString doing; ///< "Cutting…"
        std::function<app::Cut(const app::Document&, const app::Follower&)> make;
        std::function<void(app::Cut)> show;
    };
    /// Asks for the plan again if the document was changed meanwhile.
    void cutNow(const std::function<Cutting()>& plan, const Turn& turn);
    void showAreas(const app::Cut& cut);
    /// Puts sheets on paper or into a file, on any thread; returns nothing or a sentence.
    using Print = std::function<std::optional<QString>(const app::PrintSheets& sheets,
                                                       const app::Follower& follower)>;
    struct Printing {
        app::ExportJob job;
        app::PrintChoice choice;
        QString onto; ///< "laser", "plan.pdf"
        Print print;
        Answer printed;
    };
    void printNow(const Printing& printing, const Turn& turn);
    std::optional<std::size_t> exportedWindow() const;
    void tellExport(const app::ExportResult& end, const QString& path);
    void tellCut(const QString& done);
    void showCut(app::Cut cut, const app::PermanentCut& kind);
    void noteRecent();
    QString folder() const;
    QString proposal(const QString& ending) const;
    using MakeOptions = app::CutOptions (*)(const app::CutChoices&, const app::Page&);
    app::CutOptions cutAs(MakeOptions make) const;

    app::Session& session_;
    std::unique_ptr<Questions> questions_;
    QString title_, sample_;
    int number_ = 1;
    QString opening_; ///< the file that is being read; empty: none
    Place place_;
    Held held_;
    std::optional<app::DrawingExport> exported_; ///< the last export since this drawing was opened
    QString exportedWindow_;                     ///< the name of its window
    QDateTime seen_; ///< the file's modification time when we last read or wrote it
    app::FileWatch watch_;
    InBackground background_;
};

} // namespace ui
