#:property PublishAot=false
// a program of one file, run as "dotnet run eng/compare-groups.cs", is named after what it does
#pragma warning disable MA0048

// Compares the logs of one simulated group flown under two runtimes: each vehicle takes the same decisions, at the same
// times to a second. (A last bit that differs is a trailing zero byte more in a frame, so that it arrives some
// microseconds later, and is handled a tick later; goals are commanded once more or less by that, and managers run so:
// neither is compared.)
// Usage: dotnet run eng/compare-groups.cs -- A.log B.log
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

const double SecondsApart = 1.0001;
const string Line = @"^(?<vehicle>vehicle \d+): +(?<seconds>\d+\.\d+) (?<text>.*)$";
const string Number = @"-?\d+\.\d+";

Dictionary<string, List<double>> a = Decisions(args[0]);
Dictionary<string, List<double>> b = Decisions(args[1]);
var faults = new List<string>();
foreach (string decision in a.Keys.Union(b.Keys, StringComparer.Ordinal).Order(StringComparer.Ordinal))
{
    List<double> first = a.GetValueOrDefault(decision, []);
    List<double> second = b.GetValueOrDefault(decision, []);
    bool areAlike = first.Count == second.Count
        && first.Zip(second).All(p => Math.Abs(p.First - p.Second) < SecondsApart);
    if (!areAlike)
        faults.Add($"{decision}: {Text(first)} and {Text(second)}");
}

foreach (string fault in faults.Take(20))
    Console.WriteLine(fault);
int decisions = a.Values.Sum(d => d.Count);
Console.WriteLine($"{decisions} decisions of {args[0]} compared, {faults.Count} differ");
return faults.Count == 0 && decisions > 0 ? 0 : 1;

static Dictionary<string, List<double>> Decisions(string file)
{
    var decisions = new Dictionary<string, List<double>>(StringComparer.Ordinal);
    foreach (Match line in File.ReadLines(file).Select(l => Regex.Match(l, Line)).Where(m => m.Success))
    {
        string text = Regex.Replace(line.Groups["text"].Value, Number, "#");
        if (Regex.IsMatch(text, @": (command \d|Ended, \d)"))
            continue;
        string decision = $"{line.Groups["vehicle"]}: {text}";
        if (!decisions.TryGetValue(decision, out List<double>? times))
            decisions[decision] = times = [];
        times.Add(double.Parse(line.Groups["seconds"].Value, CultureInfo.InvariantCulture));
    }

    return decisions;
}

static string Text(List<double> times)
    => times.Count == 0
        ? "never"
        : string.Join(", ", times.Select(t => t.ToString("0.0", CultureInfo.InvariantCulture)));
