// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QLabel>

namespace ui {

/// Says that a panel refers to the page; visible only while there is no clip window.
class PageCaption : public QLabel {
    Q_OBJECT

public:
    explicit PageCaption(const app::Session& session, QWidget* parent = nullptr);

private:
    void follow();

    const app::Session& session_;
};

} // namespace ui
