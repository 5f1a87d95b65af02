using System.Collections.Generic;
using System.CommandLine;

namespace Rabit.Tool.Commands;

internal static partial class ToolCommands
{
    private static partial IEnumerable<Command> OfRunningPrograms() => [];
}
