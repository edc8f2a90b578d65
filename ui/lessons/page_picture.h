// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QImage>
#include <QTimer>
#include <QWidget>

namespace ui {

/// The picture above a lesson's text: a sample with its clip window, painted on another thread.
class PagePicture : public QWidget {
    Q_OBJECT

public:
    explicit PagePicture(QWidget* parent = nullptr);
    ~PagePicture() override;

    void show(const QString& sample); ///< its key; hides the picture if there is none

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void start();

    QString sample_, file_;
    QImage picture_;
    QTimer later_;
    QFutureWatcher<QImage> watcher_;
};

} // namespace ui
