using System.Collections.Generic;
using System.CommandLine;
using Rabit.Tool.Running;
using Rabit.Tool.Running.Top;

namespace Rabit.Tool.Commands;

internal static partial class ToolCommands
{
    private static partial IEnumerable<Command> OfRunningPrograms() =>
    [
        TopCommand.Create(),
        GraphCommand.Create(),
        EchoCommand.Create(),
    ];
}
