using Xunit;

namespace Rabit.Core.Tests;

/// <summary>
/// Tests that count what the whole process does, such as its memory: they run when no other test does.
/// </summary>
[CollectionDefinition(Name, DisableParallelization = true)]
public sealed class AloneCollection
{
    public const string Name = "alone";
}
