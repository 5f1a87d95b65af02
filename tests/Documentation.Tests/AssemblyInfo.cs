using Xunit;

// Programs of the documents print to the console, which is one for all.
[assembly: CollectionBehavior(DisableTestParallelization = true)]
