// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/code_view.h"

#include "ui/look/focus_ring.h"
#include "ui/look/text.h"

#include <QAbstractTextDocumentLayout>
#include <QFontDatabase>
#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>

namespace ui {

namespace {

constexpr int bar = 3, besideBar = 12, lineDistance = 4; // pixels

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
    setLineWrapMode(NoWrap);
    setFont(codeFont(font()));
    setAccessibleName(Text::tr("Pseudo-code"));
    document()->setDocumentMargin(6);
    setFocusPolicy(Qt::TabFocus);
    viewport()->setAutoFillBackground(false);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, numbers_,
            qOverload<>(&QWidget::update));
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, &CodeView::keepInSight);
}

void CodeView::show(const QStringList& code)
{
    if (code == code_)
        return;
    code_ = code;
    setPlainText(code.join(u'\n'));
    QTextBlockFormat apart;
    apart.setLineHeight(lineDistance, QTextBlockFormat::LineDistanceHeight);
    QTextCursor all(document());
    all.select(QTextCursor::Document);
    all.mergeBlockFormat(apart);
    placeNumbers();
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
    const QTextBlock block = document()->findBlockByNumber(line - 1);
    if (line < 1 || !block.isValid())
        return {};
    const QRectF text = document()->documentLayout()->blockBoundingRect(block);
    return {0, text.top() - verticalScrollBar()->value() - lineDistance / 2.0,
            double(viewport()->width()), text.height() + lineDistance};
}

int CodeView::numbersWidth() const
{
    const QString widest(std::max<qsizetype>(2, QString::number(code_.size()).size()), u'8');
    return bar + besideBar + fontMetrics().horizontalAdvance(widest) + 4;
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
    for (int line = 1; line <= code_.size(); ++line) {
        const QRectF row = rowOf(line);
        if (row.bottom() < 0 || row.top() > viewport()->height())
            continue;
        const bool isCurrent = line == currentLine_;
        if (isCurrent) {
            painter.fillRect(QRectF(0, row.top(), numbers_->width(), row.height()), look.tint);
            painter.fillRect(QRectF(0, row.top(), bar, row.height()), look.selection);
        }
        painter.setPen(isCurrent ? look.text : look.muted);
        painter.drawText(QRectF(0, row.top(), numbers_->width() - 4, row.height()),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(line));
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
    if (event->type() == QEvent::FontChange && numbers_)
        placeNumbers();
}

} // namespace ui

#include "moc_code_view.cpp"
