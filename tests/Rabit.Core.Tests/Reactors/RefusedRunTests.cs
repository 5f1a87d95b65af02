using System;
using System.Threading.Tasks;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>A call that a reactor refuses says why, and leaves the run that is under way alone.</summary>
public sealed class RefusedRunTests
{
    private readonly TestBoard _board = new();

    [Fact]
    public async Task Dispose_AfterARefusedRun_StopsAllManagers()
    {
        foreach (TimeKind kind in new[] { TimeKind.Real, TimeKind.Virtual })
        {
            var manager = new ScriptedManager("m", _board);
            using (RabitReactor reactor = NewReactor(kind.Create(), manager))
            {
                reactor.Start();
                Assert.Throws<InvalidOperationException>(reactor.Run);
                await Assert.ThrowsAsync<InvalidOperationException>(() => reactor.RunAsync());
            }

            Assert.Equal(1, manager.Shutdowns);
        }
    }

    [Fact]
    public void Dispose_AfterARunInAStartup_StopsAllManagers()
    {
        foreach (TimeKind kind in new[] { TimeKind.Real, TimeKind.Virtual })
        {
            var manager = new ScriptedManager("m", _board);
            using (RabitReactor reactor = NewReactor(kind.Create(), manager))
            {
                manager.OnStartup = () => Assert.Throws<InvalidOperationException>(reactor.Run);
                reactor.Start();
            }

            Assert.Equal(1, manager.Shutdowns);
        }
    }

    private static RabitReactor NewReactor(RabitTime time, RabitManager manager)
        => new(new ReactorOptions { Time = time, StopsOnSignals = false }) { manager };
}
