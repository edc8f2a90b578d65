// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/key_model.h"

#include "ui/look/look.h"
#include "ui/look/text.h"

#include <algorithm>

namespace ui {

namespace {

bool hasAll(const QString& text, const QStringList& words)
{
    return std::ranges::all_of(
        words, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace

KeyModel::Row KeyModel::rowFor(const app::KeyTable& table, std::size_t command)
{
    const app::KeyedCommand& info = table.commands()[command];
    return {command, info.name, app::keysText(table.keys(command)), !table.isStandard(command)};
}

void KeyModel::show(const app::KeyTable& table, const QString& words)
{
    const QStringList wanted = words.split(u' ', Qt::SkipEmptyParts);
    beginResetModel();
    rows_.clear();
    QString menu;
    for (std::size_t i = 0; i < table.commands().size(); ++i) {
        const app::KeyedCommand& info = table.commands()[i];
        const Row row = rowFor(table, i);
        if (info.key.isEmpty() || !hasAll(info.menu + u' ' + info.name + u' ' + row.keys, wanted))
            continue;
        if (info.menu != menu)
            rows_.push_back({{}, info.menu, {}});
        menu = info.menu;
        rows_.push_back(row);
    }
    endResetModel();
}

void KeyModel::tellKeys(const app::KeyTable& table)
{
    for (Row& row : rows_)
        if (row.command)
            row = rowFor(table, *row.command);
    tellChanged();
}

std::optional<std::size_t> KeyModel::command(int row) const
{
    return row >= 0 && row < rows() ? rows_[std::size_t(row)].command : std::nullopt;
}

int KeyModel::rowOf(std::size_t command) const
{
    const auto found = std::ranges::find(rows_, std::optional(command), &Row::command);
    return found == rows_.end() ? -1 : int(found - rows_.begin());
}

QVariant KeyModel::cell(int row, int column, int role) const
{
    const Row& shown = rows_[std::size_t(row)];
    if (role == Qt::DisplayRole)
        return column == 0 ? shown.name : shown.keys;
    if (role == Qt::AccessibleTextRole && column == 0)
        return shown.keys.isEmpty() ? shown.name : Text::tr("%1: %2").arg(shown.name, shown.keys);
    if (role == Qt::FontRole && (!shown.command || (column == 1 && shown.isOwn)))
        return semiBold(QFont());
    if (role == Qt::TextAlignmentRole)
        return sideOf(false);
    return {};
}

QVariant KeyModel::heading(int column, int role) const
{
    if (role == Qt::DisplayRole)
        return column == 0 ? Text::tr("Command") : Text::tr("Keys");
    return role == Qt::TextAlignmentRole ? sideOf(false) : QVariant();
}

} // namespace ui

#include "moc_key_model.cpp"
