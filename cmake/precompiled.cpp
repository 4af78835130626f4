// SPDX-License-Identifier: MIT
// The source of a target that only holds a precompiled header.
int main() {}
