using System;
using System.Globalization;
using System.IO;
using Rabit.Core.Time;

namespace Rabit.Core.Diagnostics;

/// <summary>
/// Faults and hangs of a run whose user gave no log, on standard error: one line each, at most so many at once and one
/// a second from then on. Any thread.
/// </summary>
/// <remarks>
/// The one place of the library that writes to the console (docs/decisions/0018-faults-on-standard-error.md).
/// </remarks>
internal sealed class StandardErrorLog(string run, TimeProvider clock, Func<TextWriter> standardError)
{
    /// <summary>Room for the first fault of several managers, and far below what the buffer of a pipe holds.</summary>
    public const int MaxAtOnce = 10;

    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    private readonly RunClock _clock = new(clock);
    private readonly object _gate = new();
    private int _left = MaxAtOnce;      // all three under _gate
    private TimeSpan _refilledAt;
    private long _withheld;

    /// <summary>On the standard error of this process. The rate is by real time, also where that of the run is virtual.
    /// </summary>
    public StandardErrorLog(string run)
        : this(run, TimeProvider.System, StandardError)
    {
    }

    public static bool Takes(RabitLogKind kind) => kind is RabitLogKind.Fault or RabitLogKind.Hang;

    public void Write(RabitLogEntry entry)
    {
        long withheld;
        lock (_gate)
        {
            if (!TryTake())
            {
                _withheld++;
                return;
            }

            withheld = _withheld;
            _withheld = 0;
        }

        ReportWithheld(withheld);
        string place = entry.Exception is { } exception ? ExceptionText.PlaceOf(exception) : string.Empty;
        Put(string.Format(
            CultureInfo.InvariantCulture, "{0:0.000} s, {1}: {2}{3}", entry.Time.TotalSeconds, entry.Source, entry.Text,
            place.Length == 0 ? place : " (" + place + ")"));
    }

    /// <summary>The run is over: says what was withheld and not reported yet.</summary>
    public void Close()
    {
        long withheld;
        lock (_gate)
        {
            withheld = _withheld;
            _withheld = 0;
        }

        ReportWithheld(withheld);
    }

    private bool TryTake()
    {
        TimeSpan now = _clock.Now;
        long intervals = (now - _refilledAt).Ticks / Interval.Ticks;
        if (intervals > 0)
        {
            _left = (int)Math.Min(MaxAtOnce, _left + intervals);
            _refilledAt = now;
        }

        if (_left == 0)
            return false;
        _left--;
        return true;
    }

    private void ReportWithheld(long count)
    {
        if (count > 0)
            Put(FormattableString.Invariant($"{count} more faults and hangs are not shown"));
    }

    private void Put(string line)
    {
        try
        {
            standardError().WriteLine(run + ": " + OneLine.Of(line));
        }
        catch (Exception)
        {
            // A closed terminal, a full disk: there is nowhere left to report it, and the result has every fault.
        }
    }

#pragma warning disable RS0030 // See the remarks.
    private static TextWriter StandardError() => Console.Error;
#pragma warning restore RS0030
}
