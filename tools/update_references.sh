#!/bin/sh
# Prints the language references in docs/ anew from the tables of the interpreters. $1: build folder (build/dev).
set -e
cd "$(dirname "$0")/.."
tests="${1:-build/dev}/bin/test_channels"
POLYTURN_BLESS=1 "$tests" --gtest_filter='*LanguageReference*' >/dev/null 2>&1 || true   # a run that writes is never a good one
"$tests" --gtest_filter='*LanguageReference*'
