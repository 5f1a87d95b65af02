using System;
using Rabit.Core;
using Wheelchair;

// A ride towards a wall, in real time; "--virtual" takes the same ten seconds in no time, and prints the same each
// time.
bool isVirtual = args.Length == 1 && string.Equals(args[0], "--virtual", StringComparison.Ordinal);
if (args.Length > 0 && !isVirtual)
{
    Console.Error.WriteLine($"Wheelchair: '{string.Join(" ", args)}' is not [--virtual].");
    return 2;
}

// The managers do not know which time it is: that is the whole difference.
RabitTime time = isVirtual ? new VirtualTime(seed: 1) : new RealTime();
var ride = new Ride(time, Console.WriteLine);
return (await ride.Reactor.RunAsync()).ExitCode;   // until the driver gets off, or Ctrl-C
