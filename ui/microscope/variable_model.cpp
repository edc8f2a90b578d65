// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/variable_model.h"

#include <algorithm>

namespace ui {

void VariableModel::show(std::vector<app::Variable> variables)
{
    beginResetModel();
    variables_ = std::move(variables);
    endResetModel();
}

int VariableModel::firstChanged() const
{
    const auto found = std::ranges::find_if(variables_, &app::Variable::changed);
    return found == variables_.end() ? -1 : int(found - variables_.begin());
}

int VariableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(variables_.size());
}

int VariableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString VariableModel::text(const app::Variable& variable, int column) const
{
    switch (column) {
    case Name:
        return variable.name;
    case Value:
        return app::valueText(variable);
    case Before: {
        if (!variable.changed() || !variable.before)
            return {};
        app::Variable earlier = variable;
        earlier.value = *variable.before;
        return variable.kind == clipping::ValueKind::Number ? app::shortText(earlier.value)
                                                            : app::valueText(earlier);
    }
    default:
        return !variable.changed() ? QString()
               : variable.before   ? QStringLiteral("\u25cf ") + tr("changed")
                                   : QStringLiteral("+ ") + tr("new");
    }
}

QVariant VariableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || std::size_t(index.row()) >= variables_.size())
        return {};
    const app::Variable& variable = variables_[std::size_t(index.row())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return text(variable, index.column());
    case Qt::TextAlignmentRole:
        return headerData(index.column(), Qt::Horizontal, role);
    case ChangedRole:
        return variable.changed();
    case ShortRole:
        return index.column() == Value && variable.kind == clipping::ValueKind::Number
                   ? app::shortText(variable.value)
                   : text(variable, index.column());
    default:
        return {};
    }
}

QVariant VariableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Value || section == Before ? Qt::AlignRight : Qt::AlignLeft)
                   | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[ColumnCount]{tr("name"), tr("value"), tr("before"), QString()};
    return names[section];
}

} // namespace ui
