// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look.h"

#include <QFocusEvent>
#include <QLabel>

#include <functional>

namespace ui {

/// A label with a style sheet, and links, in the colours of the look that the program has.
class LookLabel : public QLabel {
public:
    using QLabel::QLabel;
    using Sheet = std::function<QString(const Look& look)>;

    void setSheet(Sheet sheet)
    {
        sheet_ = std::move(sheet);
        follow();
    }
    void setColour(const std::function<QColor(const Look& look)>& colour)
    {
        setSheet([colour](const Look& look) { return "color: " + colour(look).name(); });
    }

protected:
    void changeEvent(QEvent* event) override
    {
        QLabel::changeEvent(event);
        if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
            follow();
        if (event->type() == QEvent::PaletteChange && Qt::mightBeRichText(text())) {
            const QString whole = text(); // links took their colour when it was set
            clear();
            setText(whole);
        }
    }

    /// Tab goes to a link at once, which shows the focus; the label itself shows none.
    void focusInEvent(QFocusEvent* event) override
    {
        QLabel::focusInEvent(event);
        const bool forth = event->reason() == Qt::TabFocusReason;
        if ((forth || event->reason() == Qt::BacktabFocusReason) && text().contains(u"<a "))
            focusNextPrevChild(forth);
    }

private:
    void follow()
    {
        const QString sheet = sheet_ ? sheet_(lookOf(QApplication::palette())) : QString();
        if (sheet != styleSheet()) // which changes the style
            setStyleSheet(sheet);
    }

    Sheet sheet_;
};

/// A text on one line, elided if it does not fit. The label's text requires no width of its own.
class ElidedLabel : public LookLabel {
public:
    ElidedLabel()
    {
        setTextFormat(Qt::PlainText);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    }

    void setWhole(const QString& text)
    {
        whole_ = text;
        setAccessibleName(text);
        elide();
    }
    const QString& whole() const { return whole_; }

protected:
    void changeEvent(QEvent* event) override
    {
        LookLabel::changeEvent(event);
        if (event->type() == QEvent::FontChange)
            elide();
    }
    void resizeEvent(QResizeEvent* event) override
    {
        QLabel::resizeEvent(event);
        elide();
    }

private:
    void elide()
    {
        setText(fontMetrics().elidedText(whole_, Qt::ElideRight, contentsRect().width()));
    }

    QString whole_;
};

/// A muted text beside a field.
inline QLabel* quietLabel(const QString& text)
{
    auto* label = new QLabel(text);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

} // namespace ui
