using Microsoft.Extensions.Logging;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>What the hosting itself has to say; the ids are those of <see cref="RabitEventIds"/>.</summary>
internal static partial class HostLog
{
    [LoggerMessage(EventId = 10, Message = "Reactor {Reactor} has ended, the host stops: {Result}")]
    public static partial void ReactorEnded(ILogger logger, LogLevel level, string reactor, ReactorResult? result);

    [LoggerMessage(11, LogLevel.Error, "Reactor {Reactor} did not stop in {Limit}: {Manager}")]
    public static partial void NotStopped(ILogger logger, string reactor, string limit, string manager);
}
