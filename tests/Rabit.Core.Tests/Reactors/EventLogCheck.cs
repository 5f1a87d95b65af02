using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;

namespace Rabit.Core.Tests.Reactors;

/// <summary>
/// Whether an event log is that of a legal run, whatever the order among equals: time does not go back, versions count
/// by one, the counters of queues balance, no manager runs without a reason, and every wake is followed by a run at the
/// same instant. For runs without modelled durations.
/// </summary>
internal sealed class EventLogCheck
{
    private readonly List<string> _faults = [];
    private readonly Dictionary<string, int> _versions = new(StringComparer.Ordinal);
    private readonly Dictionary<string, long> _holds = new(StringComparer.Ordinal);
    private readonly Dictionary<string, string> _woken = new(StringComparer.Ordinal);
    private string _now = string.Empty;
    private double _seconds;
    private bool _stops;

    public static IReadOnlyList<string> FindFaults(string log)
    {
        var check = new EventLogCheck();
        foreach (string line in log.Split(['\n'], StringSplitOptions.RemoveEmptyEntries))
            check.Read(line);
        return check._faults;
    }

    private void Read(string line)
    {
        Match match = Regex.Match(
            line, @"^ *(?<time>\d+\.\d{7}) (?<who>[^:]+): (?<what>.+)$", RegexOptions.CultureInvariant,
            TimeSpan.FromSeconds(10));
        if (!match.Success)
        {
            _faults.Add("no line of an event log: " + line);
            return;
        }

        string time = match.Groups["time"].Value, who = match.Groups["who"].Value, what = match.Groups["what"].Value;
        if (!string.Equals(time, _now, StringComparison.Ordinal))
            MoveTo(time);
        _stops |= what.StartsWith("stops", StringComparison.Ordinal);
        if (what.StartsWith("runs (", StringComparison.Ordinal))
            Run(who, what.Substring(6).Split(')', ';')[0]);
        else if (what.StartsWith("wakes ", StringComparison.Ordinal))
            _woken[what.Substring(6, what.IndexOf(" (", StringComparison.Ordinal) - 6)] = line;
        else if (what.StartsWith("posts ", StringComparison.Ordinal))
            Post(what.Substring(6));
        else if (what.StartsWith("queue ", StringComparison.Ordinal))
            Queue(what.Substring(6));
    }

    private void MoveTo(string time)
    {
        double seconds = double.Parse(time, CultureInfo.InvariantCulture);
        if (seconds < _seconds)
            _faults.Add($"time goes back to {time}");
        if (!_stops)
            _faults.AddRange(_woken.Values.Select(line => "no run for: " + line));
        _woken.Clear();
        _seconds = seconds;
        _now = time;
    }

    private void Run(string who, string causes)
    {
        bool wasWoken = _woken.Remove(who);
        bool hasTimer = causes.Contains("Timer", StringComparison.Ordinal)
            || causes.Contains("Start", StringComparison.Ordinal);
        if (!wasWoken && !hasTimer)
            _faults.Add($"{who} is woken by {causes} at {_now}, without a wake-up");
    }

    private void Post(string what)
    {
        string[] parts = what.Split([", version ", ", true at "], StringSplitOptions.None);
        int version = int.Parse(parts[1], CultureInfo.InvariantCulture);
        _versions.TryGetValue(parts[0], out int before);
        if (version != before + 1)
            _faults.Add($"{parts[0]} has version {version} after {before}");
        _versions[parts[0]] = version;
    }

    private void Queue(string what)
    {
        string name = what.Substring(0, what.IndexOf(": ", StringComparison.Ordinal));
        _holds.TryGetValue(name, out long holds);
        foreach (string part in what.Substring(name.Length + 2).Split([", "], StringSplitOptions.None))
        {
            string[] words = part.Split(' ');
            switch (words[1])
            {
                case "pushed":
                    holds += long.Parse(words[0], CultureInfo.InvariantCulture);
                    break;
                case "popped" or "dropped":
                    holds -= long.Parse(words[0], CultureInfo.InvariantCulture);
                    break;
                default:
                    if (string.Equals(words[0], "holds", StringComparison.Ordinal)
                        && holds != long.Parse(words[1], CultureInfo.InvariantCulture))
                        _faults.Add($"queue {name} holds {words[1]} at {_now}, by its counters {holds}");
                    break;
            }
        }

        _holds[name] = holds;
    }
}
