// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/compare_model.h"

#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/race/race_text.h"
#include "app/view/frame_times.h"
#include "ui/look/text.h"
#include "ui/widgets/dense_table.h"

#include <QCoreApplication>

#include <array>
#include <limits>

namespace ui {

namespace {

using clipping::Form;

/// The data of a cell.
struct Cell {
    const app::RacePair& pair;
    const app::RaceLane& lane;
    bool timed;
    app::WindowNeeds needs;
    int digits;
};

/// What the headings depend on.
struct Heads {
    const app::RaceLane& lane;
    const QString& limiting;
    bool inListsOrder, timed, bothForms, laneShown;
};

struct ColumnInfo {
    QString (*title)(const Heads& heads);
    const char* meaning;
    QString (*text)(const Cell& cell);
    QString (*spoken)(const Cell& cell); ///< for screen readers
    QVariant (*order)(const Cell& cell);
};

QString nameOf(const Cell& cell) { return app::shortNameOf(cell.pair.ablest().row.variant); }

/// In the lane's unit, which the heading names.
QString timeOf(const Cell& cell, Form form)
{
    const auto& result = cell.pair.of(form);
    if (!result)
        return Text::tr("none", "published form");
    return cell.timed && result->measured() ? cell.lane.number(result->summary.median, cell.digits)
                                            : QStringLiteral("–");
}

QString spokenTime(const Cell& cell, Form form)
{
    const auto& result = cell.pair.of(form);
    return result && cell.timed && result->measured() ? cell.lane.text(result->summary.median)
           : result                                   ? Text::tr("not timed")
                                                      : timeOf(cell, form);
}

/// Without meaningful times all keys are equal, which keeps the catalogue's order.
QVariant orderOf(const Cell& cell, Form form)
{
    const auto& result = cell.pair.of(form);
    return !cell.timed ? 0.0
           : result    ? result->summary.median
                       : std::numeric_limits<double>::infinity();
}

QString bothTimes(const Cell& cell)
{
    QStringList times;
    if (cell.pair.corrected)
        times << Text::tr("corrected %1").arg(spokenTime(cell, Form::Corrected));
    if (cell.pair.published)
        times << Text::tr("as published %1").arg(spokenTime(cell, Form::Published));
    return times.join(Text::tr(", "));
}

QString differing(const Cell& cell)
{
    const app::FormResult& judged = cell.pair.judged();
    return judged.measured() ? app::countText(judged.row.differences.all()) : QStringLiteral("–");
}

QString limitOf(const Cell& cell)
{
    const QString limit = app::limitText(cell.pair.ablest().row.variant, cell.needs);
    return limit.isEmpty() ? Text::tr("clips it") : limit;
}

/// With the unit, if no lane says it.
QString timeTitle(const Heads& heads, const QString& marker)
{
    const QString title = heads.bothForms ? marker : Text::tr("median");
    return heads.laneShown
               ? title
               : Text::tr("%1 %2", "a column, and its unit").arg(title, heads.lane.unit());
}

// In the order of CompareModel::Column.
constexpr std::array columnInfos{
    ColumnInfo{[](const Heads& heads) {
                   return heads.inListsOrder ? Text::tr("Algorithm, in the list's order")
                                             : Text::tr("Algorithm");
               },
               QT_TRANSLATE_NOOP(
                   "Text", "Filled marker: the corrected form. Hollow marker: the published form."),
               nameOf,
               [](const Cell& c) {
                   return Text::tr("%1, %2").arg(nameOf(c), app::latin(c.pair.algorithm->name));
               },
               [](const Cell& c) { return QVariant(nameOf(c)); }},
    ColumnInfo{[](const Heads& heads) {
                   return heads.timed ? Text::tr("0 to %1").arg(heads.lane.end()) : QString();
               },
               QT_TRANSLATE_NOOP("Text", "Clipping times, all on the same scale. Filled marker, at "
                                         "the end of the bar: the corrected form. Hollow marker: "
                                         "the published form."),
               [](const Cell&) { return QString(); }, bothTimes,
               [](const Cell& c) { return orderOf(c, c.pair.ablest().row.variant.form); }},
    ColumnInfo{[](const Heads& heads) { return timeTitle(heads, Text::tr("filled", "marker")); },
               QT_TRANSLATE_NOOP("Text", "Clipping time of the corrected form: the median of "
                                         "several rounds."),
               [](const Cell& c) { return timeOf(c, Form::Corrected); },
               [](const Cell& c) { return spokenTime(c, Form::Corrected); },
               [](const Cell& c) { return orderOf(c, Form::Corrected); }},
    ColumnInfo{[](const Heads& heads) { return timeTitle(heads, Text::tr("hollow", "marker")); },
               QT_TRANSLATE_NOOP("Text", "Clipping time of the published form: the median of "
                                         "several rounds."),
               [](const Cell& c) { return timeOf(c, Form::Published); },
               [](const Cell& c) { return spokenTime(c, Form::Published); },
               [](const Cell& c) { return orderOf(c, Form::Published); }},
    ColumnInfo{
        [](const Heads&) { return Text::tr("differ"); },
        QT_TRANSLATE_NOOP("Text", "Lines that the published form loses, keeps wrongly, or "
                                  "misplaces by more than rounding, compared with exact "
                                  "arithmetic. Of the corrected form, if only that is shown."),
        differing, differing,
        [](const Cell& c) { return QVariant(qulonglong(c.pair.judged().row.differences.all())); }},
    ColumnInfo{[](const Heads& heads) {
                   return heads.limiting.isEmpty() ? Text::tr("all windows") : heads.limiting;
               },
               QT_TRANSLATE_NOOP("Text", "Whether the algorithm can clip at every clip window of "
                                         "the drawing. Where it cannot, nothing is measured."),
               limitOf, limitOf, [](const Cell& c) { return QVariant(limitOf(c)); }}};

QString tipOf(const app::RacePair& pair, int column, std::size_t lines)
{
    const app::RaceRow& judged = pair.judged().row;
    if (column == CompareModel::Differ && judged.differences.all() > 0)
        return app::sentence(judged.variant, app::exactVariant(), judged.differences, lines);
    const clipping::Algorithm& algorithm = *pair.algorithm;
    QStringList tip{
        Text::tr("%1 (%2)").arg(app::latin(algorithm.name), QString::number(algorithm.year)),
        app::latin(algorithm.idea)};
    for (const auto& form : {pair.corrected, pair.published})
        if (form && form->measured())
            tip << app::figuresText(*form, lines >= app::leastLinesToTime);
    if (&algorithm == &clipping::exactAlgorithm())
        tip << Text::tr(
            "Here it clips line by line, like the others. In the editor's own frames it also uses "
            "bounding boxes of many lines. This is faster, with the same result.");
    return tip.join(u'\n');
}

} // namespace

void CompareModel::show(std::span<const app::RaceRow> rows, std::size_t lines,
                        app::WindowNeeds needs, const QString& limiting)
{
    std::vector<app::RacePair> pairs = app::pairsOf(rows);
    const auto same = [](const app::RacePair& one, const app::RacePair& other) {
        return one.algorithm == other.algorithm
               && one.corrected.has_value() == other.corrected.has_value()
               && one.published.has_value() == other.published.has_value();
    };
    const bool others = !std::ranges::equal(pairs, pairs_, same);
    if (others)
        beginResetModel();
    lane_ = app::laneOf(pairs, lines == lines_ && !others ? lane_ : app::RaceLane{});
    lines_ = lines;
    needs_ = needs;
    limiting_ = limiting;
    pairs_ = std::move(pairs);
    if (others)
        endResetModel();
    else
        tellChanged();
    emit headerDataChanged(Qt::Horizontal, 0, columns() - 1);
}

void CompareModel::setDigits(int digits)
{
    if (std::exchange(digits_, digits) != digits)
        tellChanged();
}

void CompareModel::setLaneShown(bool shown)
{
    if (std::exchange(laneShown_, shown) != shown)
        emit headerDataChanged(Qt::Horizontal, Filled, Hollow);
}

void CompareModel::setInListsOrder(bool inOrder)
{
    if (std::exchange(inOrder_, inOrder) != inOrder)
        emit headerDataChanged(Qt::Horizontal, Name, Name);
}

bool CompareModel::timed() const { return lines_ >= app::leastLinesToTime; }

int CompareModel::rowOf(const app::Variant& variant) const
{
    const auto found = std::ranges::find(pairs_, variant.algorithm, &app::RacePair::algorithm);
    return found != pairs_.end() && found->of(variant.form) ? int(found - pairs_.begin()) : -1;
}

int CompareModel::rows() const { return int(pairs_.size()); }

int CompareModel::columns() const { return int(columnInfos.size()); }

QVariant CompareModel::cell(int row, int column, int role) const
{
    const ColumnInfo& info = columnInfos[std::size_t(column)];
    const Cell cell{pairs_[std::size_t(row)], lane_, timed(), needs_, digits_};
    switch (role) {
    case Qt::DisplayRole:
        return info.text(cell);
    case OrderRole:
        return info.order(cell);
    case Qt::ToolTipRole:
        return tipOf(cell.pair, column, lines_);
    case Qt::AccessibleTextRole:
        return info.spoken(cell);
    default:
        return {};
    }
}

QVariant CompareModel::heading(int column, int role) const
{
    const ColumnInfo& info = columnInfos[std::size_t(column)];
    const bool scaled = timed() && lane_.most > 0;
    switch (role) {
    case Qt::DisplayRole:
        return info.title({lane_, limiting_, inOrder_, scaled,
                           shows(Form::Corrected) && shows(Form::Published), laneShown_});
    case DenseTable::EndsRole:
        return column == Lane && scaled ? QStringList{QStringLiteral("0"), lane_.end()}
                                        : QVariant();
    case Qt::ToolTipRole:
        return Text::tr(info.meaning);
    case Qt::TextAlignmentRole:
        return int((column <= Lane ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    default:
        return {};
    }
}

} // namespace ui

#include "moc_compare_model.cpp"
