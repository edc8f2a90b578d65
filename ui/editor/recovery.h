// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recovery/journal.h"
#include "app/recovery/unsaved_work.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace ui {

class MainWindow;

/// Keeps a journal of the drawing, warns as long as unsaved changes cannot be recorded, and offers
/// work that earlier runs left. If the journal could not be written (full disk), a signal that ends
/// the program has the drawing written as SVG. Must be destroyed before its window. Its destructor
/// deletes the journal and the recovered leftover: the drawing is by then saved or given up.
class Recovery : public QObject {
    Q_OBJECT

public:
    explicit Recovery(MainWindow& window, QString folder = app::leftoverFolder(),
                      const app::Journal::Limits& limits = {});
    ~Recovery() override;

    /// Asks about one leftover after the other until the person postpones; then the others wait for
    /// the next start. Begins when the window's file is read.
    void offer();
    /// Gives each leftover that is recovered a window of its own, which asks about the next one.
    /// Without it, this window shows one. `path` is of the drawing's file; empty: it has none.
    using Place = std::function<Recovery&(const QString& path)>;
    void setPlace(Place place) { place_ = std::move(place); }

private:
    void ask(std::vector<app::Leftover> found);
    void recover(const app::Leftover& chosen, const std::function<void(bool)>& ended);
    void tell();
    void warn();
    void forgetRecovered();
    void discardRecovered();
    void keep(int signal) const;

    struct Watch; ///< for signals, shared by all
    MainWindow& window_;
    QString folder_;
    QString file_; ///< where unsaved work is written; the signal watch gets it through work_
    app::UnsavedWork work_;
    app::Journal journal_;
    std::optional<app::Leftover> recovered_; ///< until it is saved, or in the journal
    bool damaged_ = false;                   ///< recovered_ is: its files are kept
    Place place_;
    std::shared_ptr<Watch> watch_;
};

} // namespace ui
