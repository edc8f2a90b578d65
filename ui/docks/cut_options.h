// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QWidget>

class QCheckBox;

namespace ui {

class LengthField;
class WindowPanel;

/// How clip windows cut, at the foot of the panel Clip window. The choices are remembered; Crop,
/// Cut out, Split, Export and the canvas follow them.
class CutOptionsBox : public QWidget {
    Q_OBJECT

public:
    /// A field's signals are passed on as the panel's.
    CutOptionsBox(app::Session& session, WindowPanel& panel);

private:
    QCheckBox* makeCheck(const QString& text, const QString& tip, bool app::CutChoices::*choice);
    void change(const app::CutChoices& choices);
    void follow();

    app::Session& session_;
    QCheckBox *close_, *hidden_;
    LengthField* least_;
};

/// The panel with the options at its foot.
QWidget* withCutOptions(WindowPanel& panel, app::Session& session);

} // namespace ui
