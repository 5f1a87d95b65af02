using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>docs/architecture.md shows the managers as they are wired.</summary>
public sealed class ArchitecturePageTests
{
    [Fact]
    public void Drawing_OfTheSixManagers_IsThatOfTheWiring()
        => GeneratedBlock.AssertUpToDate("docs/architecture.md", "wiring", ArchitectureDrawing.Render());
}
