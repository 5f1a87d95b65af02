using Rabit.Core.Diagnostics;
using Rabit.Core.Messages;
using Rabit.Core.Tests.Time;
using Rabit.Core.Time;

namespace Rabit.Core.Tests.Messages;

/// <summary>Names, clocks and logs for messages that no reactor has wired.</summary>
internal static class MessagePlaces
{
    public static MessagePlace New(string name)
    {
        var clock = new RunClock(new ManualClock());
        return new MessagePlace(name, clock, new RabitLog(null, logRuns: false, clock));
    }
}
