// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace ui {

/// A red border around a field whose value was refused, until it takes one or the next key is
/// pressed in it. Belongs to the field.
class RefusalFrame : public QWidget {
    Q_OBJECT

public:
    explicit RefusalFrame(QWidget& field);

signals:
    void typed(); ///< a key was pressed while the border was shown

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QWidget& field_;
};

} // namespace ui
