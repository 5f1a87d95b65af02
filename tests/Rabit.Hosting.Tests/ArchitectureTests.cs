using System;
using System.Linq;
using Xunit;

namespace Rabit.Hosting.Tests;

/// <summary>Hosting uses Rabit.Core and Microsoft's extensions; Rabit.Core knows nothing of hosts.</summary>
public sealed class ArchitectureTests
{
    [Fact]
    public void Package_References_AreRabitCoreAndMicrosoftExtensions()
        => Assert.Equal(
            ["Rabit.Core"],
            typeof(RabitBuilder).Assembly.GetReferencedAssemblies().Select(a => a.Name!)
                .Where(n => !n.StartsWith("Microsoft.", StringComparison.Ordinal)
                    && !n.StartsWith("System", StringComparison.Ordinal)
                    && n is not "mscorlib" and not "netstandard"));

    [Fact]
    public void Core_References_AreNoExtensions()
        => Assert.DoesNotContain(
            typeof(Rabit.Core.RabitManager).Assembly.GetReferencedAssemblies(),
            a => a.Name!.StartsWith("Microsoft.Extensions", StringComparison.Ordinal));
}
