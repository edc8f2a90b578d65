// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/palette_list.h"

#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QPainter>
#include <QTextLayout>

#include <map>

namespace ui {
namespace {

constexpr int lineHeight = 28, headingHeight = 26;
constexpr int iconLeft = 16, nameLeft = 46, whatLeft = 300, noteLeft = 440, beside = 16;

void drawNote(QPainter& painter, const QRect& box, const QString& text, Qt::Alignment alignment)
{
    painter.drawText(box, alignment | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, box.width()));
}

/// The matched letters are bold, in the colour of selections.
void drawMatched(QPainter& painter, const QRect& box, const QString& name,
                 const QVariantList& letters, const QColor& lit)
{
    // As wide as if all letters were bold, so that no word is lost at the end.
    QFont bolder = painter.font();
    bolder.setBold(true);
    const QFontMetrics metrics = letters.isEmpty() ? painter.fontMetrics() : QFontMetrics(bolder);
    QTextLayout layout(metrics.elidedText(name, Qt::ElideRight, box.width()), painter.font());
    QTextOption option;
    option.setWrapMode(QTextOption::NoWrap);
    layout.setTextOption(option);
    QList<QTextLayout::FormatRange> formats;
    QTextCharFormat bold;
    bold.setFontWeight(QFont::Bold);
    bold.setForeground(lit);
    for (const QVariant& letter : letters)
        if (letter.toInt() < layout.text().size())
            formats.append({letter.toInt(), 1, bold});
    layout.setFormats(formats);
    layout.beginLayout();
    QTextLine line = layout.createLine();
    line.setLineWidth(box.width());
    layout.endLayout();
    layout.draw(&painter, QPointF(box.left(), box.center().y() - line.height() / 2 + 1));
}

QString spoken(const PaletteRow& row)
{
    QStringList parts{row.before, row.name, row.what, row.note};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(", "));
}

} // namespace

QString partName(PaletteRow::Part part)
{
    static const std::map<PaletteRow::Part, const char*> names{
        {PaletteRow::Part::Commands, QT_TRANSLATE_NOOP("Text", "Commands")},
        {PaletteRow::Part::Drawing, QT_TRANSLATE_NOOP("Text", "In this drawing")},
        {PaletteRow::Part::Help, QT_TRANSLATE_NOOP("Text", "Help")}};
    return Text::tr(names.at(part));
}

void PaletteModel::show(std::vector<PaletteRow> rows, const QString& typed)
{
    beginResetModel();
    found_ = std::move(rows);
    lines_.clear();
    for (std::size_t i = 0; i < found_.size(); ++i) {
        if (i == 0 && found_[i].isRecent)
            lines_.push_back({Text::tr("Recent")});
        else if (!found_[i].isRecent && (i == 0 || found_[i].part != found_[i - 1].part))
            lines_.push_back({partName(found_[i].part)});
        lines_.push_back({{}, i});
    }
    if (found_.empty())
        lines_.push_back({typed.trimmed().isEmpty()
                              ? Text::tr("There is nothing.")
                              : Text::tr("Nothing is called “%1”.").arg(typed)});
    endResetModel();
}

const PaletteRow* PaletteModel::row(int line) const
{
    if (line < 0 || line >= rows() || !lines_[std::size_t(line)].heading.isEmpty())
        return nullptr;
    return &found_[lines_[std::size_t(line)].row];
}

int PaletteModel::heightOf(int line) const { return isRow(line) ? lineHeight : headingHeight; }

int PaletteModel::bestLine() const
{
    int first = -1;
    for (int line = 0; line < rows(); ++line) {
        const PaletteRow* here = row(line);
        if (!here)
            continue;
        if (first < 0)
            first = line;
        if (here->enabled && here->match.score >= row(first)->match.score)
            return line;
    }
    return first;
}

QVariant PaletteModel::cell(int line, int, int role) const
{
    const PaletteRow* found = row(line);
    if (!found)
        return role == Qt::DisplayRole ? QVariant(lines_[std::size_t(line)].heading)
               : role == IsRowRole     ? QVariant(false)
                                       : QVariant();
    switch (role) {
    case Qt::DisplayRole:
        return found->name;
    case Qt::DecorationRole:
        return found->icon;
    case Qt::AccessibleTextRole:
        return spoken(*found);
    case Qt::ToolTipRole:
        return found->note;
    case IsRowRole:
        return true;
    case BeforeRole:
        return found->before;
    case WhatRole:
        return found->what;
    case NoteRole:
        return found->note;
    case EnabledRole:
        return found->enabled;
    case LettersRole: {
        QVariantList letters;
        for (const qsizetype letter : found->match.letters)
            letters << letter;
        return letters;
    }
    default:
        return {};
    }
}

void PalettePainter::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const
{
    const Look& look = lookOf(option.palette);
    const QRect& box = option.rect;
    const auto between = [&](int left, int right) {
        return QRect(box.left() + left, box.top(), right - left, box.height());
    };
    painter->save();
    painter->setFont(option.font);
    painter->setPen(look.muted);
    if (!index.data(PaletteModel::IsRowRole).toBool()) {
        painter->setFont(captionFont(option.font));
        drawNote(*painter, between(iconLeft, box.width() - beside), index.data().toString(),
                 Qt::AlignLeft);
        return painter->restore();
    }
    if (option.state & QStyle::State_Selected) {
        painter->fillRect(box, look.tint);
        painter->fillRect(QRect(box.left(), box.top(), 3, box.height()), look.selection);
    } else if (option.state & QStyle::State_MouseOver) {
        painter->fillRect(box, look.hover);
    }
    const bool enabled = index.data(PaletteModel::EnabledRole).toBool();
    QRect sign(0, 0, 16, 16);
    sign.moveCenter({box.left() + iconLeft + 8, box.center().y()});
    index.data(Qt::DecorationRole)
        .value<QIcon>()
        .paint(painter, sign, Qt::AlignCenter, enabled ? QIcon::Normal : QIcon::Disabled);
    const bool explained = !index.data(PaletteModel::NoteRole).toString().isEmpty();
    if (enabled || !explained)
        drawNote(*painter, between(whatLeft, noteLeft - 8),
                 index.data(PaletteModel::WhatRole).toString(), Qt::AlignLeft);
    painter->setPen(enabled ? look.text : look.muted);
    // A reason needs the room of both.
    drawNote(*painter, between(enabled || !explained ? noteLeft : whatLeft, box.width() - beside),
             index.data(PaletteModel::NoteRole).toString(), Qt::AlignRight);
    int left = nameLeft;
    if (QString before = index.data(PaletteModel::BeforeRole).toString(); !before.isEmpty()) {
        before += QStringLiteral(": ");
        painter->setPen(look.muted);
        drawNote(*painter, between(left, whatLeft - 8), before, Qt::AlignLeft);
        left += painter->fontMetrics().horizontalAdvance(before);
        painter->setPen(enabled ? look.text : look.muted);
    }
    drawMatched(*painter, between(left, whatLeft - 8), index.data().toString(),
                index.data(PaletteModel::LettersRole).toList(), look.selection);
    painter->restore();
}

QSize PalettePainter::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const
{
    return {200, index.data(PaletteModel::IsRowRole).toBool() ? lineHeight : headingHeight};
}

} // namespace ui

#include "moc_palette_list.cpp"
