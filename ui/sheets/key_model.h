// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings/key_table.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// The commands and their keys, menu by menu, below the name of each menu: those that fit what is
/// looked for.
class KeyModel : public CheckedModel {
    Q_OBJECT

public:
    using CheckedModel::CheckedModel;

    /// Shows the commands of a table that contain all words of `words` in name, menu or keys.
    void show(const app::KeyTable& table, const QString& words);
    void tellKeys(const app::KeyTable& table); ///< the commands are the same

    /// The command of a row; empty: it is the name of a menu.
    std::optional<std::size_t> command(int row) const;
    int rowOf(std::size_t command) const; ///< -1: it is not shown

protected:
    int rows() const override { return int(rows_.size()); }
    int columns() const override { return 2; }
    QVariant cell(int row, int column, int role) const override;
    QVariant heading(int column, int role) const override;

private:
    struct Row {
        std::optional<std::size_t> command;
        QString name, keys;
        bool isOwn = false; ///< the person gave these keys
    };
    static Row rowFor(const app::KeyTable& table, std::size_t command);

    std::vector<Row> rows_;
};

} // namespace ui
