// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QImage>
#include <QTimer>
#include <QWidget>

namespace ui {

/// The picture above a lesson's text: a sample with its clip window, or a PNG file, painted on
/// another thread.
class PagePicture : public QWidget {
    Q_OBJECT

public:
    explicit PagePicture(QWidget* parent = nullptr);
    ~PagePicture() override;

    /// A sample's key or the path of a file; hides the picture if there is none.
    void show(const QString& picture);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void start();

    QString shown_, file_;
    QImage picture_;
    QTimer later_;
    QFutureWatcher<QImage> watcher_;
};

} // namespace ui
