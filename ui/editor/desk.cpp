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
#include <QSettings>
#include <QStackedLayout>
#include <QStatusBar>

#include <algorithm>
#include <map>
#include <set>
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
        if (open.window)
            open.window->removeEventFilter(this);
        delete open.window;
    }
}

Desk::Open& Desk::add() { return addWindow(open_.emplace_back()); }

Desk::Open& Desk::addWindow(Open& open)
{
    auto* window = new MainWindow(backend_, this);
    open.window = window;
    addMenus(*window);
    window->setDrawings(this);
    window->files().setOthers(
        [this, window](const QString& path) { return placeFor(*window, path); },
        [this, window](const QString& path) {
            return std::ranges::any_of(
                open_, [&](const Open& one) { return one.window != window && holds(one, path); });
        });
    window->installEventFilter(this);
    DrawingTabs& tabs = window->drawingTabs();
    connect(&tabs, &DrawingTabs::chosen, this, &Desk::showTab);
    connect(&tabs, &DrawingTabs::closeWanted, this, &Desk::closeTab);
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
    addRecovery(open);
    emit made(*window);
    return open;
}

bool Desk::holds(const Open& open, const QString& path) const
{
    return open.window ? open.window->files().holds(path) : Files::areSame(open.file, path);
}

void Desk::keepJournals(const QString& folder)
{
    folder_ = folder;
    for (Open& open : open_)
        addRecovery(open);
}

void Desk::offerRecovery() { open_[current_].recovery->offer(); }

void Desk::addRecovery(Open& open)
{
    if (folder_.isEmpty() || !open.window || open.recovery)
        return;
    open.recovery = std::make_unique<Recovery>(*open.window, folder_);
    open.recovery->setPlace(
        [this](const QString& path) -> Recovery& { return placeToRecover(path); });
}

/// The tab of the same file, unless it has changes of its own; or an unused one, or a further one.
Recovery& Desk::placeToRecover(const QString& path)
{
    const auto has = [&](const Open& open) {
        return !path.isEmpty() && holds(open, path)
               && (!open.window || open.window->session().history.isClean());
    };
    const auto same = std::ranges::find_if(open_, has);
    MainWindow* window = same == open_.end() ? unused(current())
                         : same->window      ? same->window
                                             : addWindow(*same).window;
    showWindow(window ? *window : *add().window);
    return *open_[current_].recovery;
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
        open_, [](const Open& open) { return open.window && open.window->files().isUnused(); });
    return found == open_.end() ? nullptr : found->window;
}

/// For one more drawing; the window that asks tells if there is none.
bool Desk::hasRoom(MainWindow& asking) const
{
    if (count() < most_)
        return true;
    asking.tell({Message::Kind::Warning,
                 Text::tr("%1 drawings are open, and no more can be. Close one first (Ctrl+W).")
                     .arg(most_)});
    return false;
}

MainWindow* Desk::addEmpty()
{
    if (!hasRoom(current()))
        return nullptr;
    MainWindow& window = *add().window;
    showWindow(window);
    return &window;
}

Files* Desk::placeFor(MainWindow& from, const QString& path)
{
    MainWindow& asking = numberOf(from) == open_.size() ? current() : from; // it is being closed
    asking.canvas().endGesture(); // what it has made is a use
    MainWindow* window = unused(asking);
    const auto same =
        path.isEmpty() ? open_.end()
                       : std::ranges::find_if(open_, [&](auto& open) { return holds(open, path); });
    if (same != open_.end() && (same->window || !window)) {
        showTab(int(same - open_.begin()));
        return nullptr;
    }
    if (same != open_.end()) { // the unused window takes the place of the drawing to be read
        const auto number = std::size_t(same - open_.begin());
        const std::size_t place = numberOf(*window);
        open_.erase(same);
        if (current_ > number)
            --current_;
        move(int(place - (place > number)), int(number - (place < number)));
    }
    if (!window && !hasRoom(asking))
        return nullptr;
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

void Desk::showTab(int number)
{
    Open& open = open_[std::size_t(number)];
    if (open.window)
        return showWindow(*open.window);
    MainWindow& window = *addWindow(open).window;
    showWindow(window);
    window.files().open(open.file);
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

/// The window that was made for a file which could not be read has no purpose. If the person
/// cancelled, the file is read when its tab is shown again.
void Desk::removeUnopened(MainWindow& window, const Message& why)
{
    const std::size_t number = numberOf(window);
    const auto next = nearestRead(number);
    if (number == open_.size() || !next || !window.files().isUnused())
        return;
    if (number == current_)
        showWindow(*open_[*next].window);
    if (QString file = open_[number].file; !file.isEmpty() && why.sentence.isEmpty()) {
        removeWindow(std::exchange(open_[number], Open{nullptr, std::move(file)}));
        return showTabs();
    }
    remove(number);
    current().tell(why);
}

/// Of the other drawings; empty: none is read yet.
std::optional<std::size_t> Desk::nearestRead(std::size_t number) const
{
    for (std::size_t by = 1; by < open_.size(); ++by) {
        if (number + by < open_.size() && open_[number + by].window)
            return number + by;
        if (number >= by && open_[number - by].window)
            return number - by;
    }
    return std::nullopt;
}

void Desk::open(const QStringList& files)
{
    for (const QString& file : files)
        current().files().open(file);
}

void Desk::showNext(int by) { showTab((int(current_) + by + count()) % count()); }

void Desk::closeTab(int number)
{
    Open& open = open_[std::size_t(number)];
    if (open.window)
        return close(*open.window);
    closed_ << open.file;
    remove(std::size_t(number));
    current().refreshActions(); // it can be opened again
}

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

void Desk::remove(std::size_t number)
{
    if (number == current_)
        showTab(int(number + 1 < open_.size() ? number + 1 : number - 1));
    Open gone = std::move(open_[number]);
    open_.erase(open_.begin() + std::ptrdiff_t(number));
    if (current_ > number)
        --current_;
    if (gone.window)
        removeWindow(std::move(gone));
    showTabs();
    emit currentChanged();
}

/// The window is deleted when the functions of its menus have ended.
void Desk::removeWindow(Open gone)
{
    gone.window->saveLayout();
    gone.window->removeEventFilter(this);
    gone.recovery.reset();
    pages_->removeWidget(gone.window);
    gone.window->hide();
    gone.window->deleteLater();
}

void Desk::reopen()
{
    if (!canReopen())
        return;
    const bool hasPlace = count() < most_ || unused(current());
    current().files().open(hasPlace ? closed_.takeLast() : closed_.last());
}

bool Desk::carry(MainWindow& from, const Canvas::Carried& carried)
{
    DrawingTabs& tabs = from.drawingTabs();
    const int found = tabs.tabAt(carried.at);
    const int tab = found == int(current_) ? -1 : found;
    const bool moves = carried.modifiers & Qt::ShiftModifier;
    tabs.mark(carried.dropped ? -1 : tab);
    if (tab < 0 || carried.dropped)
        from.statusBar()->clearMessage();
    else
        from.statusBar()->showMessage(
            (moves ? Text::tr("Release: move to %1") : Text::tr("Release: copy to %1. Shift: move"))
                .arg(tabs.name(tab)));
    if (!carried.dropped && !from.window()->frameGeometry().contains(carried.at))
        QMetaObject::invokeMethod(
            this,
            [this, &from] {
                if (numberOf(from) < open_.size())
                    dragOut(from);
            },
            Qt::QueuedConnection);
    if (tab >= 0 && carried.dropped) // when the gesture has been given up
        QMetaObject::invokeMethod(
            this, [this, &from, tab, moves] { give(from, tab, Leaves(moves)); },
            Qt::QueuedConnection);
    return tab >= 0;
}

/// Copies or moves what is selected to the drawing of another tab, which is shown.
void Desk::give(MainWindow& from, int tab, Leaves leaves)
{
    if (numberOf(from) == open_.size() || tab >= count())
        return;
    showTab(tab);
    giveSelection(from, current(), leaves);
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

/// Those without a file have names of their own, also in questions and for files to write.
void Desk::numberDrawings()
{
    std::map<QString, std::set<int>> all;
    for (const Open& open : open_) {
        if (!open.window || !open.window->session().path().isEmpty())
            continue;
        Files& files = open.window->files();
        std::set<int>& taken = all[files.title()];
        int number = files.number();
        if (taken.contains(number))
            for (number = 1; taken.contains(number); ++number) {
            }
        taken.insert(number);
        files.setNumber(number);
    }
}

void Desk::showTabs()
{
    numberDrawings();
    std::vector<DrawingTab> tabs;
    for (const Open& open : open_)
        if (open.window)
            tabs.push_back({open.window->files().name(), open.window->session().path(),
                            !open.window->session().history.isClean()});
        else
            tabs.push_back({QFileInfo(open.file).fileName(), open.file, false});
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
    rememberTabs();
}

QString Desk::restoreTabs(bool wanted)
{
    kept_ = app::openDrawings(QSettings(), most_ - 1);
    const app::OpenDrawings kept = *kept_;
    std::vector<Open> all;
    for (int i = 0; i < int(kept.files.size()); ++i)
        if (wanted && i == kept.shown) {
            current_ = all.size();
            all.push_back(std::move(open_.front()));
        } else {
            all.push_back({nullptr, kept.files[i]});
        }
    if (!wanted || kept.shown < 0) {
        current_ = all.size();
        all.push_back(std::move(open_.front()));
    }
    open_ = std::move(all);
    showTabs();
    return wanted ? kept.files.value(kept.shown) : QString();
}

/// A drawing that is being read is not the one to show: it may be the reason for a crash.
void Desk::rememberTabs()
{
    if (!kept_)
        return;
    if (!app::reopensDrawings(QSettings()))
        return void(kept_ = app::OpenDrawings{});
    app::OpenDrawings now;
    for (std::size_t i = 0; i < open_.size(); ++i) {
        const Open& open = open_[i];
        const QString path = open.window ? open.window->session().path() : QString();
        const bool isToBeRead = !open.window || open.window->files().isOpening();
        if (i == current_ && !path.isEmpty())
            now.shown = int(now.files.size());
        if (const QString& file = isToBeRead && path.isEmpty() ? open.file : path; !file.isEmpty())
            now.files << file;
    }
    if (now != *kept_) {
        QSettings settings;
        app::keepOpenDrawings(settings, now);
        kept_ = now;
    }
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
        if (!open.window)
            continue;
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
