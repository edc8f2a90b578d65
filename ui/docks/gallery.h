// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/samples.h"

#include <QImage>
#include <QListWidget>

#include <atomic>
#include <memory>

namespace ui {

/// The samples with their windows, clipped by the library. The pictures are made on a thread of
/// their own after the widget is first seen, and again when the colours change.
class Gallery : public QListWidget {
    Q_OBJECT

public:
    explicit Gallery(QWidget* parent = nullptr);
    ~Gallery() override;

    /// Marks the sample that is open; an unknown key marks none.
    void mark(const QString& key);
    int heightForWidth(int width) const override;

signals:
    void chosen(const app::Sample& sample);

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void paintPictures();
    void layOut();

    std::vector<app::Sample> samples_;
    std::shared_ptr<std::atomic<int>> generation_; ///< pictures of an older one are dropped
    bool painted_ = false;
};

} // namespace ui
