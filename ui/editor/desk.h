// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/open_drawings.h"
#include "ui/editor/carrying.h"
#include "ui/editor/recovery.h"
#include "ui/window/drawings.h"
#include "ui/window/main_window.h"

#include <QPointer>
#include <QStringList>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QDockWidget;
class QStackedLayout;

namespace ui {

/// The program's window: the open drawings, each with a MainWindow of its own, of which one is
/// shown, with tabs while there are several. Each has its own undo steps, view and journal; tool,
/// workspace and theme go along from one to the next.
class Desk : public QWidget, public Drawings {
    Q_OBJECT

public:
    explicit Desk(Backend backend = Backend::Automatic, QWidget* parent = nullptr);
    ~Desk() override;

    void keepJournals(const QString& folder = app::leftoverFolder()); ///< from now on
    void offerRecovery(); ///< of what earlier runs left; each in a window of its own
    /// Adds the tabs of the last run, and remembers the open drawings from now on. A drawing is
    /// read when its tab is first shown. Returns the file that was shown, which is to be opened
    /// now, if it is wanted; empty: none was.
    QString restoreTabs(bool wanted = true);

    MainWindow& current() const { return *open_[current_].window; }
    /// Not of a drawing that is still to be read.
    MainWindow& at(int number) const { return *open_[std::size_t(number)].window; }
    bool isRead(int number) const { return open_[std::size_t(number)].window; }
    void showTab(int number); ///< reads the drawing if it was not shown before
    void setMost(int drawings) { most_ = drawings; } ///< that can be open at a time
    void showWindow(MainWindow& window) override;
    void open(const QStringList& files);

    int count() const override { return int(open_.size()); }
    void showNext(int by) override;
    MainWindow* addEmpty() override;
    void close(MainWindow& window) override;
    void closeTab(int number);
    void reopen() override;
    bool canReopen() const override { return !closed_.isEmpty(); }
    bool carry(MainWindow& from, const Canvas::Carried& carried) override;

    using QWidget::close;
    bool isLeaving() const { return leaving_ == Leaving::Agreed; } ///< all may be closed

signals:
    void made(MainWindow& window); ///< a further one
    void currentChanged();

protected:
    void closeEvent(QCloseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Open {
        MainWindow* window = nullptr; ///< null: the drawing was not shown yet
        QString file{};               ///< that is read when it is shown
        std::unique_ptr<Recovery> recovery{};
        QList<QPointer<QDockWidget>> floating{}; ///< panels to show again with the window
        /// The revision at which the person agreed to quit.
        std::optional<std::uint64_t> mayClose{};
    };
    std::size_t numberOf(const MainWindow& window) const; ///< count(): it is being closed
    Open& add();
    Open& addWindow(Open& open);
    bool holds(const Open& open, const QString& path) const;
    Recovery& placeToRecover(const QString& path);
    Files* placeFor(MainWindow& asking, const QString& path);
    MainWindow* unused(MainWindow& asking);
    bool hasRoom(MainWindow& asking) const;
    void addRecovery(Open& open);
    void hideFloating(Open& open);
    void removeUnopened(MainWindow& window, const Message& why);
    std::optional<std::size_t> nearestRead(std::size_t number) const;
    void remove(std::size_t number);
    void removeWindow(Open gone);
    void move(int from, int to);
    void numberDrawings();
    void showTabs();
    void rememberTabs();
    void give(MainWindow& from, int tab, Leaves leaves);
    void askNext();
    void stay();

    Backend backend_;
    int most_ = 30; ///< each needs some 10 MB and a moment when the program starts or ends
    QStackedLayout* pages_;
    std::vector<Open> open_; ///< in the order of the tabs; never empty
    std::size_t current_ = 0;
    QStringList closed_;                    ///< files, the last one last
    QString folder_;                        ///< of journals; empty: none are kept
    std::optional<app::OpenDrawings> kept_; ///< in the settings; empty: they are not remembered
    enum class Leaving : std::uint8_t { No, Asking, Agreed };
    Leaving leaving_ = Leaving::No;
    int round_ = 0;
};

} // namespace ui
