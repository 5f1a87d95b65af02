using System.Collections.Generic;
using System.CommandLine;

namespace Rabit.Tool.Commands;

/// <summary>The list of the commands, in the order in which the help shows them: a class each.</summary>
internal static partial class ToolCommands
{
    public static IEnumerable<Command> Create() =>
    [
        .. OfRunningPrograms(),
        MavlinkLogCommand.Create(),
        GeolocateCommand.Create(),
        SimulateCommand.Create(),
        TrainCommand.Create(),
        CompletionCommand.Create(),
    ];

    /// <summary>Those that look into a running program, which Mono cannot.</summary>
    private static partial IEnumerable<Command> OfRunningPrograms();
}
