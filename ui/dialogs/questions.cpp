// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/questions.h"

#include "app/base/text.h"
#include "app/formats/loss_text.h"
#include "app/session/recent_files.h"
#include "ui/look/text.h"
#include "ui/widgets/message_strip.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrinter>
#include <QPrinterInfo>
#include <QPushButton>

namespace ui {

namespace {

QString ending(const app::Format& format) { return app::latin(format.key); }

QString filter(const app::Format& format)
{
    return QStringLiteral("%1 (*.%2)").arg(format.name, ending(format));
}

/// The button for Return: the first verb, or Cancel if the verb cannot be undone.
enum class Usual : std::uint8_t { FirstVerb, Cancel };

/// A message box with verbs; -1 for Cancel or Esc.
int ask(QWidget& parent, const QString& sentence, const QString& more, const QStringList& verbs,
        Usual usual = Usual::FirstVerb)
{
    QMessageBox box(QMessageBox::NoIcon, QCoreApplication::applicationName(), sentence,
                    QMessageBox::NoButton, &parent);
    box.setInformativeText(more);
    QList<QPushButton*> buttons;
    for (const QString& verb : verbs)
        buttons << box.addButton(verb, buttons.isEmpty() ? QMessageBox::AcceptRole
                                                         : QMessageBox::DestructiveRole);
    QPushButton* const cancel = box.addButton(Text::tr("Cancel"), QMessageBox::RejectRole);
    box.setEscapeButton(cancel);
    box.setDefaultButton(usual == Usual::Cancel ? cancel : buttons.front());
    box.exec();
    return int(buttons.indexOf(static_cast<QPushButton*>(box.clickedButton())));
}

struct FileKind {
    QString name, ending;
};

QString timeText(const QDateTime& time)
{
    const QDateTime here = time.toLocalTime();
    return Text::tr("%1, %2").arg(app::dayText(here.date(), QDate::currentDate()),
                                  QLocale().toString(here.time(), QStringLiteral("HH:mm")));
}

QString pathToWrite(QWidget& window, const QString& title, const QString& proposal,
                    const FileKind& kind, QFileDialog::Options options)
{
    QFileDialog dialog(&window, title, QFileInfo(proposal).path(),
                       QStringLiteral("%1 (*.%2)").arg(kind.name, kind.ending));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOptions(options);
    dialog.setDefaultSuffix(kind.ending);
    dialog.selectFile(QFileInfo(proposal).fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace

QString Questions::fileToOpen(const QString& folder)
{
    QStringList all, filters;
    for (const app::Format& format : app::formats())
        if (format.read) {
            all << QStringLiteral("*.") + ending(format);
            filters << filter(format);
        }
    all << QStringLiteral("*.svgz");
    filters.prepend(Text::tr("All drawings (%1)").arg(all.join(u' ')));
    return QFileDialog::getOpenFileName(&window_, Text::tr("Open"), folder,
                                        filters.join(QStringLiteral(";;")));
}

QString Questions::fileToWrite(const QString& title, const QString& proposal, const QString& kind,
                               const QString& ending)
{
    return pathToWrite(window_, title, proposal, {kind, ending}, {});
}

QString Questions::filesToWrite(const QString& title, const QString& proposal, const QString& kind,
                                const QString& ending)
{
    return pathToWrite(window_, title, proposal, {kind, ending}, QFileDialog::DontConfirmOverwrite);
}

QString Questions::folderToWrite(const QString& title, const QString& folder)
{
    return QFileDialog::getExistingDirectory(&window_, title, folder);
}

QStringList Questions::lessonsToOpen(const QString& folder)
{
    return QFileDialog::getOpenFileNames(&window_, Text::tr("Open lessons"), folder,
                                         Text::tr("Lessons (%1)").arg(QStringLiteral("*.md")));
}

QString Questions::lessonFolderToOpen(const QString& folder)
{
    return QFileDialog::getExistingDirectory(&window_, Text::tr("Open folder of lessons"), folder);
}

QString Questions::libraryToOpen(const QString& folder)
{
    return QFileDialog::getOpenFileName(
        &window_, Text::tr("Choose library"), folder,
        Text::tr("Shared libraries (%1)").arg(QStringLiteral("*.so *.so.*")) + QStringLiteral(";;")
            + Text::tr("All files (%1)").arg(QStringLiteral("*")));
}

bool Questions::trustLibrary(const QString& path)
{
    return ask(window_, Text::tr("Run %1?").arg(QFileInfo(path).fileName()),
               Text::tr("A library is a program with all your rights. It runs in a process of its "
                        "own, so a crash does no harm. Run only libraries from people you trust."),
               {Text::tr("Run library")}, Usual::Cancel)
           == 0;
}

bool Questions::hasPrinter() { return !QPrinterInfo::availablePrinterNames().isEmpty(); }

bool Questions::choosePrinter(QPrinter& printer)
{
    QPrintDialog dialog(&printer, &window_);
    dialog.setWindowTitle(Text::tr("Print"));
    dialog.setOption(QAbstractPrintDialog::PrintPageRange, false); // all sheets are printed
    return dialog.exec() == QDialog::Accepted;
}

bool Questions::overwriteFiles(const QStringList& existing, int all)
{
    constexpr int mostNamed = 3;
    QStringList names;
    for (const QString& path : existing.first(std::min<qsizetype>(existing.size(), mostNamed)))
        names << QFileInfo(path).fileName();
    if (existing.size() > mostNamed)
        names << QStringLiteral("…");
    return ask(window_,
               Text::tr("%1 already contains %2 of the %3 files.")
                   .arg(QFileInfo(existing.front()).path())
                   .arg(existing.size())
                   .arg(all),
               Text::tr("Overwriting replaces: %1").arg(names.join(QStringLiteral(", "))),
               {Text::tr("Overwrite files")}, Usual::Cancel)
           == 0;
}

// The answers are in the order of the enumeration.
void Questions::saveChanges(const QString& name, std::function<void(Answer)> answered)
{
    const auto with = [&](Answer answer) { return [answered, answer] { answered(answer); }; };
    saveChanges_ = strip_->ask({Text::tr("%1 has unsaved changes.").arg(name),
                                {{Text::tr("Save"), with(Answer::Save)},
                                 {Text::tr("Don't save"), with(Answer::DontSave)},
                                 {Text::tr("Cancel"), with(Answer::Cancel)}}});
}

void Questions::endSaveChanges(Answer answer)
{
    if (strip_)
        strip_->give(saveChanges_, std::size_t(answer));
}

bool Questions::saveAsNewFile(const std::vector<app::Loss>& losses)
{
    return ask(window_, Text::tr("%1 Save as a new file?").arg(app::saveAsReason(losses)),
               Text::tr("The original file stays as it is."), {Text::tr("Save as…")})
           == 0;
}

void Questions::showLosses(const QString& name, const std::vector<app::Loss>& losses)
{
    QMessageBox box(QMessageBox::NoIcon, QCoreApplication::applicationName(),
                    Text::tr("What was changed or left out when %1 was opened").arg(name),
                    QMessageBox::Close, &window_);
    box.setInformativeText(app::lossLines(losses).join(u'\n'));
    box.exec();
}

void Questions::aboutLeftover(const app::Leftover& leftover, std::size_t more,
                              std::function<void(Leftover)> answered)
{
    const auto with = [&](Leftover verb) { return [answered, verb] { answered(verb); }; };
    const QString sentence = Text::tr("Clearcut ended before %1 was saved. Its last change: %2.")
                                 .arg(leftover.origin.name, timeText(leftover.ended));
    const QString others = more == 1 ? Text::tr("One more drawing is unsaved.")
                                     : Text::tr("%1 more drawings are unsaved.").arg(more);
    strip_->ask({more == 0 ? sentence : sentence + u' ' + others,
                 {{Text::tr("Recover"), with(Leftover::Recover)},
                  {Text::tr("Discard"), with(Leftover::Discard)},
                  {Text::tr("Later"), with(Leftover::Later)}}});
}

Questions::ChangedFile Questions::aboutChangedFile(const QString& path)
{
    const int verb = ask(
        window_, Text::tr("%1 was changed by another program.").arg(QFileInfo(path).fileName()),
        Text::tr(
            "Overwriting it replaces those changes. Reloading it gives up your unsaved changes."),
        {Text::tr("Overwrite file"), Text::tr("Reload file")}, Usual::Cancel);
    return verb == 0   ? ChangedFile::Overwrite
           : verb == 1 ? ChangedFile::Reload
                       : ChangedFile::Cancel;
}

} // namespace ui
