using System;
using System.Linq;
using Xunit;

namespace Rabit.Uav.Web.Tests;

/// <summary>The live page uses Rabit.Uav and ASP.NET Core; Rabit.Uav knows nothing of it.</summary>
public sealed class ArchitectureTests
{
    [Fact]
    public void Package_References_AreRabitUavWhatItUsesAndAspNetCore()
        => Assert.Empty(
            typeof(LivePage).Assembly.GetReferencedAssemblies().Select(a => a.Name!)
                .Where(n => !n.StartsWith("Microsoft.", StringComparison.Ordinal)
                    && !n.StartsWith("System", StringComparison.Ordinal))
                .Except(["Rabit.Core", "Rabit.Geodesy", "Rabit.Mavlink", "Rabit.Vision", "Rabit.Uav"]));

    [Fact]
    public void RabitUav_References_AreNoServer()
        => Assert.DoesNotContain(
            typeof(UavSystem).Assembly.GetReferencedAssemblies(),
            a => a.Name!.StartsWith("Microsoft.AspNetCore", StringComparison.Ordinal));
}
