// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/samples.h"

#include <QFutureWatcher>
#include <QImage>
#include <QWidget>

namespace ui {

class SampleButton;

/// The samples in two columns, clipped by the library at their clip windows. The pictures are
/// rendered in the background after the widget is first shown, and again when colours or sizes
/// change.
class Gallery : public QWidget {
    Q_OBJECT

public:
    explicit Gallery(QWidget* parent = nullptr);
    ~Gallery() override;

    /// Marks the sample that is open; an unknown key marks none.
    void mark(const QString& key);

signals:
    void chosen(const app::Sample& sample);

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void paintPictures();

    std::vector<app::Sample> samples_;
    std::vector<SampleButton*> buttons_;
    QFutureWatcher<QImage> watcher_; ///< renders the pictures in the current size and colours
    QSize painted_;                  ///< of the last pictures; empty: none yet
};

} // namespace ui
