// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QTextBrowser>
#include <QTimer>

#include <optional>

namespace ui {

class DrawnPictures;

/// A page of an algorithm or of the manual: lines of a comfortable length, figures painted by the
/// program in the palette's colours. It follows links to other pages and signals all other links.
/// It goes back and forward like a browser.
class PageView : public QTextBrowser {
    Q_OBJECT

public:
    explicit PageView(QWidget* parent = nullptr);

    void show(const clipping::Algorithm& algorithm);
    void showManual(const QString& topic);        ///< which must exist
    void open(const QString& link);               ///< "snapping.md"
    const clipping::Algorithm* algorithm() const; ///< null on a page of the manual, or on none
    QString topic() const;                        ///< of the manual; empty on other pages
    QString title() const;

    /// Selects the next match of `text`, wrapping around at the end, and highlights all matches.
    /// Returns their number.
    int find(const QString& text, QTextDocument::FindFlags direction);
    void forgetFound();

    void setZoom(int steps); ///< 0 is the program's text size
    int zoom() const { return zoom_; }

    /// Saves the page in light colours, whatever the palette. Returns an error message, or nothing.
    std::optional<QString> saveAsPdf(const QString& file) const;

signals:
    void linkChosen(const QUrl& link); ///< any link that does not lead to a page
    void pageChanged();

protected:
    void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override;
    QVariant loadResource(int type, const QUrl& url) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void follow(const QUrl& link);
    void style();
    void fitLines();
    int columnWidth() const;
    void setAnew();

    int zoom_ = 0;
    DrawnPictures* drawn_;
    QTimer soon_;
};

} // namespace ui
