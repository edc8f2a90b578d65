// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/recent_files.h"
#include "app/session/samples.h"

#include <QLabel>
#include <QListWidget>

namespace ui {

class Gallery;

/// Ways to begin: an empty sheet, a file, a sample, a recent file.
class StartPanel : public QWidget {
    Q_OBJECT

public:
    explicit StartPanel(QWidget* parent = nullptr);

    void showRecent(const std::vector<app::RecentFile>& files);
    void markSample(const QString& key);

signals:
    void drawWanted();
    void openWanted();
    void sampleWanted(const app::Sample& sample);
    void fileWanted(const QString& path);
    void paperWanted();
    void lessonWanted(); ///< asks for the first lesson

private:
    Gallery* gallery_;
    QLabel* noRecent_;
    QListWidget* recent_;
};

} // namespace ui
