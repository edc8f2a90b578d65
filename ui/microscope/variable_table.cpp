// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/variable_table.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/tabular.h"

#include <QFontDatabase>
#include <QPainter>

namespace ui {

namespace {

constexpr int gap = DenseTable::gap;

/// Paints rows as high as the font needs, tinted if the step changed them.
class VariableCells : public QStyledItemDelegate {
public:
    explicit VariableCells(const DenseTable& table, QObject* parent)
        : QStyledItemDelegate(parent), table_(table)
    {
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        const bool changed = index.data(VariableModel::ChangedRole).toBool();
        table_.paintGround(*painter, option, index);
        if (changed)
            painter->fillRect(option.rect, look.tint);
        painter->setFont(fontOf(option.font, index.column(), changed));
        painter->setPen(index.column() == VariableModel::Change   ? look.selection
                        : index.column() == VariableModel::Before ? look.muted
                                                                  : look.text);
        const int left = index.column() == VariableModel::Name ? space::dockMargin : gap;
        const QRect place = option.rect.adjusted(left, 0, -gap, 0);
        const QFontMetrics metrics(painter->font());
        QString text = index.data().toString();
        if (tabularWidth(metrics, text) > place.width())
            text = index.data(VariableModel::ShortRole).toString();
        drawTabular(*painter, place, Qt::Alignment(index.data(Qt::TextAlignmentRole).toInt()),
                    metrics.elidedText(text, Qt::ElideRight, place.width()));
    }

private:
    static QFont fontOf(const QFont& body, int column, bool changed)
    {
        if (column == VariableModel::Name) {
            QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
            body.pixelSize() > 0 ? fixed.setPixelSize(body.pixelSize())
                                 : fixed.setPointSizeF(body.pointSizeF());
            return fixed;
        }
        const bool strong = column == VariableModel::Value || column == VariableModel::Change;
        return changed && strong ? semiBold(body) : body;
    }

    const DenseTable& table_;
};

} // namespace

VariableTable::VariableTable(QWidget* parent) : DenseTable(parent)
{
    setModel(&model_);
    setItemDelegate(new VariableCells(*this, this));
    setSelectionMode(NoSelection);
    setFocusPolicy(Qt::TabFocus);
    setAccessibleName(Text::tr("Variables"));
    horizontalHeader()->setSortIndicatorShown(false);
    horizontalHeader()->setSectionsClickable(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    verticalHeader()->setDefaultSectionSize(
        std::max(space::denseRowHeight, fontMetrics().height() + 6));
    setMinimumHeight(space::dockTitleHeight + 3 * verticalHeader()->defaultSectionSize());
}

void VariableTable::show(std::vector<app::Variable> variables)
{
    model_.show(std::move(variables));
    showChanged();
}

void VariableTable::showChanged()
{
    if (const int row = model_.firstChanged(); row >= 0)
        scrollTo(model_.index(row, 0));
}

void VariableTable::resizeEvent(QResizeEvent* event)
{
    DenseTable::resizeEvent(event);
    fitColumns();
    showChanged();
}

/// The column with the word for changes keeps its width and the others share the rest, so that
/// nothing moves from step to step.
void VariableTable::fitColumns()
{
    const int all = viewport()->width();
    const QFontMetrics metrics(font()), bold(semiBold(font()));
    const int word =
        bold.horizontalAdvance(QStringLiteral("\u25cf ") + Text::tr("changed")) + 2 * gap + 4;
    const int rest = std::max(0, all - word);
    const QString usual = QStringLiteral("\u2212123.456");
    const int name = std::min(rest * 3 / 10, 8 * metrics.horizontalAdvance(u'm') + 2 * gap);
    const int least = std::min(bold.horizontalAdvance(usual) + 2 * gap + 2, rest - name);
    const int before = std::min(metrics.horizontalAdvance(usual) + 2 * gap, rest - name - least);
    setColumnWidth(VariableModel::Name, name);
    setColumnWidth(VariableModel::Value, rest - name - before);
    setColumnWidth(VariableModel::Before, before);
    setColumnWidth(VariableModel::Change, all - rest);
}

} // namespace ui

#include "moc_variable_table.cpp"
