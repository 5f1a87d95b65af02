using System.CommandLine;
using System.Linq;
using UavConsole;

ParseResult parsed = CommandLine.Create(FlightRun.Run).Parse(args);
return parsed.Errors.Count > 0
    ? CommandLine.Refuse([.. parsed.Errors.Select(e => e.Message), "(--help shows the options)"])
    : parsed.Invoke();
