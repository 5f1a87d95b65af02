using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using Rabit.Mavlink.Speed;

// The speed of Rabit.Mavlink on one core, beside what bounds it: a copy of the bytes and the checksum alone, in the
//   same run. no arguments the recorded flights and the golden frames, about 3 minutes FLIGHT.tlog ... those logs
//   instead --baseline EXE beside the C baseline (c/baseline.c, compiled), in turn with it --quick one flight in some
//   20 s; exit code 1 where a row is slower than its generous limit, or allocates
string data = Path.Combine(Path.GetDirectoryName(Assembly.GetExecutingAssembly().Location)!, "data");
var files = new List<string>();
bool isQuick = false;
string? baseline = null;
for (int index = 0; index < args.Length; index++)
{
    if (args[index] == "--quick")
        isQuick = true;
    else if (args[index] == "--baseline" && index + 1 < args.Length)
        baseline = args[++index];
    else
        files.Add(args[index]);
}

if (files.Count == 0)
    files.Add(Path.Combine(data, "ardupilot-flight.tlog"));
if (files.Count == 1 && !isQuick && args.Length <= (baseline is null ? 0 : 2))
    files.AddRange([Path.Combine(data, "px4-flight.tlog"), Path.Combine(data, "golden.jsonl")]);

MeasurementEffort effort = isQuick ? MeasurementEffort.Quick : MeasurementEffort.Full;
Console.WriteLine($"{RuntimeName.Text} {Environment.Version}, one core, best of {effort.Passes} passes in turn");
bool isGood = true;
foreach (string file in files)
{
    var set = FrameSet.Load(file);
    var table = new SpeedTable(set, effort, baseline is null ? null : new CBaseline(baseline, set));
    isGood &= table.Print(Console.Out) || !isQuick;
}

return isGood ? 0 : 1;
