// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/document.h"

#include "app/charts/chart_file.h"
#include "app/charts/chart_paint.h"
#include "app/experiment/heading.h"
#include "app/report/keep_together.h"

#include <QAbstractTextDocumentLayout>
#include <QFontDatabase>
#include <QPainter>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>

namespace app {
namespace {

constexpr int chartObject = QTextFormat::UserObject + 1;
constexpr int chartProperty = QTextFormat::UserProperty + 1;
constexpr double textPoints = 9.5, notePoints = 7.5, cellPoints = 7;

/// Paints a chart at each placeholder character in a document.
class ChartPainter : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    ChartPainter(std::vector<Chart> charts, int dotsPerInch, QObject* parent)
        : QObject(parent), charts_(std::move(charts)), scale_(dotsPerInch / pixelsPerInch)
    {
    }
    QSizeF intrinsicSize(QTextDocument*, int, const QTextFormat& format) override
    {
        return usualSize(chartOf(format), documentLook()) * scale_;
    }
    void drawObject(QPainter* painter, const QRectF& area, QTextDocument*, int,
                    const QTextFormat& format) override
    {
        if (painter->clipBoundingRect().intersected(area).height() < 1)
            return; // the chart begins on the next page
        painter->save();
        painter->translate(area.topLeft());
        painter->scale(scale_, scale_);
        const Chart& chart = chartOf(format);
        paint(*painter, QRectF({}, usualSize(chart, documentLook())), chart, documentLook());
        painter->restore();
    }

private:
    /// 720 pixels on 180 mm: a little smaller than on a screen.
    static constexpr double pixelsPerInch = 104;

    const Chart& chartOf(const QTextFormat& format) const
    {
        return charts_[std::size_t(format.intProperty(chartProperty))];
    }

    std::vector<Chart> charts_;
    double scale_;
};

QTextCharFormat textFormat(double points, QFont::Weight weight, const QColor& colour)
{
    QTextCharFormat format;
    format.setFontPointSize(points);
    format.setFontWeight(weight);
    format.setForeground(colour);
    return format;
}

QTextCharFormat plain() { return textFormat(textPoints, QFont::Normal, documentLook().text); }
QTextCharFormat small() { return textFormat(notePoints, QFont::Normal, documentLook().muted); }

/// Appends one part after another.
class Writer {
public:
    explicit Writer(QTextDocument& document) : at_(&document)
    {
        at_.beginEditBlock(); // otherwise each word would trigger a new layout
    }
    ~Writer() { at_.endEditBlock(); }
    Q_DISABLE_COPY_MOVE(Writer)

    void paragraph(const QString& text, const QTextCharFormat& format, double above, double below)
    {
        insert({}, text, format, above, below);
    }
    void heading(const QString& text, double points, double above, double below = 4)
    {
        QTextBlockFormat block;
        setBelongsToNext(block);
        insert(block, text, textFormat(points, QFont::DemiBold, documentLook().text), above, below);
    }
    void sentences(const QStringList& all)
    {
        for (const QString& sentence : all)
            paragraph(sentence, plain(), 0, 4);
    }
    void code(const QString& text)
    {
        QTextCharFormat format = plain();
        format.setFontFamilies(QFontDatabase::systemFont(QFontDatabase::FixedFont).families());
        format.setFontPointSize(notePoints);
        paragraph(text, format, 4, 4);
    }
    void chart(int number)
    {
        QTextCharFormat format;
        format.setObjectType(chartObject);
        format.setProperty(chartProperty, number);
        QTextBlockFormat block;
        block.setTopMargin(8 * point);
        begin(block, format);
        at_.insertText(QString(QChar::ObjectReplacementCharacter), format);
    }
    void table(const Table& table);

private:
    void insert(QTextBlockFormat block, const QString& text, const QTextCharFormat& format,
                double above, double below)
    {
        block.setTopMargin(above * point);
        block.setBottomMargin(below * point);
        begin(block, format);
        at_.insertText(text, format);
    }
    void begin(const QTextBlockFormat& block, const QTextCharFormat& format)
    {
        if (!std::exchange(empty_, false))
            at_.insertBlock();
        at_.setBlockFormat(block);
        at_.setBlockCharFormat(format);
    }
    QTextTableFormat tableFormat() const;
    void cell(QTextTableCell cell, const QString& text, Qt::Alignment side,
              const QTextCharFormat& format);

    static constexpr double point = 96.0 / 72; ///< distances are pixels; the layout scales them

    QTextCursor at_;
    bool empty_ = true; ///< whether the block at the cursor is unused
};

QTextTableFormat Writer::tableFormat() const
{
    QTextTableFormat format;
    format.setBorder(0);
    format.setCellSpacing(0);
    format.setHeaderRowCount(1);
    format.setTopMargin(2 * point);
    format.setBottomMargin(4 * point);
    return format;
}

void Writer::cell(QTextTableCell cell, const QString& text, Qt::Alignment side,
                  const QTextCharFormat& format)
{
    QTextTableCellFormat rule;
    rule.setBottomBorder(0.4 * point);
    rule.setBottomBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    rule.setBottomBorderBrush(documentLook().rule);
    rule.setTopPadding(1.5 * point);
    rule.setBottomPadding(1.5 * point);
    rule.setRightPadding(6 * point);
    cell.setFormat(rule);
    QTextCursor inside = cell.firstCursorPosition();
    QTextBlockFormat block;
    block.setAlignment(side);
    inside.setBlockFormat(block);
    inside.insertText(text, format);
}

void Writer::table(const Table& table)
{
    if (!table.title.isEmpty())
        heading(table.title, textPoints, 8, 0);
    const auto numeric = numericColumns(table);
    const auto side = [&](qsizetype column) {
        return numeric[std::size_t(column)] ? Qt::AlignRight : Qt::AlignLeft;
    };
    const auto head = textFormat(cellPoints, QFont::Normal, documentLook().muted);
    const auto body = textFormat(cellPoints, QFont::Normal, documentLook().text);
    QTextTable* grid =
        at_.insertTable(int(table.rows.size()) + 1, int(table.names.size()), tableFormat());
    for (qsizetype c = 0; c < table.names.size(); ++c) {
        QString heading = headingOf(table.names[c]).text;
        heading.replace(u'\n', QChar::LineSeparator);
        cell(grid->cellAt(0, int(c)), heading, side(c), head);
        for (std::size_t r = 0; r < table.rows.size(); ++r)
            cell(grid->cellAt(int(r) + 1, int(c)),
                 readable(table.rows[r][c], numeric[std::size_t(c)]), side(c), body);
    }
    at_.movePosition(QTextCursor::End);
    empty_ = true; // Qt adds a block below a table
    for (const QString& note : table.notes)
        paragraph(note, small(), 0, 1);
    QStringList facts;
    for (const auto& [name, value] : table.facts)
        facts << name + QStringLiteral(": ") + value;
    if (!facts.isEmpty())
        paragraph(facts.join(QStringLiteral("; ")) + u'.', small(), 0, 1);
}

std::vector<Chart> chartsOf(const Report& report)
{
    std::vector<Chart> charts;
    for (const ReportSection& section : report.sections)
        charts.insert(charts.end(), section.charts.begin(), section.charts.end());
    return charts;
}

} // namespace

ChartLook documentLook()
{
    ChartLook look = chartLook(Ground::Light);
    look.paper = Qt::white;
    return look;
}

std::unique_ptr<QTextDocument> documentOf(const Report& report, int dotsPerInch)
{
    auto document = std::make_unique<QTextDocument>();
    QFont font = documentLook().font;
    font.setPointSizeF(textPoints);
    document->setDefaultFont(font);
    document->setDocumentMargin(0);
    document->documentLayout()->registerHandler(
        chartObject, new ChartPainter(chartsOf(report), dotsPerInch, document.get()));
    Writer writer(*document);
    writer.heading(report.title, 18, 0);
    writer.sentences(report.summary);
    int chart = 0;
    for (const ReportSection& section : report.sections) {
        writer.heading(section.title, 13, 16);
        writer.sentences(section.sentences);
        if (!section.code.isEmpty())
            writer.code(section.code);
        for (std::size_t i = 0; i < section.charts.size(); ++i)
            writer.chart(chart++);
        for (const Table& table : section.tables)
            writer.table(table);
    }
    return document;
}

} // namespace app
#include "document.moc"
