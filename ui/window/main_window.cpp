// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "app/base/latin.h"
#include "app/base/numbers.h"
#include "ui/bars/option_bar.h"
#include "ui/bars/status_bar.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/dock.h"
#include "ui/editing/undo_memory.h"
#include "ui/files/files.h"
#include "ui/look/look_icon.h"
#include "ui/look/saved_theme.h"
#include "ui/look/window_place.h"
#include "ui/tools/tool.h"
#include "ui/widgets/window_note.h"
#include "ui/window/commands.h"
#include "ui/window/keyboard.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace ui {

namespace {

const QString placeKey = QStringLiteral("geometry");
constexpr QSize smallest(1024, 640), usual(1280, 800);
constexpr int messageMilliseconds = 5000;

} // namespace

MainWindow::MainWindow(Backend backend, QWidget* parent)
    : QMainWindow(parent), theme_(savedTheme()), canvas_(new Canvas(session_, backend)),
      strip_(new MessageStrip),
      files_(std::make_unique<Files>(session_, *this, std::make_unique<Questions>(*this)))
{
    setMinimumSize(smallest);
    setAcceptDrops(true);
    setWindowIcon(icon("clearcut"));
    addCentre();
    addTools();
    addPanels();
    addBars();
    addMicroscope();
    connectFiles();
    for (const auto signal : {&app::Session::displayChanged, &app::Session::selectionChanged,
                              &app::Session::fileChanged})
        connect(&session_, signal, this, &MainWindow::refreshActions);
    connect(&session_.document, &app::EditedDocument::changed, this, &MainWindow::refreshActions);
    connect(&session_.history, &app::History::cleanChanged, this, &MainWindow::showTitle);
    connect(&session_.history, &app::History::indexChanged, strip_, &MessageStrip::takeBackDone);
    connect(&session_, &app::Session::refused, this, [this](const QString& sentence) {
        tell({Message::Kind::Warning, sentence});
    });
    rememberPanes();
    limitHistory();
    restorePlace(*this, placeKey, usual, minimumSize());
    panelLayout_->restore();
    refreshActions();
    showTitle();
    canvas_->setFocus();
}

void MainWindow::rememberPanes()
{
    if (const auto panes =
            app::Panes::fromText(QSettings().value("panes").toString(), session_.variant()))
        canvas_->setPanes(*panes);
    connect(canvas_, &Canvas::panesChanged, this, [this] {
        QSettings().setValue("panes", canvas_->panes().text());
        refreshActions();
    });
}

// The message is shown once per drawing, and after the command's own message, which would replace
// it.
void MainWindow::limitHistory()
{
    session_.history.setLimit(bytesOf(undoMegabytes()));
    const auto sayWhy = [this] {
        tell({Message::Kind::Warning,
              tr("The oldest steps can no longer be undone: undo may use at most %1 MB of memory "
                 "(menu Settings). Save a copy if you may need this state again.")
                  .arg(app::countText(session_.history.limit() / bytesOf(1)))});
    };
    connect(&session_.history, &app::History::forgot, this, [this, sayWhy](int steps) {
        if (steps == session_.history.forgotten())
            QMetaObject::invokeMethod(this, sayWhy, Qt::QueuedConnection);
    });
}

MainWindow::~MainWindow()
{
    if (fontBefore_)
        QApplication::setFont(*fontBefore_);
    // All widgets use the session, which is destroyed with the members, so they are destroyed
    // first. Without the disconnects the session's last signals would reach deleted widgets.
    const QSignalBlocker quiet(this);
    for (const QObject* source :
         {static_cast<QObject*>(&session_), static_cast<QObject*>(&session_.document),
          static_cast<QObject*>(&session_.history)})
        disconnect(source, nullptr, this, nullptr);
    hide();
    qDeleteAll(findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
}

void MainWindow::addCentre()
{
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(strip_);
    centre_ = new QStackedWidget;
    centre_->addWidget(canvas_);
    column->addWidget(centre_, 1);
    canvas_->setAccessibleName(tr("Drawing"));
    setCentralWidget(centre);
    status_ = new StatusBar(session_, *canvas_);
    setStatusBar(status_);
}

void MainWindow::addTools()
{
    auto* group = new QActionGroup(this);
    for (const ToolInfo& tool : tools()) {
        auto* action = new QAction(icon(tool.key), tool.name, this);
        action->setObjectName(QStringLiteral("tool-") + app::latin(tool.key));
        action->setShortcut(tool.shortcut);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        action->setToolTip(
            tr("%1 (%2)").arg(tool.name, tool.shortcut.toString(QKeySequence::NativeText)));
        action->setCheckable(true);
        group->addAction(action);
        canvas_->addAction(action);
        toolActions_ << action;
        connect(action, &QAction::triggered, canvas_, [this, key = tool.key] {
            session_.microscope.close();
            canvas_->setTool(key);
            canvas_->setFocus();
        });
        connect(canvas_, &Canvas::toolChanged, action,
                [this, action, key = tool.key] { action->setChecked(canvas_->tool() == key); });
        action->setChecked(canvas_->tool() == tool.key);
    }
}

void MainWindow::addBars()
{
    optionBar_ = new OptionBar(session_, *canvas_);
    addToolBar(Qt::TopToolBarArea, optionBar_);
    connect(optionBar_, &OptionBar::refused, strip_, &MessageStrip::refuse);
    connect(optionBar_, &OptionBar::taken, strip_, &MessageStrip::withdrawRefusal);
    auto* bar = new QToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setIconSize({20, 20});
    bar->setFixedWidth(space::toolBarWidth);
    for (qsizetype i = 0; i < toolActions_.size(); ++i) {
        if (tools()[std::size_t(i)].group == ToolInfo::Group::New)
            bar->addSeparator();
        QAction* action = toolActions_[i];
        bar->addAction(action);
        if (QWidget* button = bar->widgetForAction(action))
            button->setFixedSize(space::toolButton, space::toolButton);
    }
    addToolBar(Qt::LeftToolBarArea, bar);
}

void MainWindow::connectFiles()
{
    connect(files_.get(), &Files::documentWanted, canvas_, &Canvas::endGesture);
    connect(files_.get(), &Files::told, this, &MainWindow::tell);
    connect(files_.get(), &Files::nameChanged, this, &MainWindow::showTitle);
}

void MainWindow::setQuestions(std::unique_ptr<Questions> questions)
{
    files_->setQuestions(std::move(questions));
}

void MainWindow::showTitle()
{
    setWindowTitle(tr("%1[*] – Clearcut").arg(files_->name()));
    setWindowFilePath(session_.path());
    setWindowModified(!session_.history.isClean());
}

void MainWindow::setTheme(Theme theme)
{
    theme_ = theme;
    QSettings().setValue("theme", int(theme));
    applyTheme(*qApp, theme);
}

void MainWindow::showStart()
{
    if (const auto samples = app::samples(); !samples.empty())
        files_->openSample(samples.front());
    canvas_->setTool("window");
    panelLayout_->showStart();
    if (!QSettings().value("windowDragged").toBool()) {
        note_ = new WindowNote(session_);
        static_cast<QVBoxLayout*>(centralWidget()->layout())->insertWidget(0, note_);
        connect(note_, &WindowNote::learnt, this, [this] {
            QSettings().setValue("windowDragged", true);
            std::exchange(note_, nullptr)->deleteLater();
        });
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!files_->mayClose())
        return event->ignore();
    rememberPlace(*this, placeKey);
    panelLayout_->save();
    event->accept();
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    panelLayout_->fitWindow();
}

/// Handles a key that no widget took: says why the key's command is disabled, or treats the key as
/// the American one at the same place.
void MainWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && centre_->currentWidget() == canvas_)
        return canvas_->setFocus(); // from a list or a field
    const auto key = keyAtItsPlace(*event);
    const bool onCanvas = canvas_->isAncestorOf(QApplication::focusWidget());
    const QKeySequence pressed(event->keyCombination());
    for (QAction* action : commands(*menuBar())) {
        const bool reached =
            action->shortcutContext() != Qt::WidgetWithChildrenShortcut || onCanvas;
        if (reached && !action->isEnabled() && !action->statusTip().isEmpty()
            && action->shortcuts().contains(pressed))
            return statusBar()->showMessage(action->statusTip(), messageMilliseconds);
        if (key && reached && action->isEnabled()
            && action->shortcuts().contains(QKeySequence(*key)))
            return action->trigger();
    }
    QMainWindow::keyPressEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile())
            return event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) {
            event->acceptProposedAction();
            // Queued until the drop is finished, because a question may follow while the other
            // program waits.
            QMetaObject::invokeMethod(
                this, [this, path = url.toLocalFile()] { files_->open(path); },
                Qt::QueuedConnection);
            return;
        }
}

bool MainWindow::event(QEvent* event)
{
    if (event->type() == QEvent::WindowActivate)
        refreshActions();
    return QMainWindow::event(event);
}

} // namespace ui
