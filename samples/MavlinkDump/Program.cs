using System;
using System.CommandLine;
using System.Linq;
using MavlinkDump;

RootCommand command = CommandLine.Create(DumpRun.Run);
ParseResult parsed = command.Parse(args);
if (parsed.Errors.Count > 0)
{
    Console.Error.WriteLine(
        "MavlinkDump: " + string.Join(" ", parsed.Errors.Select(e => e.Message)) + " (--help shows the options)");
    return ExitCodes.BadInput;
}

return parsed.Invoke();
