#!/usr/bin/env bash
# What bash completes, these do as well.
# Needs zsh and fish.
other_shells="zsh fish"
source "$(dirname "$0")/shells_complete_commands.sh"
