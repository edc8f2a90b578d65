// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/desk.h"

#include "ui/files/files.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/look/window_place.h"
#include "ui/menus/actions.h"
#include "ui/sheets/command_keys.h"
#include "ui/window/drawing_tabs.h"

#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QStackedLayout>

#include <algorithm>
#include <map>
#include <utility>

namespace ui {

namespace {

constexpr QSize usualSize(1280, 800);
const QString placeKey = QStringLiteral("geometry"); // in the settings

} // namespace

Desk::Desk(Backend backend, QWidget* parent)
    : QWidget(parent), backend_(backend), pages_(new QStackedLayout(this))
{
    setObjectName(QStringLiteral("desk"));
    setWindowIcon(icon("clearcut"));
    add();
    restorePlace(*this, placeKey, usualSize, current().minimumSize());
    setFocusProxy(&current());
}

Desk::~Desk()
{
    for (Open& open : open_) {
        open.recovery.reset(); // before its window
        open.window->removeEventFilter(this);
        delete open.window;
    }
}

Desk::Open& Desk::add()
{
    auto* window = new MainWindow(backend_, this);
    addMenus(*window);
    window->setDrawings(this);
    window->files().setOthers(
        [this, window](const QString& path) { return placeFor(*window, path); },
        [this, window](const QString& path) {
            return std::ranges::any_of(open_, [&](const Open& open) {
                return open.window != window && open.window->files().holds(path);
            });
        });
    window->installEventFilter(this);
    DrawingTabs& tabs = window->drawingTabs();
    connect(&tabs, &DrawingTabs::chosen, this, [this](int tab) { showWindow(at(tab)); });
    connect(&tabs, &DrawingTabs::closeWanted, this, [this](int tab) { close(at(tab)); });
    connect(&tabs, &DrawingTabs::moved, this, &Desk::move);
    connect(&tabs, &DrawingTabs::newWanted, this, [this] { current().files().startNew(); });
    connect(
        &window->files(), &Files::notOpened, this,
        [this, window = QPointer(window)](const Message& why) {
            if (window)
                removeUnopened(*window, why);
        },
        Qt::QueuedConnection);
    connect(&window->files(), &Files::nameChanged, this, &Desk::showTabs, Qt::QueuedConnection);
    pages_->addWidget(window);
    open_.push_back({window});
    addRecovery(open_.back());
    emit made(*window);
    return open_.back();
}

void Desk::keepJournals(const QString& folder)
{
    folder_ = folder;
    for (Open& open : open_)
        addRecovery(open);
}

void Desk::offerRecovery()
{
    open_[current_].recovery->offer();
}

void Desk::addRecovery(Open& open)
{
    if (folder_.isEmpty() || open.recovery)
        return;
    open.recovery = std::make_unique<Recovery>(*open.window, folder_);
    open.recovery->setPlace([this]() -> Recovery& {
        MainWindow* window = unused(current());
        showWindow(window ? *window : *add().window);
        return *open_[current_].recovery;
    });
}

std::size_t Desk::numberOf(const MainWindow& window) const
{
    return std::size_t(std::ranges::find(open_, &window, &Open::window) - open_.begin());
}

/// The window that asks if it is not in use, else any other such window; null: all are.
MainWindow* Desk::unused(MainWindow& asking)
{
    if (asking.files().isUnused())
        return &asking;
    const auto found = std::ranges::find_if(
        open_, [](const Open& open) { return open.window->files().isUnused(); });
    return found == open_.end() ? nullptr : found->window;
}

Files* Desk::placeFor(MainWindow& from, const QString& path)
{
    MainWindow& asking = numberOf(from) == open_.size() ? current() : from; // it is being closed
    asking.canvas().endGesture(); // what it has made is a use
    if (!path.isEmpty())
        for (const Open& open : open_)
            if (open.window->files().holds(path)) {
                showWindow(*open.window);
                return nullptr;
            }
    MainWindow* window = unused(asking);
    if (!window && count() >= most_) {
        asking.tell({Message::Kind::Warning,
                     Text::tr("%1 drawings are open, and no more can be. Close one first (Ctrl+W).")
                         .arg(most_)});
        return nullptr;
    }
    if (!window)
        window = add().window;
    showWindow(*window);
    return &window->files();
}

void Desk::showWindow(MainWindow& window)
{
    if (numberOf(window) == open_.size())
        return;
    MainWindow& before = current();
    current_ = numberOf(window);
    if (&before != &window) {
        before.canvas().endGesture();
        if (before.isPresenting()) // it enlarges all type
            before.togglePresenting();
        hideFloating(open_[numberOf(before)]);
        CommandKeys::of(window).reread();
        window.takeOver(before);
        pages_->setCurrentWidget(&window);
        for (const QPointer<QDockWidget>& dock : std::exchange(open_[current_].floating, {}))
            if (dock)
                dock->show();
        setFocusProxy(&window);
        QWidget* const last = window.focusWidget(); // such as a field of its sheet
        (last ? last : &window.canvas())->setFocus();
    }
    showTabs();
    emit currentChanged();
}

/// Panels that float are windows, which do not hide with the page that owns them.
void Desk::hideFloating(Open& open)
{
    for (auto* dock :
         open.window->findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (dock->isFloating() && dock->isVisible()) {
            open.floating << dock;
            dock->hide();
        }
}

/// The window that was made for a file which could not be read has no purpose.
void Desk::removeUnopened(MainWindow& window, const Message& why)
{
    const std::size_t number = numberOf(window);
    if (number == open_.size() || count() == 1 || !window.files().isUnused())
        return;
    remove(number);
    current().tell(why);
}

void Desk::open(const QStringList& files)
{
    for (const QString& file : files)
        current().files().open(file);
}

void Desk::showNext(int by) { showWindow(at((int(current_) + by + count()) % count())); }

void Desk::close(MainWindow& window)
{
    if (numberOf(window) == open_.size())
        return;
    showWindow(window);
    window.files().mayClose([this, &window](bool agreed) {
        if (!agreed || numberOf(window) == open_.size()) // closed twice
            return;
        if (const QString path = window.session().path(); !path.isEmpty())
            closed_ << path;
        if (count() > 1)
            return remove(numberOf(window));
        window.files().clear();
        window.raisePanel(QStringLiteral("start"));
    });
}

/// The window is deleted when the functions of its menus have ended.
void Desk::remove(std::size_t number)
{
    MainWindow* const window = open_[number].window;
    if (number == current_) {
        const std::size_t next = number + 1 < open_.size() ? number + 1 : number - 1;
        showWindow(*open_[next].window);
    }
    window->saveLayout();
    window->removeEventFilter(this);
    Open gone = std::move(open_[number]);
    open_.erase(open_.begin() + std::ptrdiff_t(number));
    if (current_ > number)
        --current_;
    gone.recovery.reset();
    pages_->removeWidget(window);
    window->hide();
    window->deleteLater();
    showTabs();
    emit currentChanged();
}

void Desk::reopen()
{
    if (!canReopen())
        return;
    const bool hasPlace = count() < most_ || unused(current());
    current().files().open(hasPlace ? closed_.takeLast() : closed_.last());
}

void Desk::move(int from, int to)
{
    const MainWindow* shown = &current();
    const auto moved = open_.begin() + from;
    if (from < to)
        std::rotate(moved, moved + 1, open_.begin() + to + 1);
    else
        std::rotate(open_.begin() + to, moved, moved + 1);
    current_ = numberOf(*shown);
    // The bar is in the middle of its own move.
    QMetaObject::invokeMethod(this, &Desk::showTabs, Qt::QueuedConnection);
}

void Desk::showTabs()
{
    std::vector<DrawingTab> tabs;
    for (const Open& open : open_)
        tabs.push_back({open.window->files().name(), open.window->session().path(),
                        !open.window->session().history.isClean()});
    // Files of the same name are told apart by their folders, and others by numbers.
    std::vector<DrawingTab> named = tabs;
    for (DrawingTab& tab : named)
        if (!tab.tip.isEmpty() && std::ranges::count(tabs, tab.name, &DrawingTab::name) > 1)
            tab.name =
                QStringLiteral("%1 – %2").arg(tab.name, QFileInfo(tab.tip).absoluteDir().dirName());
    std::map<QString, int> numbers;
    for (DrawingTab& tab : named)
        if (const int number = ++numbers[tab.name]; number > 1)
            tab.name = QStringLiteral("%1 (%2)").arg(tab.name).arg(number);
    current().drawingTabs().show(named, int(current_));
    setWindowTitle(current().windowTitle());
    setWindowFilePath(current().windowFilePath());
    setWindowModified(current().isWindowModified());
}

bool Desk::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ModifiedChange || event->type() == QEvent::WindowTitleChange)
        showTabs();
    return QWidget::eventFilter(watched, event);
}

/// Asks about one drawing after the other, and closes the program when all may be closed.
void Desk::closeEvent(QCloseEvent* event)
{
    event->ignore();
    if (leaving_ != Leaving::Agreed) { // again: about what is left to ask, in front
        leaving_ = Leaving::Asking;
        askNext();
    }
    if (leaving_ != Leaving::Agreed)
        return;
    current().saveLayout();
    rememberPlace(*this, placeKey);
    event->accept();
}

/// Each drawing is asked about at the step it has: who goes on drawing is asked again.
void Desk::askNext()
{
    const int round = ++round_; // of questions; one that is asked again withdraws the one before
    for (Open& open : open_) {
        MainWindow& window = *open.window;
        window.canvas().endGesture(); // which may be its only change
        const std::uint64_t step = window.session().document.revision();
        if (open.mayClose == step)
            continue;
        if (!window.session().history.isClean())
            showWindow(window);
        return window.files().mayClose([this, &window, step, round](bool agreed) {
            if (round != round_)
                return;
            const std::size_t number = numberOf(window);
            if (!agreed || number == open_.size())
                return stay();
            open_[number].mayClose = step;
            askNext();
        });
    }
    leaving_ = Leaving::Agreed;
    // close() inside closeEvent would do nothing.
    QMetaObject::invokeMethod(
        this, [this] { close(); }, Qt::QueuedConnection);
}

void Desk::stay()
{
    leaving_ = Leaving::No;
    for (Open& open : open_)
        open.mayClose.reset();
}

} // namespace ui

#include "moc_desk.cpp"
