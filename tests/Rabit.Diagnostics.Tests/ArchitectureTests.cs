using System;
using System.Linq;
using Xunit;

namespace Rabit.Diagnostics.Tests;

/// <summary>Diagnostics use Rabit.Core and nothing else of Rabit.</summary>
public sealed class ArchitectureTests
{
    [Fact]
    public void Package_References_AreRabitCore()
        => Assert.Equal(
            ["Rabit.Core"],
            typeof(RabitDiagnostics).Assembly.GetReferencedAssemblies().Select(a => a.Name!)
                .Where(n => !n.StartsWith("System", StringComparison.Ordinal)));
}
