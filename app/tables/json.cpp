// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tables/table.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace app {
namespace {

/// Whole numbers that a double cannot represent stay text, so that no digit is lost.
QJsonValue valueOf(const QString& field, bool numeric)
{
    constexpr double largest = 9007199254740992; // 2^53
    if (field.isEmpty())
        return QJsonValue::Null;
    const double number = field.toDouble();
    return numeric && std::abs(number) <= largest ? QJsonValue(number) : QJsonValue(field);
}

QJsonObject objectOf(const Table& table)
{
    const auto numeric = numericColumns(table);
    QJsonArray rows, names = QJsonArray::fromStringList(table.names);
    for (const QStringList& row : table.rows) {
        QJsonObject object;
        for (qsizetype i = 0; i < row.size(); ++i)
            object[table.names[i]] = valueOf(row[i], numeric[std::size_t(i)]);
        rows.append(object);
    }
    QJsonObject object{{"columns", names}, {"rows", rows}}, facts;
    for (const auto& [name, value] : table.facts)
        facts[name] = valueOf(value, isNumber(value));
    if (!table.key.isEmpty())
        object["table"] = table.key;
    if (!table.title.isEmpty())
        object["title"] = table.title;
    if (!facts.isEmpty())
        object["facts"] = facts;
    if (!table.notes.isEmpty())
        object["notes"] = QJsonArray::fromStringList(table.notes);
    return object;
}

} // namespace

/// An array of tables. Rows are objects keyed by the column names, numbers are JSON numbers, and
/// empty fields are null.
QString jsonText(std::span<const Table> tables)
{
    QJsonArray all;
    for (const Table& table : tables)
        all.append(objectOf(table));
    return QString::fromUtf8(QJsonDocument(all).toJson());
}

} // namespace app
