using System;
using System.CommandLine;
using System.Linq;
using SimulatedVehicle;

const int BadInput = 2;

RootCommand command = CommandLine.Create(VehicleRun.Run);
ParseResult parsed = command.Parse(args);
if (parsed.Errors.Count > 0)
{
    Console.Error.WriteLine(
        "SimulatedVehicle: " + string.Join(" ", parsed.Errors.Select(e => e.Message)) + " (--help shows the options)");
    return BadInput;
}

return parsed.Invoke();
