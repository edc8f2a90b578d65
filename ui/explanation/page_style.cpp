// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/explanation/page_style.h"

#include "ui/look/look.h"

#include <QFontDatabase>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>

#include <vector>

namespace ui {

namespace {

constexpr double lineHeight = 140; // per cent
constexpr int paragraphGap = 9, headingGap = 20, codeIndent = 10, hangingIndent = 28,
              cellPadding = 5, listIndent = 24;

bool isCode(const QTextBlock& block)
{
    return block.blockFormat().hasProperty(QTextFormat::BlockCodeFence)
           || block.blockFormat().hasProperty(QTextFormat::BlockCodeLanguage);
}

void styleBlock(const QTextBlock& block, const Look& look)
{
    QTextBlockFormat format = block.blockFormat();
    const bool inList = block.textList();
    if (isCode(block)) {
        format.setBackground(look.panel);
        format.setLeftMargin(codeIndent + hangingIndent); // a long line goes on further right
        format.setTextIndent(-hangingIndent);
        format.setRightMargin(codeIndent);
        format.setTopMargin(isCode(block.previous()) ? 0 : paragraphGap);
        format.setBottomMargin(isCode(block.next()) ? 0 : paragraphGap);
        format.setNonBreakableLines(false);
        // Higher lines would leave gaps in the background.
        format.setLineHeight(0, QTextBlockFormat::SingleHeight);
    } else {
        const int level = format.headingLevel();
        format.setTopMargin(level > 1 ? headingGap : inList ? 2 : 0);
        format.setBottomMargin(inList && block.next().textList() ? 2 : paragraphGap);
        format.setLineHeight(level > 0 ? 110 : lineHeight, QTextBlockFormat::ProportionalHeight);
        if (block.text().contains(QChar::ObjectReplacementCharacter)) // a figure
            format.setLineHeight(0, QTextBlockFormat::SingleHeight);
    }
    if (QTextCursor(block).currentTable()) {
        format.setTopMargin(0);
        format.setBottomMargin(0);
        format.setLineHeight(110, QTextBlockFormat::ProportionalHeight);
    }
    QTextCursor(block).setBlockFormat(format);
}

/// A range of text and its new format.
struct Stretch {
    int from, length;
    QTextCharFormat format;
};

/// Code gets the fixed font; links get the program's link style.
void addStretches(std::vector<Stretch>& all, const QTextBlock& block, const Look& look)
{
    static const QString fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont).family();
    for (auto part = block.begin(); !part.atEnd(); ++part) {
        const QTextFragment fragment = part.fragment();
        QTextCharFormat format;
        if (fragment.charFormat().fontFixedPitch())
            format.setFontFamilies({fixed});
        if (fragment.charFormat().isAnchor())
            format.setForeground(look.selection);
        if (!format.isEmpty())
            all.push_back({fragment.position(), fragment.length(), format});
    }
}

/// Applied after all ranges are known, because changes split and join the fragments.
void set(QTextDocument& document, const std::vector<Stretch>& all)
{
    QTextCursor cursor(&document);
    for (const Stretch& stretch : all) {
        cursor.setPosition(stretch.from);
        cursor.setPosition(stretch.from + stretch.length, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(stretch.format);
    }
}

void styleTable(QTextTable& table, const Look& look)
{
    QTextTableFormat format = table.format();
    format.setBorder(1);
    format.setBorderBrush(look.rule);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderCollapse(true);
    format.setCellPadding(cellPadding);
    format.setCellSpacing(0);
    format.setTopMargin(paragraphGap);
    format.setBottomMargin(paragraphGap);
    table.setFormat(format);
    for (int column = 0; column < table.columns(); ++column) {
        QTextTableCell cell = table.cellAt(0, column);
        QTextCharFormat head = cell.format();
        head.setBackground(look.panel);
        cell.setFormat(head);
    }
}

} // namespace

void styleMarkdown(QTextDocument& document, const Look& look)
{
    document.setUndoRedoEnabled(false);
    document.setIndentWidth(listIndent);
    QTextCursor all(&document);
    all.beginEditBlock(); // laid out once, at the end
    std::vector<Stretch> stretches;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        styleBlock(block, look);
        addStretches(stretches, block, look);
    }
    set(document, stretches);
    for (QTextFrame* frame : document.rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame))
            styleTable(*table, look);
    all.endEditBlock();
}

} // namespace ui
