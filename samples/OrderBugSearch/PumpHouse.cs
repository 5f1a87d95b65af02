using System;
using Rabit.Core;

namespace OrderBugSearch;

/// <summary>
/// A panel with a button and a valve that the button is to open: a system so small that a bug seems impossible.
/// </summary>
internal static class PumpHouse
{
    /// <summary>
    /// Runs it for a third of a second and checks what it was built for. All that a search over seeds needs.
    /// </summary>
    /// <exception cref="PumpHouseException">The valve is closed.</exception>
    public static void Run(VirtualTime time, bool isFixed)
    {
        var valve = new Valve(isFixed);
        var reactor = new RabitReactor(time) { new Panel(), valve };
        reactor.Start();
        reactor.RunFor(TimeSpan.FromMilliseconds(330));
        reactor.Stop("the test is over");
        ReactorResult result = reactor.Finish();
        if (result.ExitCode != 0)
            throw new PumpHouseException(result.ToString());
        if (!valve.IsOpen)
            throw new PumpHouseException("the button was pressed three times and the valve is closed");
    }
}
