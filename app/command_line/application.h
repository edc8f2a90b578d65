// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <memory>

namespace app {

/// The application object of a command: a QGuiApplication for a command that paints, which uses a
/// display if there is one and works without, or that reads drawings with texts, which never uses
/// one; and a QCoreApplication for all others.
std::unique_ptr<QCoreApplication> applicationFor(const QStringList& arguments, int& argc,
                                                 char** argv);

} // namespace app
