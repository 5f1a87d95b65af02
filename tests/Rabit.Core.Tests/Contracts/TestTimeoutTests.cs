using System;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>What the tests wait by ends, whatever happens meanwhile: a test that hangs names nothing.</summary>
public sealed class TestTimeoutTests
{
    private static readonly TimeSpan Short = TimeSpan.FromMilliseconds(200);

    [Fact]
    public void TryWait_WithoutPulses_IsOver()
    {
        object gate = new();
        var timeout = new TestTimeout(Short);

        lock (gate)
        {
            while (timeout.TryWait(gate))
            {
            }
        }

        Assert.False(timeout.TryWait());
    }

    /// <summary>A test on a machine whose load rose just then waited, was over, and waited on.</summary>
    [Fact]
    public void TryWait_LoadRisesAfterTheEnd_StaysOver()
    {
        double shares = 1;
        var timeout = new TestTimeout(TimeSpan.FromMilliseconds(40), () => shares);
        while (timeout.TryWait())
        {
        }

        shares = 50;

        Assert.False(timeout.TryWait());
    }

    /// <summary>
    /// A manager that was restarted for ever changed what a test had awaited before the test looked, and the test
    /// waited for it for hours.
    /// </summary>
    [Fact]
    public void TryWait_PulsedAllTheTime_IsOverAllTheSame()
    {
        object gate = new();
        bool isOver = false;   // under the gate
        int pulses = 0;        // under the gate
        var pulser = new Thread(() =>
        {
            while (true)
            {
                lock (gate)
                {
                    // More than it waits for even on the busiest machine: the test must not hang itself.
                    if (isOver || ++pulses > 10_000_000)
                        return;
                    Monitor.PulseAll(gate);
                }

                Thread.Yield();
            }
        })
        {
            IsBackground = true,
        };
        var timeout = new TestTimeout(Short);
        bool wasPulsed;

        lock (gate)
        {
            pulser.Start();
            while (timeout.TryWait(gate))
            {
            }

            isOver = true;
            wasPulsed = pulses > 0;
        }

        Assert.True(pulser.Join(TestTimeout.Limit));
        Assert.True(wasPulsed);
        Assert.InRange(pulses, 1, 10_000_000);
    }
}
