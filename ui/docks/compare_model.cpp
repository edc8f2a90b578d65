// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/compare_model.h"

#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/race/race_text.h"
#include "app/view/frame_times.h"
#include "ui/look/text.h"

#include <QCoreApplication>

#include <array>

namespace ui {

namespace {

/// The data of a cell.
struct Cell {
    const app::RaceRow& row;
    const app::Summary& summary;
    bool timed;
    app::WindowNeeds needs;

    bool measured() const { return !row.milliseconds.empty(); }
};

struct ColumnInfo {
    const char* title;
    const char* meaning;
    QString (*text)(const Cell& cell);
    QVariant (*order)(const Cell& cell);
};

QString nameOf(const Cell& cell) { return app::shortNameOf(cell.row.variant); }

QString onlyIf(bool known, const QString& text) { return known ? text : QStringLiteral("–"); }

QString onlyTimed(const Cell& cell, const QString& text)
{
    return onlyIf(cell.timed && cell.measured(), text);
}

QString limitOf(const Cell& cell)
{
    const QString limit = app::limitText(cell.row.variant, cell.needs);
    return limit.isEmpty() ? Text::tr("clips it") : limit;
}

/// Without meaningful times all keys are equal, which keeps the catalogue's order.
QVariant orderOf(const Cell& cell, double time) { return cell.timed ? time : 0.0; }

// In the order of CompareModel::Column.
constexpr std::array columnInfos{
    ColumnInfo{QT_TRANSLATE_NOOP("Text", "Algorithm"),
               QT_TRANSLATE_NOOP(
                   "Text", "Filled marker: the corrected form. Hollow marker: the published form."),
               nameOf, [](const Cell& c) { return QVariant(nameOf(c)); }},
    ColumnInfo{
        QT_TRANSLATE_NOOP("Text", "last 40 frames"),
        QT_TRANSLATE_NOOP("Text", "Clipping times, from 40 % below to 40 % above the "
                                  "median. The band lies between the quartiles."),
        [](const Cell&) { return QString(); },
        [](const Cell& c) { return orderOf(c, c.measured() ? c.row.milliseconds.back() : 0); }},
    ColumnInfo{
        QT_TRANSLATE_NOOP("Text", "median"),
        QT_TRANSLATE_NOOP("Text", "Clipping time of this frame: the median of several rounds."),
        [](const Cell& c) { return onlyTimed(c, app::shortTimeText(c.summary.median)); },
        [](const Cell& c) { return orderOf(c, c.summary.median); }},
    ColumnInfo{QT_TRANSLATE_NOOP("Text", "± spread"),
               QT_TRANSLATE_NOOP("Text", "Half the distance between the quartiles."),
               [](const Cell& c) { return onlyTimed(c, app::shortTimeText(c.summary.spread / 2)); },
               [](const Cell& c) { return orderOf(c, c.summary.spread); }},
    ColumnInfo{
        QT_TRANSLATE_NOOP("Text", "ops/line"),
        QT_TRANSLATE_NOOP("Text", "Comparisons, additions, multiplications and divisions "
                                  "per line, counted on evenly spaced lines."),
        [](const Cell& c) { return onlyIf(c.measured(), app::numberText(c.row.operations, 1)); },
        [](const Cell& c) { return QVariant(c.row.operations); }},
    ColumnInfo{QT_TRANSLATE_NOOP("Text", "visible"),
               QT_TRANSLATE_NOOP("Text", "Lines that are visible, wholly or in part."),
               [](const Cell& c) { return onlyIf(c.measured(), app::countText(c.row.visible)); },
               [](const Cell& c) { return QVariant(qulonglong(c.row.visible)); }},
    ColumnInfo{
        QT_TRANSLATE_NOOP("Text", "differ"),
        QT_TRANSLATE_NOOP("Text", "Lines that are lost, kept wrongly, or misplaced by "
                                  "more than rounding, compared with exact arithmetic."),
        [](const Cell& c) { return onlyIf(c.measured(), app::countText(c.row.differences.all())); },
        [](const Cell& c) { return QVariant(qulonglong(c.row.differences.all())); }},
    ColumnInfo{QT_TRANSLATE_NOOP("Text", "all windows"),
               QT_TRANSLATE_NOOP("Text", "Whether the algorithm can clip at every clip window of "
                                         "the drawing. Where it cannot, nothing is measured."),
               limitOf, [](const Cell& c) { return QVariant(limitOf(c)); }}};

QString tipOf(const app::RaceRow& row, int column, std::size_t lines)
{
    const clipping::Algorithm& algorithm = *row.variant.algorithm;
    if (column == CompareModel::Differ && row.differences.all() > 0)
        return app::sentence(row.variant, app::exactVariant(), row.differences, lines);
    const QString name = row.variant.form == clipping::Form::Published
                             ? Text::tr("%1, as published").arg(app::latin(algorithm.name))
                             : app::latin(algorithm.name);
    QString tip = Text::tr("%1 (%2)\n%3")
                      .arg(name, QString::number(algorithm.year), app::latin(algorithm.idea));
    if (&algorithm == &clipping::exactAlgorithm())
        tip += u'\n'
               + Text::tr(
                   "Here it clips line by line, like the others. In the editor's own frames it "
                   "also uses bounding boxes of many lines. This is faster, with the same result.");
    return tip;
}

} // namespace

void CompareModel::show(std::span<const app::RaceRow> rows, std::size_t lines,
                        app::WindowNeeds needs)
{
    const auto same = [](const app::RaceRow& one, const app::RaceRow& other) {
        return one.variant == other.variant;
    };
    const bool others = !std::ranges::equal(rows, rows_, same);
    if (others)
        beginResetModel();
    lines_ = lines;
    needs_ = needs;
    rows_.assign(rows.begin(), rows.end());
    summaries_.clear();
    for (const app::RaceRow& row : rows_)
        summaries_.push_back(row.summary());
    if (others)
        endResetModel();
    else
        tellChanged();
}

bool CompareModel::timed() const { return lines_ >= app::leastLinesToTime; }

int CompareModel::rowOf(const app::Variant& variant) const
{
    const auto found = std::ranges::find(rows_, variant, &app::RaceRow::variant);
    return found == rows_.end() ? -1 : int(found - rows_.begin());
}

int CompareModel::rows() const { return int(rows_.size()); }

int CompareModel::columns() const { return int(columnInfos.size()); }

QVariant CompareModel::cell(int row, int column, int role) const
{
    const ColumnInfo& info = columnInfos[std::size_t(column)];
    const Cell cell{rows_[std::size_t(row)], summaries_[std::size_t(row)], timed(), needs_};
    switch (role) {
    case Qt::DisplayRole:
        return info.text(cell);
    case OrderRole:
        return info.order(cell);
    case Qt::ToolTipRole:
        return tipOf(cell.row, column, lines_);
    case Qt::AccessibleTextRole:
        return column == Sparkline ? columnInfos[Median].text(cell) : info.text(cell);
    default:
        return {};
    }
}

QVariant CompareModel::heading(int column, int role) const
{
    const ColumnInfo& info = columnInfos[std::size_t(column)];
    switch (role) {
    case Qt::DisplayRole:
        return Text::tr(info.title);
    case Qt::ToolTipRole:
        return Text::tr(info.meaning);
    case Qt::TextAlignmentRole:
        return int((column <= Sparkline ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    default:
        return {};
    }
}

} // namespace ui

#include "moc_compare_model.cpp"
