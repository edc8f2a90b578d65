// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/code_view.h"

#include "ui/look/focus_ring.h"
#include "ui/look/text.h"

#include <QAbstractTextDocumentLayout>
#include <QFontDatabase>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextOption>

namespace ui {

namespace {

constexpr int bar = 3, besideBar = 18, lineDistance = 4; // pixels
constexpr int hanging = 4; // letters by which the rest of a wrapped line is indented

QFont codeFont(const QFont& body)
{
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    const QFont caption = captionFont(body);
    if (caption.pixelSize() > 0)
        font.setPixelSize(caption.pixelSize());
    else
        font.setPointSizeF(caption.pointSizeF());
    return font;
}

void paintChevron(QPainter& painter, const QPointF& at, bool open)
{
    constexpr double half = 3, flat = 1.5;
    painter.setRenderHint(QPainter::Antialiasing);
    const QPolygonF folded{at + QPointF(-flat, -half), at + QPointF(flat, 0),
                           at + QPointF(-flat, half)};
    const QPolygonF unfolded{at + QPointF(-half, -flat), at + QPointF(0, flat),
                             at + QPointF(half, -flat)};
    painter.drawPolyline(open ? unfolded : folded);
}

} // namespace

/// The margin with the line numbers.
class CodeView::Numbers : public QWidget {
public:
    explicit Numbers(CodeView& code) : QWidget(&code), code_(code) {}

protected:
    void paintEvent(QPaintEvent*) override { code_.paintNumbers(); }

private:
    CodeView& code_;
};

CodeView::CodeView(QWidget* parent) : QTextEdit(parent), numbers_(new Numbers(*this))
{
    setReadOnly(true);
    setAcceptRichText(false);
    setFrameShape(QFrame::NoFrame);
    setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFont(codeFont(font()));
    setAccessibleName(Text::tr("Pseudo-code"));
    document()->setDocumentMargin(6);
    setFocusPolicy(Qt::TabFocus);
    viewport()->setAutoFillBackground(false);
    viewport()->setMouseTracking(true);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, numbers_,
            qOverload<>(&QWidget::update));
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, &CodeView::keepInSight);
}

void CodeView::show(const QStringList& code, const std::set<int>& run)
{
    if (code == code_ && run == run_)
        return;
    if (code != code_)
        unfolded_.clear();
    code_ = code;
    run_ = run;
    fold();
}

void CodeView::fold()
{
    auto rows = app::codeRows(code_, run_, unfolded_);
    if (rows == rows_)
        return;
    rows_ = std::move(rows);
    showRows();
}

/// A line without room is wrapped, and goes on further right than it begins.
QTextBlockFormat CodeView::blockOf(const QString& text) const
{
    const auto first = std::ranges::find_if(text, [](QChar c) { return c != u' '; });
    const double indent =
        double(first - text.begin() + hanging) * fontMetrics().horizontalAdvance(u' ');
    QTextBlockFormat format;
    format.setLeftMargin(indent);
    format.setTextIndent(-indent);
    return format;
}

void CodeView::showRows()
{
    clear();
    QTextCursor cursor(document());
    for (const app::CodeRow& row : rows_) {
        QTextCharFormat format;
        if (row.isFolded())
            format.setForeground(lookOf(palette()).muted);
        if (&row != &rows_.front())
            cursor.insertBlock();
        cursor.setBlockFormat(blockOf(row.text));
        cursor.insertText(row.text, format);
    }
    QTextBlockFormat apart;
    apart.setLineHeight(lineDistance, QTextBlockFormat::LineDistanceHeight);
    QTextCursor all(document());
    all.select(QTextCursor::Document);
    all.mergeBlockFormat(apart);
    moveCursor(QTextCursor::Start); // where it is shown first
    placeNumbers();
    keepInSight();
}

void CodeView::toggle(int row)
{
    const int line = rows_[std::size_t(row)].first;
    if (unfolded_.erase(line) == 0)
        unfolded_.insert(line);
    fold();
}

/// Unfolds all branches, or folds them again if none is folded.
void CodeView::toggleAll()
{
    const bool unfolds = std::ranges::any_of(rows_, &app::CodeRow::isFolded);
    unfolded_.clear();
    for (const app::CodeRow& row : app::codeRows(code_, run_))
        if (unfolds && row.isFolded())
            unfolded_.insert(row.first);
    fold();
}

int CodeView::rowAt(const QPoint& place) const
{
    for (int row = 0; row < int(rows_.size()); ++row)
        if (rows_[std::size_t(row)].folds && boxOf(row).contains(QPointF(1, place.y())))
            return row;
    return -1;
}

bool CodeView::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const int row = rowAt(static_cast<QHelpEvent*>(event)->pos());
        const bool folded = row >= 0 && rows_[std::size_t(row)].isFolded();
        viewport()->setToolTip(row < 0  ? QString()
                               : folded ? Text::tr("This branch was not taken. A click shows it, "
                                                   "Enter all of them.")
                                        : Text::tr("A click folds this branch, which was not "
                                                   "taken."));
    }
    return QTextEdit::viewportEvent(event);
}

void CodeView::mouseMoveEvent(QMouseEvent* event)
{
    QTextEdit::mouseMoveEvent(event);
    viewport()->setCursor(rowAt(event->pos()) >= 0 ? Qt::PointingHandCursor : Qt::IBeamCursor);
}

void CodeView::mouseReleaseEvent(QMouseEvent* event)
{
    QTextEdit::mouseReleaseEvent(event);
    const int row = rowAt(event->pos());
    if (event->button() != Qt::LeftButton || textCursor().hasSelection())
        return;
    if (row >= 0)
        return toggle(row);
    for (int other = 0; other < int(rows_.size()); ++other)
        if (boxOf(other).contains(QPointF(1, event->pos().y())))
            emit lineClicked(rows_[std::size_t(other)].first);
}

void CodeView::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        toggleAll();
    else
        QTextEdit::keyPressEvent(event);
}

void CodeView::light(int line)
{
    currentLine_ = line;
    setAccessibleDescription(line > 0 && line <= code_.size()
                                 ? Text::tr("Line %1: %2").arg(line).arg(code_[line - 1].trimmed())
                                 : QString());
    keepInSight();
    viewport()->update();
    numbers_->update();
}

void CodeView::keepInSight()
{
    const QRectF row = rowOf(currentLine_);
    QScrollBar* scroll = verticalScrollBar();
    if (row.isValid() && (row.top() < 0 || row.bottom() > viewport()->height()))
        scroll->setValue(scroll->value() + int(row.center().y()) - viewport()->height() / 2);
}

QRectF CodeView::rowOf(int line) const
{
    const auto row = std::ranges::find_if(
        rows_, [&](const app::CodeRow& r) { return r.first <= line && line <= r.last; });
    return row == rows_.end() ? QRectF() : boxOf(int(row - rows_.begin()));
}

QRectF CodeView::boxOf(int row) const
{
    const QTextBlock block = document()->findBlockByNumber(row);
    const QRectF text = document()->documentLayout()->blockBoundingRect(block);
    return {0, text.top() - verticalScrollBar()->value() - lineDistance / 2.0,
            double(viewport()->width()), text.height() + lineDistance};
}

int CodeView::numbersWidth() const
{
    // As wide as with any branch folded, so that the code does not move.
    const QString widest(std::max<qsizetype>(2, QString::number(code_.size()).size()), u'8');
    return bar + besideBar + fontMetrics().horizontalAdvance(widest + u'–' + widest) + 4;
}

void CodeView::placeNumbers()
{
    setViewportMargins(numbersWidth(), 0, 0, 0);
    const QRect inside = contentsRect();
    numbers_->setGeometry(inside.left(), inside.top(), numbersWidth(), inside.height());
}

void CodeView::paintNumbers()
{
    const Look& look = lookOf(palette());
    QPainter painter(numbers_);
    painter.setFont(font());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const QRectF row = boxOf(int(i));
        if (row.bottom() < 0 || row.top() > viewport()->height())
            continue;
        const auto& [first, last, text, folds] = rows_[i];
        const bool isCurrent = first <= currentLine_ && currentLine_ <= last;
        if (isCurrent) {
            painter.fillRect(QRectF(0, row.top(), numbers_->width(), row.height()), look.tint);
            painter.fillRect(QRectF(0, row.top(), bar, row.height()), look.selection);
        }
        painter.setPen(isCurrent ? look.text : look.muted);
        const double line = std::min<double>(row.height(), fontMetrics().height() + lineDistance);
        painter.drawText(
            QRectF(0, row.top(), numbers_->width() - 4, line), Qt::AlignRight | Qt::AlignVCenter,
            last > first ? QStringLiteral("%1–%2").arg(first).arg(last) : QString::number(first));
        if (folds)
            paintChevron(painter, {bar + besideBar / 2.0 - 2, row.top() + line / 2}, last == first);
    }
}

void CodeView::paintEvent(QPaintEvent* event)
{
    if (const QRectF row = rowOf(currentLine_); row.isValid())
        QPainter(viewport()).fillRect(row, lookOf(palette()).tint);
    QTextEdit::paintEvent(event);
    if (hasFocus())
        paintFocusRing(*viewport());
}

void CodeView::focusInEvent(QFocusEvent* event)
{
    QTextEdit::focusInEvent(event);
    viewport()->update();
}

void CodeView::focusOutEvent(QFocusEvent* event)
{
    QTextEdit::focusOutEvent(event);
    viewport()->update();
}

void CodeView::resizeEvent(QResizeEvent* event)
{
    QTextEdit::resizeEvent(event);
    placeNumbers();
}

void CodeView::showEvent(QShowEvent* event)
{
    QTextEdit::showEvent(event); // scrolls to its cursor
    keepInSight();
}

void CodeView::changeEvent(QEvent* event)
{
    QTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && numbers_)
        showRows(); // in the colours of another theme
    if (event->type() == QEvent::FontChange && numbers_)
        showRows(); // their indents follow the font, and so do the numbers
}

} // namespace ui

#include "moc_code_view.cpp"
