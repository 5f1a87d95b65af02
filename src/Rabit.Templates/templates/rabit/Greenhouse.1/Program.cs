using System;
using Greenhouse._1;
using Rabit.Core;
using Rabit.Diagnostics;

// With --virtual a minute of virtual time, which takes none; else real time, until Ctrl-C, SIGTERM or StopSystem.
RabitTime time = args is ["--virtual"] ? new VirtualTime(seed: 1) : new RealTime();
var reactor = new RabitReactor(time) { new Climate(), new Equipment(Console.WriteLine) };
using var diagnostics = RabitDiagnostics.Open(reactor);   // "rabit top" shows the managers while they run
if (time is RealTime)
    return (await reactor.RunAsync()).ExitCode;

reactor.Start();   // here the wiring is checked: all that is wrong with it is in one error
reactor.RunFor(TimeSpan.FromMinutes(1));
reactor.Stop();
return reactor.Finish().ExitCode;
