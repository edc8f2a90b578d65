// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/menus/palette_rows.h"

#include <QFrame>

#include <memory>
#include <optional>

class QLabel;
class QLineEdit;
class QListView;

namespace ui {

class PaletteModel;

/// The field that finds any command by its name, and what the drawing and the manual have, over the
/// canvas (Ctrl+K). Esc and a click elsewhere close it.
class Palette : public QFrame {
    Q_OBJECT

public:
    Palette(MainWindow& window, OtherWindows& others);

    void open(); ///< with an empty field

signals:
    void refused(const QString& reason); ///< why the chosen row cannot be run

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    bool key(const QKeyEvent& event);
    void search();
    void choose(int row);
    void step(int by); ///< to the next row that is no heading
    void showNextPart(int by);
    void run();
    void fit();

    MainWindow& window_;
    OtherWindows& others_;
    std::unique_ptr<PaletteRows> rows_; ///< as they were when it was opened
    std::optional<PaletteRow::Part> only_{};
    QLineEdit* typed_;
    QLabel *count_, *keys_;
    QListView* list_;
    PaletteModel* model_;
};

} // namespace ui
