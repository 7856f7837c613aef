#!/bin/sh
# Prints the language references in docs/ anew from the tables of the interpreters. $1: build folder (build/dev).
set -e
cd "$(dirname "$0")/.."
POLYTURN_BLESS=1 "${1:-build/dev}/bin/test_channels" --gtest_filter='*LanguageReference*'
