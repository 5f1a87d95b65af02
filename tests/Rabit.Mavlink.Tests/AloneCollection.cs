using Xunit;

namespace Rabit.Mavlink.Tests;

/// <summary>
/// Tests that count what the whole process does, such as collections: they run when no other test does.
/// </summary>
[CollectionDefinition(Name, DisableParallelization = true)]
public sealed class AloneCollection
{
    public const string Name = "alone";
}
