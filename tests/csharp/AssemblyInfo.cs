// SPDX-License-Identifier: MIT
[assembly: Xunit.CollectionBehavior(DisableTestParallelization = true)] // memory is measured
