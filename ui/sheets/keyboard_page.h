// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sheets/key_model.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace ui {

class CommandKeys;
class DenseTable;
class KeyField;
class LookLabel;

/// The keys of all commands. A key that is pressed in the field becomes the only key of the chosen
/// command. If another command has it, the page says so, and offers to take it.
class KeyboardPage : public QWidget {
    Q_OBJECT

public:
    explicit KeyboardPage(CommandKeys& keys, QWidget* parent = nullptr);

    void reset(); ///< gives all commands their standard keys
    void focusFirst();

private:
    void addTable(QVBoxLayout& column);
    void addFields(QVBoxLayout& column);
    void find(const QString& words);
    void choose();
    void take(const QKeySequence& key);
    void takeOver();
    void remove();
    void resetChosen();
    void answer(const QString& sentence, bool refused);
    void follow();

    CommandKeys& keys_;
    KeyModel model_;
    std::optional<std::size_t> chosen_;
    QKeySequence offered_; ///< a key of another command that may be taken; empty: none
    QLineEdit* search_;
    DenseTable* table_;
    QLabel* name_;
    KeyField* field_;
    QPushButton *remove_, *reset_, *takeOver_;
    LookLabel* answer_;
};

} // namespace ui
