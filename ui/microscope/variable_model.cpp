// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/variable_model.h"

#include "app/base/numbers.h"
#include "ui/look/text.h"

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

int VariableModel::rows() const { return int(variables_.size()); }

int VariableModel::columns() const { return ColumnCount; }

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
               : variable.before   ? QStringLiteral("\u25cf ") + Text::tr("changed")
                                   : QStringLiteral("+ ") + Text::tr("new");
    }
}

QVariant VariableModel::cell(int row, int column, int role) const
{
    const app::Variable& variable = variables_[std::size_t(row)];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return text(variable, column);
    case Qt::TextAlignmentRole:
        return heading(column, role);
    case ChangedRole:
        return variable.changed();
    case ShortRole:
        return column == Value && variable.kind == clipping::ValueKind::Number
                   ? app::shortText(variable.value)
                   : text(variable, column);
    default:
        return {};
    }
}

QVariant VariableModel::heading(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return sideOf(column == Value || column == Before);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[ColumnCount]{Text::tr("name"), Text::tr("value"), Text::tr("before"),
                                     QString()};
    return names[column];
}

} // namespace ui

#include "moc_variable_model.cpp"
