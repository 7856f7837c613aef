// The HMI's tests need an application; without a display Qt paints into memory.
#include <gtest/gtest.h>

#include <QApplication>

#include "tests/seeds.hpp"

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    ::testing::InitGoogleTest(&argc, argv);
    QApplication app(argc, argv);
    return run_tests_with_seeds();
}
