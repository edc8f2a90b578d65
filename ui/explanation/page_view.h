// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QTextBrowser>
#include <QTimer>

#include <optional>

namespace ui {

/// The page of an algorithm: lines of a comfortable length, figures painted by the program itself,
/// in the palette's colours. Links to other pages are followed, all others are told. It goes back
/// and forward like a browser.
class PageView : public QTextBrowser {
    Q_OBJECT

public:
    explicit PageView(QWidget* parent = nullptr);

    void show(const clipping::Algorithm& algorithm);
    const clipping::Algorithm* algorithm() const; ///< null before the first

    /// Chooses the next place with that text, from the beginning after the last one; marks all.
    /// How many there are.
    int find(const QString& text, QTextDocument::FindFlags direction);
    void forgetFound();

    void setZoom(int steps); ///< 0: the program's text size
    int zoom() const { return zoom_; }

    /// As it is on paper: light, whatever the palette is. An error, or nothing.
    std::optional<QString> saveAsPdf(const QString& file) const;

signals:
    void linkChosen(const QUrl& link); ///< to something that is no page
    void pageChanged();

protected:
    void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override;
    QVariant loadResource(int type, const QUrl& url) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void follow(const QUrl& link);
    void style();
    void fitLines();
    int columnWidth() const;
    void setAnew();

    int zoom_ = 0;
    QTimer soon_;
};

} // namespace ui
