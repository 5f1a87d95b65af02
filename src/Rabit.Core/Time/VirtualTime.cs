using System;
using System.Collections.Generic;
using Rabit.Core.Reactors;

namespace Rabit.Core;

/// <summary>
/// Virtual time: the same managers, unchanged, take turns on one thread under a clock that jumps to the next thing to do.
/// Who goes first among equals is fixed by the seed: one seed, one run, to the byte; another seed, another legal order.
/// </summary>
/// <remarks>
/// Configure before the start; after that read only. A wake, post, push or stop from a thread that is not the run's own is
/// taken between turns and lies outside that promise. One instance serves one reactor.
/// </remarks>
public sealed class VirtualTime : RabitTime
{
    private readonly VirtualClock _clock;
    private readonly Dictionary<string, UnitOfWorkDurations> _durations = new(StringComparer.Ordinal);
    private double _pace = double.PositiveInfinity;
    private int _maximumRunsPerInstant = 10_000;
    private bool _isUsed;

    /// <summary>Virtual time that starts on 1 January 2000, UTC.</summary>
    /// <param name="seed">Fixes the order among managers that could run at the same instant.</param>
    public VirtualTime(long seed = 0)
        : this(seed, new DateTimeOffset(2000, 1, 1, 0, 0, 0, TimeSpan.Zero))
    {
    }

    /// <summary>Virtual time that starts at a chosen wall time, for example that of the first record of a log.</summary>
    /// <param name="seed">Fixes the order among managers that could run at the same instant.</param>
    /// <param name="startUtc">What the wall clock says at the start.</param>
    public VirtualTime(long seed, DateTimeOffset startUtc)
    {
        Seed = seed;
        _clock = new VirtualClock(startUtc);
    }

    /// <summary>Fixes the order among equals.</summary>
    public long Seed { get; }

    /// <summary>How many virtual seconds pass in a real one at most; by default as many as the machine can (infinity).</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not above zero.</exception>
    public double Pace
    {
        get => _pace;
        set => _pace = value > 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The pace of virtual time must be above zero.");
    }

    /// <summary>
    /// How many turns may be taken at one instant before the run stops with an error that names the managers: two that
    /// wake each other for ever would freeze the clock. 10 000 by default.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Not above zero.</exception>
    public int MaximumRunsPerInstant
    {
        get => _maximumRunsPerInstant;
        set => _maximumRunsPerInstant = value > 0
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "At least one run must be allowed at an instant.");
    }

    /// <inheritdoc/>
    public override TimeProvider Clock => _clock;

    internal override bool AllowsBlocking => false;

    internal VirtualClock VirtualClock => _clock;

    /// <summary>
    /// Models how long each unit of work of a manager takes. Without it a unit of work takes no time. What it posts and
    /// pushes is there at its beginning; the manager is busy, and keeps its wakes, until its end.
    /// </summary>
    /// <param name="managerName">The manager; a name that no manager has is an error at the start.</param>
    /// <param name="duration">Zero or longer.</param>
    public void SetUnitOfWorkDuration(string managerName, TimeSpan duration)
    {
        if (duration < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(duration), duration, $"Manager '{managerName}': a unit of work cannot take less than no time.");
        DurationsFor(managerName).Usual = duration;
    }

    /// <summary>
    /// Models one unit of work that takes longer than the others: the first one that begins at a time or later. The watchdog finds it
    /// (<see cref="HangPolicy"/>) when it takes longer than its limit.
    /// </summary>
    /// <param name="managerName">The manager; a name that no manager has is an error at the start.</param>
    /// <param name="at">When, by the clock of the run.</param>
    /// <param name="duration">How long it takes; <see cref="TimeSpan.MaxValue"/> for one that never comes back.</param>
    /// <exception cref="ArgumentOutOfRangeException">A time is negative.</exception>
    public void AddLongUnitOfWork(string managerName, TimeSpan at, TimeSpan duration)
    {
        if (at < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(at), at, $"Manager '{managerName}': a run begins at no time.");
        if (duration < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(duration), duration, $"Manager '{managerName}': a unit of work cannot take less than no time.");
        DurationsFor(managerName).Add(at, duration);
    }

    /// <summary>Whose units of work take time.</summary>
    internal IEnumerable<string> ModelledManagers => _durations.Keys;

    internal UnitOfWorkDurations? DurationsOf(string managerName) => _durations.TryGetValue(managerName, out UnitOfWorkDurations? found) ? found : null;

    internal TimeSpan LongestUnitOfWork(string managerName) => DurationsOf(managerName)?.Longest ?? TimeSpan.Zero;

    internal override ReactorEngine CreateEngine(EngineContext context)
    {
        if (_isUsed)
            throw new InvalidOperationException("This virtual time has a reactor already; its clock cannot serve two.");
        _isUsed = true;
        return new VirtualEngine(this, context);
    }

    private UnitOfWorkDurations DurationsFor(string managerName)
    {
        string name = Require.Name(managerName, nameof(managerName), "A manager");
        if (!_durations.TryGetValue(name, out UnitOfWorkDurations? durations))
            _durations.Add(name, durations = new UnitOfWorkDurations());
        return durations;
    }
}
