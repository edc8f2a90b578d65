// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/judge/judge_window.h"

#include "app/base/numbers.h"
#include "app/judge/example_files.h"
#include "ui/judge/verdict_view.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/look/window_place.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/progress_row.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSettings>
#include <QStandardPaths>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr QSize usual(1080, 760), smallest(640, 400);
constexpr int settling = 500, textWidth = 520;

QString folderOf(const QString& path)
{
    return path.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                          : QFileInfo(path).path();
}

} // namespace

JudgeWindow::JudgeWindow(app::Session& session, QWidget* parent)
    : QDialog(parent, Qt::Window), session_(session),
      questions_(std::make_unique<Questions>(*this)),
      choose_(plainButton(Text::tr("Choose &library…"), "folder")),
      again_(plainButton(Text::tr("&Judge again"), "play")),
      example_(plainButton(Text::tr("&Save header and examples…"), "export")),
      copy_(plainButton(Text::tr("Co&py table"))),
      follow_(new QCheckBox(Text::tr("Judge again after each re&build"))),
      strict_(new QCheckBox(Text::tr("S&trict: no end outside"))), file_(new QLabel),
      progress_(new ProgressRow), strip_(new MessageStrip), stack_(new QStackedWidget),
      view_(new VerdictView)
{
    layOut();
    settled_.setSingleShot(true);
    settled_.setInterval(settling);
    connect(choose_, &QPushButton::clicked, this, &JudgeWindow::choose);
    connect(again_, &QPushButton::clicked, this, &JudgeWindow::run);
    connect(example_, &QPushButton::clicked, this, &JudgeWindow::saveExample);
    connect(progress_, &ProgressRow::cancelWanted, this, &JudgeWindow::cancel);
    connect(copy_, &QPushButton::clicked, view_, &VerdictView::copy);
    connect(strict_, &QCheckBox::toggled, this, &JudgeWindow::run);
    connect(view_, &VerdictView::wanted, this, &JudgeWindow::lookAt);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &JudgeWindow::followFile);
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, &JudgeWindow::followFile);
    connect(&settled_, &QTimer::timeout, this, &JudgeWindow::run);
    showState();
}

JudgeWindow::~JudgeWindow() = default;

const app::plug_in::Verdict* JudgeWindow::verdict() const { return view_->verdict(); }

void JudgeWindow::layOut()
{
    setObjectName(QStringLiteral("judge"));
    setWindowTitle(Text::tr("Judge your own algorithm"));
    restorePlace(*this, QStringLiteral("judgeGeometry"), usual, smallest);
    stack_->addWidget(invitation());
    stack_->addWidget(view_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(top());
    column->addWidget(rule(Qt::Horizontal));
    column->addWidget(stack_, 1);
    column->addWidget(strip_);
    column->addWidget(rule(Qt::Horizontal));
    progress_->addButton(copy_);
    column->addWidget(progress_);
}

QWidget* JudgeWindow::top()
{
    file_->setObjectName(QStringLiteral("file"));
    file_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long path is cut off
    follow_->setChecked(true);
    strict_->setToolTip(Text::tr(
        "Demands what Clearcut's own algorithms guarantee: no end outside the window, not even "
        "by rounding. Textbook algorithms do not promise this."));
    auto* whole = new QWidget;
    auto* layout = new QHBoxLayout(whole);
    layout->setContentsMargins(space::betweenGroups, space::labelToField, space::betweenGroups,
                               space::labelToField);
    layout->setSpacing(space::dockMargin);
    layout->addWidget(choose_);
    layout->addWidget(file_, 1);
    layout->addWidget(strict_);
    layout->addWidget(follow_);
    layout->addWidget(again_);
    return whole;
}

/// The page shown until there is a verdict.
QWidget* JudgeWindow::invitation()
{
    auto* text = new QLabel(Text::tr(
        "<p><b>Is your own line clipping right, and how fast is it?</b></p>"
        "<p>1. <b>Save header and examples</b>. One of them is skeleton.c, a C function to fill "
        "in, with its contract and the command that compiles it.<br>"
        "2. Write your algorithm into it, and compile it to a shared library (.so).<br>"
        "3. <b>Choose library</b>. Clearcut tests it on more than 100,000 lines: at corners and "
        "edges, with infinities, and random ones. Every result is compared with exact arithmetic; "
        "each category of lines gives points. Then your algorithm is timed beside the others.</p>"
        "<p>The library runs in a process of its own: a crash or an endless loop does no harm. But "
        "it is a program with all your rights, so choose only libraries from people you "
        "trust.</p>"));
    text->setTextFormat(Qt::RichText);
    text->setWordWrap(true);
    text->setMaximumWidth(textWidth);
    auto* page = new QWidget;
    auto* middle = new QHBoxLayout; // no alignment: the text's height follows from its width
    middle->addStretch(1);
    middle->addWidget(text, 1000);
    middle->addStretch(1);
    auto* column = new QVBoxLayout(page);
    column->addStretch(2);
    column->addLayout(middle);
    column->addSpacing(space::dockMargin);
    column->addWidget(example_, 0, Qt::AlignHCenter);
    column->addStretch(3);
    return page;
}

void JudgeWindow::choose()
{
    const QString last = QSettings().value("plugInLibrary").toString();
    const QString path = questions_->libraryToOpen(folderOf(path_.isEmpty() ? last : path_));
    if (!path.isEmpty())
        take(path);
}

/// Takes a library; asks once per library whether to trust it.
void JudgeWindow::take(const QString& path)
{
    QStringList trusted = QSettings().value("plugInsTrusted").toStringList();
    if (!trusted.contains(path) && !questions_->trustLibrary(path))
        return;
    if (!trusted.contains(path))
        QSettings().setValue("plugInsTrusted", trusted << path);
    QSettings().setValue("plugInLibrary", path);
    path_ = path;
    if (const QStringList old = watcher_.files() + watcher_.directories(); !old.isEmpty())
        watcher_.removePaths(old);
    watcher_.addPaths({path_, QFileInfo(path_).path()});
    run();
}

void JudgeWindow::run()
{
    if (path_.isEmpty())
        return;
    judging_.cancel();
    settled_.stop();
    written_ = QFileInfo(path_).lastModified();
    progress_->start();
    app::plug_in::Case which{.library = path_, .program = program_};
    if (strict_->isChecked())
        which.contract.strictness = app::plug_in::Strictness::Clearcuts;
    judging_.start(
        [which = std::move(which)](const app::Follower& follower) {
            return app::plug_in::judge(which, follower);
        },
        [this](std::optional<app::plug_in::Verdict>&& verdict) { finish(std::move(*verdict)); },
        [this](const app::Progress& progress) { showProgress(progress); });
    showState();
}

void JudgeWindow::cancel()
{
    judging_.cancel();
    showState();
    progress_->tell(Text::tr("Cancelled."));
}

void JudgeWindow::showProgress(const app::Progress& progress)
{
    progress_->showProgress(progress.share, app::progressText(progress));
}

void JudgeWindow::finish(app::plug_in::Verdict verdict)
{
    view_->show(std::make_shared<const app::plug_in::Verdict>(std::move(verdict)));
    stack_->setCurrentWidget(view_);
    progress_->tell(
        Text::tr("Judged at %1.").arg(QTime::currentTime().toString(QStringLiteral("HH:mm:ss"))));
    showState();
}

/// Watches the file again, because a replaced file is no longer watched. Compares its time, because
/// the folder also changes with other files.
void JudgeWindow::followFile()
{
    const QFileInfo file(path_);
    if (path_.isEmpty() || !file.exists() || !isVisible())
        return;
    if (!watcher_.files().contains(path_))
        watcher_.addPath(path_);
    if (follow_->isChecked() && file.lastModified() != written_)
        settled_.start();
}

void JudgeWindow::saveExample()
{
    const QString folder =
        questions_->folderToWrite(Text::tr("Save header and examples in"), folderOf(path_));
    if (folder.isEmpty())
        return;
    QStringList existing;
    const QStringList names = app::plug_in::exampleNames();
    for (const QString& name : names)
        if (const QString path = QDir(folder).filePath(name); QFileInfo::exists(path))
            existing << path;
    if (!existing.isEmpty() && !questions_->overwriteFiles(existing, int(names.size())))
        return;
    const auto result = app::plug_in::writeExample(folder, app::plug_in::Existing::Replace);
    const QString skeleton = QDir(folder).filePath(QStringLiteral("skeleton.c"));
    strip_->tell(result
                     ? Message{Message::Kind::Done,
                               Text::tr("Wrote %1 for you to fill in, and a finished example, "
                                        "example.c. The first lines of each say how to compile it.")
                                   .arg(QDir::toNativeSeparators(skeleton))}
                     : Message{Message::Kind::Warning, result.error});
}

/// Opens the reference's trace in the editor's microscope.
void JudgeWindow::lookAt(const app::plug_in::Finding& finding)
{
    session_.microscope.open({app::exactVariant(), finding.question.line, finding.question.window,
                              app::YAxis::Up,
                              Text::tr("%1: your algorithm clips this line wrongly")
                                  .arg(app::plug_in::categories()[finding.category].name)});
}

void JudgeWindow::showState()
{
    const bool active = judging_.active();
    again_->setEnabled(!path_.isEmpty() && !active);
    progress_->setWorking(active);
    copy_->setVisible(view_->verdict() && !view_->verdict()->unusable);
    view_->setEnabled(!active);
    file_->setText(path_.isEmpty() ? Text::tr("No library chosen") : QFileInfo(path_).fileName());
    file_->setToolTip(QDir::toNativeSeparators(path_));
}

/// Judges a library that was rebuilt while the window was closed.
void JudgeWindow::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    followFile();
}

void JudgeWindow::hideEvent(QHideEvent* event)
{
    settled_.stop();
    rememberPlace(*this, QStringLiteral("judgeGeometry"));
    if (judging_.active() && !event->spontaneous())
        cancel();
    QDialog::hideEvent(event);
}

/// Esc first cancels a running judgement.
void JudgeWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && judging_.active())
        return cancel();
    QDialog::keyPressEvent(event);
}

} // namespace ui

#include "moc_judge_window.cpp"
