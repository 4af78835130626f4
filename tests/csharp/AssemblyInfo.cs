[assembly: Xunit.CollectionBehavior(DisableTestParallelization = true)] // memory is measured
