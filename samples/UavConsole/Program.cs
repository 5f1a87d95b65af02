using System;
using UavConsole;

return CommandLine.Run(args, Console.Error, FlightRun.Run);
