// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/look_label.h"

namespace ui {

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

} // namespace ui
