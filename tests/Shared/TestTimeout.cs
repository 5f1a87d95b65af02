using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading;
using System.Threading.Tasks;

namespace Rabit.Tests.Shared;

/// <summary>
/// How long a test waits for what must come; only one that fails waits to the end. On a machine that is busy with other
/// things the run gets its share of the processors only, and the test waits as much longer.
/// </summary>
internal sealed class TestTimeout
{
    // What a process gets where so many want to run: beyond that nothing is waited for.
    private const double MaxShares = 50;

    private static readonly TimeSpan OnAnIdleMachine = TimeSpan.FromSeconds(20);
    private static readonly TimeSpan Turn = TimeSpan.FromMilliseconds(20);

    // The load changes slowly, and some tests ask millions of times.
    private static readonly TimeSpan ReadAgainAfter = TimeSpan.FromMilliseconds(500);
    private static readonly Stopwatch Clock = Stopwatch.StartNew();
    private static Reading _latest = new(default, ReadShares());   // replaced whole

    private readonly ManualResetEventSlim _never = new();
    private readonly long _maxTurns;
    private readonly Func<double> _shares;
    private int _turns;
    private bool _isOver;   // stays: the load may rise later, and what was waited for was given up
    private TimeSpan _turnBegan = Clock.Elapsed;

    public TestTimeout()
        : this(OnAnIdleMachine)
    {
    }

    /// <param name="onAnIdleMachine">How long, for what takes longer than usual.</param>
    public TestTimeout(TimeSpan onAnIdleMachine)
        : this(onAnIdleMachine, Shares)
    {
    }

    /// <param name="onAnIdleMachine">How long.</param>
    /// <param name="shares">How many times as long by the load of just now, at least 1.</param>
    internal TestTimeout(TimeSpan onAnIdleMachine, Func<double> shares)
    {
        _maxTurns = onAnIdleMachine.Ticks / Turn.Ticks;
        _shares = shares;
    }

    /// <summary>For a wait in one piece.</summary>
    public static TimeSpan Limit => LimitOf(OnAnIdleMachine);

    /// <summary>As <see cref="Limit"/>, for what takes longer than usual.</summary>
    public static TimeSpan LimitOf(TimeSpan onAnIdleMachine)
        => TimeSpan.FromTicks((long)(onAnIdleMachine.Ticks * Shares()));

    /// <summary>
    /// Waits a turn under a lock, or less, where a pulse ends it. Pulses cost a turn only where a whole one has passed:
    /// what changes for ever, and never to what is awaited, does not wait for ever.
    /// </summary>
    /// <returns>False when the time is over.</returns>
    public bool TryWait(object gate)
        => (Monitor.Wait(gate, Turn) && Clock.Elapsed - _turnBegan < Turn) || TakeTurn();

    /// <summary>Waits a turn.</summary>
    /// <returns>False when the time is over.</returns>
    public bool TryWait()
    {
        _never.Wait(Turn);
        return TakeTurn();
    }

    /// <inheritdoc cref="TryWait()"/>
    public async Task<bool> TryWaitAsync()
    {
        await Task.Delay(Turn);
        return TakeTurn();
    }

    private bool TakeTurn()
    {
        _turnBegan = Clock.Elapsed;
        _isOver |= ++_turns >= _maxTurns * _shares();
        return !_isOver;
    }

    private static double Shares()
    {
        Reading reading = Volatile.Read(ref _latest);
        TimeSpan now = Clock.Elapsed;
        if (now - reading.Time > ReadAgainAfter)
            Volatile.Write(ref _latest, reading = new Reading(now, ReadShares()));
        return reading.Shares;
    }

    // Who wants to run, on average and just now, for each processor; 1 where the system does not say.
    private static double ReadShares()
    {
        const string Load = "/proc/loadavg";   // "0.20 0.18 0.12 1/80 11206"
        if (!File.Exists(Load))
            return 1;
        string[] words = File.ReadAllText(Load).Split(' ', '/');
        double average = double.Parse(words[0], CultureInfo.InvariantCulture);
        double running = double.Parse(words[3], CultureInfo.InvariantCulture);
        return Math.Min(Math.Max(1, Math.Max(average, running) / Environment.ProcessorCount), MaxShares);
    }

    private sealed class Reading(TimeSpan time, double shares)
    {
        public TimeSpan Time => time;

        public double Shares => shares;
    }
}
