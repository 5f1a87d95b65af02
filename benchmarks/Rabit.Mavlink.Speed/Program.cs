using System;
using System.IO;
using System.Reflection;
using Rabit.Mavlink.Speed;

// What Rabit.Mavlink does per second on one core, beside what bounds it: a copy of the bytes and the checksum alone, in the same run.
// Without arguments over the recorded flights and the golden frames; an argument names a .tlog. It runs on .NET and on Mono.
string data = Path.Combine(Path.GetDirectoryName(Assembly.GetExecutingAssembly().Location)!, "data");
string[] files = args.Length > 0
    ? args
    : [Path.Combine(data, "ardupilot-flight.tlog"), Path.Combine(data, "px4-flight.tlog"), Path.Combine(data, "golden.jsonl")];

Console.WriteLine($"{(Type.GetType("Mono.Runtime") is null ? ".NET" : "Mono")} {Environment.Version}, one core, best of {Measurement.Passes} passes in turn");
foreach (string file in files)
    new SpeedTable(FrameSet.Load(file)).Print(Console.Out);
