using System;
using System.Runtime.CompilerServices;
using System.Threading;
using Rabit.Core.Managers;
using Xunit;

namespace Rabit.Core.Tests.Managers;

/// <content>Where the runtime says how much stack is left; Mono ends the process there.</content>
public sealed partial class RunningManagerTests
{
    [Fact]
    public void Is_WithLittleStackLeft_IsTrueForTheOneThatRuns()
    {
        (bool First, bool Second) found = default;
        var thread = new Thread(
            () => found = DownToTheLastStack(() =>
            {
                var scope = new RunningScope();
                scope.Enter(_first);
                (bool, bool) inside = (RunningManager.Is(_first), RunningManager.Is(_second));
                scope.Leave();
                return inside;
            }),
            512 * 1024);
        thread.Start();
        thread.Join();

        Assert.Equal((true, false), found);
    }

    // Goes down until the runtime would refuse a deep call, and looks there.
    private static (bool First, bool Second) DownToTheLastStack(Func<(bool, bool)> look)
    {
        Span<byte> filler = stackalloc byte[1024];
        filler.Fill(1);
        try
        {
            RuntimeHelpers.EnsureSufficientExecutionStack();
        }
        catch (InsufficientExecutionStackException)
        {
            return look();
        }

        (bool, bool) found = DownToTheLastStack(look);
        return filler[1023] == 1 ? found : default;
    }
}
